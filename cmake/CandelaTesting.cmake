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

# candela_add_test(NAME [LABELS ...] [SLOW] COMMAND ...)
# One entry of ctest; its full name is left in `test`. SLOW: it has the label `slow` and is run by
# `ctest -C slow` only.
function(candela_add_test name)
  cmake_parse_arguments(ARG "SLOW" "" "LABELS;COMMAND" ${ARGN})
  set(test ${name})
  if(NOT stage STREQUAL dev)
    set(test ${stage}.${name})
  endif()
  set(test ${test} PARENT_SCOPE)
  set(when)
  set(timeout 600)
  if(ARG_SLOW)
    list(APPEND ARG_LABELS slow)
    set(when CONFIGURATIONS slow)
    set(timeout 3000)
  endif()
  add_test(NAME ${test} COMMAND ${ARG_COMMAND} ${when} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${test} PROPERTIES LABELS "${stage};${ARG_LABELS}" TIMEOUT ${timeout})
  if(ARG_SLOW)
    set_tests_properties(${test} PROPERTIES COST 300)  # The longest tests start first.
  endif()
endfunction()

# Headers that most tests include, read once instead of once for each file. The stage dev does without, so
# that a file that does not include what it needs is noticed.
find_package(GTest REQUIRED)
if(CANDELA_PRECOMPILE)
  set(empty_source ${PROJECT_BINARY_DIR}/test_headers.cpp)
  if(NOT EXISTS ${empty_source})
    file(WRITE ${empty_source} "")
  endif()
  add_library(candela_test_headers OBJECT ${empty_source})
  target_link_libraries(candela_test_headers PRIVATE candela_flags GTest::gmock)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    # Else clang refuses it after an update of the system that leaves the headers as long as they were, but
    # with other times. After one that changes them, the build has to be made anew.
    target_compile_options(candela_test_headers PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
  target_precompile_headers(candela_test_headers PRIVATE
    <algorithm> <cmath> <filesystem> <gmock/gmock.h> <gtest/gtest.h> <memory> <span> <string> <vector>)
endif()

# candela_test(NAME SOURCES ... LINK ... [LABELS ...] [COST seconds] [MAY_SKIP] [WITH_SLOW])
# One GoogleTest program, one entry of ctest. LINK names the folders under test. The label `threads`
# marks what the thread sanitizer should see; its build has only those. COST: about how long it takes, for
# those that should start first. MAY_SKIP: ctest lists the program as not run when its tests skip
# themselves, which they do all together or not at all. WITH_SLOW: the stage dev has a second program of the
# same files, NAME with `slow_` before `test`, for the slow set. tests/support/effort.h tells a program which
# of all these it is.
function(candela_test name)
  cmake_parse_arguments(ARG "MAY_SKIP;WITH_SLOW" "COST" "SOURCES;LINK;LABELS" ${ARGN})
  if(stage STREQUAL tsan AND NOT threads IN_LIST ARG_LABELS)
    return()
  endif()
  candela_test_program(${name} SOURCES ${ARG_SOURCES} LINK ${ARG_LINK})
  candela_add_test(${name} LABELS ${ARG_LABELS} COMMAND ${name})
  if(ARG_COST)
    set_tests_properties(${test} PROPERTIES COST ${ARG_COST})
  endif()
  if(ARG_MAY_SKIP)
    set_tests_properties(${test} PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  endif()
  if(ARG_WITH_SLOW AND stage STREQUAL dev)
    string(REGEX REPLACE "test$" "slow_test" slow ${name})
    candela_test_program(${slow} SOURCES ${ARG_SOURCES} LINK ${ARG_LINK})
    target_compile_definitions(${slow} PRIVATE CANDELA_SLOW)
    candela_add_test(${slow} LABELS ${ARG_LABELS} SLOW COMMAND ${slow})
  endif()
endfunction()

function(candela_test_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE candela_flags ${ARG_LINK} GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
  if(CANDELA_PRECOMPILE)
    target_precompile_headers(${name} REUSE_FROM candela_test_headers)
  endif()
  if(NOT stage STREQUAL dev)
    target_compile_definitions(${name} PRIVATE CANDELA_SANITIZED)
  endif()
endfunction()
