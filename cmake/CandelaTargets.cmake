# How every target is compiled, said once.

add_library(candela_flags INTERFACE)
set_target_properties(candela_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(candela_flags INTERFACE cxx_std_20)
# Contraction would make results depend on the compiler; see docs/architecture.md, section 5.
target_compile_options(candela_flags INTERFACE -ffp-contract=off)
# These change no result: nobody asks for errno or for floating-point exceptions, and nobody replaces a
# function of the libraries at run time.
target_compile_options(candela_flags INTERFACE
  $<BUILD_INTERFACE:-fno-math-errno -fno-trapping-math -fno-semantic-interposition>)
# GCC 12 drops the rounding to float of two neighbouring numbers that go from double to float and back
# when it turns straight code into vector code. tests/math holds the case.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(candela_flags INTERFACE -fno-tree-slp-vectorize)
endif()
target_compile_options(candela_flags INTERFACE
  $<BUILD_INTERFACE:-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wimplicit-fallthrough>)
# GCC 12 sees overlapping copies in the addition of strings where there are none (its bug 105651).
target_compile_options(candela_flags INTERFACE
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>)
if(CANDELA_WERROR)
  target_compile_options(candela_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(CANDELA_SANITIZE)
  target_compile_options(candela_flags INTERFACE
    $<BUILD_INTERFACE:-fsanitize=${CANDELA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer>)
  target_link_options(candela_flags INTERFACE $<BUILD_INTERFACE:-fsanitize=${CANDELA_SANITIZE}>)
endif()
if(CANDELA_FUZZ)
  # The fuzzer is led by the branches it sees taken, so the libraries report theirs.
  target_compile_options(candela_flags INTERFACE $<BUILD_INTERFACE:-fsanitize=fuzzer-no-link>)
endif()

# candela_library(NAME SOURCES ... LINK ... [PRIVATE_LINK ...])
# One folder of src/. LINK names the folders it may include, and is the layering.
function(candela_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(candela_${name} STATIC ${ARG_SOURCES})
  add_library(Candela::${name} ALIAS candela_${name})
  set_target_properties(candela_${name} PROPERTIES
    EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(candela_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:include/candela>)
  target_link_libraries(candela_${name} PUBLIC candela_flags ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
  set_property(GLOBAL APPEND PROPERTY CANDELA_LIBRARIES candela_${name})
endfunction()

# candela_program(NAME SOURCES ... LINK ...)
# One program of apps/. `cmake ..` and the release preset leave it in the repository root.
function(candela_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/apps)
  target_link_libraries(${name} PRIVATE candela_flags ${ARG_LINK})
  if(CANDELA_ROOT_EXECUTABLES)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_SOURCE_DIR})
  endif()
  install(TARGETS ${name} RUNTIME)
endfunction()
