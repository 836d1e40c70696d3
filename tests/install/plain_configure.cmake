# Configures PROJECT in the fresh folder WORK as the course says, `cmake ..` and nothing else: that has to be
# a Release build without tests that leaves the programs in the root.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
load_cache(${WORK} READ_WITH_PREFIX plain_
  CMAKE_BUILD_TYPE CANDELA_ROOT_EXECUTABLES CANDELA_TESTS)
if(NOT plain_CMAKE_BUILD_TYPE STREQUAL Release OR NOT plain_CANDELA_ROOT_EXECUTABLES OR plain_CANDELA_TESTS)
  message(FATAL_ERROR "build type ${plain_CMAKE_BUILD_TYPE}, programs in the root: "
                      "${plain_CANDELA_ROOT_EXECUTABLES}, tests: ${plain_CANDELA_TESTS}")
endif()
