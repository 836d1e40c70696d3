# How tests are declared.
#
# One ctest may run the tests of several builds (scripts/test), so the names and labels of a sanitizer's
# build say which it is.
if(CANDELA_SANITIZE MATCHES "thread")
  set(stage tsan)
elseif(CANDELA_SANITIZE)
  set(stage asan)
else()
  set(stage dev)
endif()

# candela_add_test(NAME [LABELS ...] COMMAND ...)
# One entry of ctest; its full name is left in `test`.
function(candela_add_test name)
  cmake_parse_arguments(ARG "" "" "LABELS;COMMAND" ${ARGN})
  set(test ${name})
  if(NOT stage STREQUAL dev)
    set(test ${stage}.${name})
  endif()
  set(test ${test} PARENT_SCOPE)
  add_test(NAME ${test} COMMAND ${ARG_COMMAND} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${test} PROPERTIES LABELS "${stage};${ARG_LABELS}" TIMEOUT 600)
endfunction()

# candela_test(NAME SOURCES ... LINK ... [LABELS ...] [MAY_SKIP])
# One GoogleTest program, one entry of ctest. LINK names the folders under test. The label `threads`
# marks what the thread sanitizer should see; its build has only those. MAY_SKIP: ctest lists the program
# as not run when its tests skip themselves, which they do all together or not at all.
find_package(GTest REQUIRED)
function(candela_test name)
  cmake_parse_arguments(ARG "MAY_SKIP" "" "SOURCES;LINK;LABELS" ${ARGN})
  if(stage STREQUAL tsan AND NOT threads IN_LIST ARG_LABELS)
    return()
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE candela_flags ${ARG_LINK} GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
  candela_add_test(${name} LABELS ${ARG_LABELS} COMMAND ${name})
  if(ARG_MAY_SKIP)
    set_tests_properties(${test} PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  endif()
endfunction()
