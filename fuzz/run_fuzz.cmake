# Runs PROGRAM on RUNS inputs grown from the seeds in CORPUS. Inputs that crash it stay in WORK/crashes;
# new seeds that it finds go to a folder that starts empty, so every run is the same: where the system
# lets a program have the same addresses each time, by which libFuzzer tells comparisons apart.
file(GLOB seeds ${CORPUS}/*)
if(NOT seeds)
  message(FATAL_ERROR "no seeds in ${CORPUS}")
endif()
file(REMOVE_RECURSE ${WORK}/found)
file(MAKE_DIRECTORY ${WORK}/found ${WORK}/crashes)
if(MAX_LENGTH)
  set(length -max_len=${MAX_LENGTH})
endif()
if(EXISTS ${WORDS})
  set(words -dict=${WORDS})
endif()
set(same_addresses setarch -R)
execute_process(COMMAND ${same_addresses} true RESULT_VARIABLE refused OUTPUT_QUIET ERROR_QUIET)
if(refused)
  message(STATUS "addresses are random here, and so are the inputs")
  set(same_addresses "")
endif()
execute_process(
  COMMAND ${same_addresses} ${PROGRAM} -runs=${RUNS} -seed=1 ${length} ${words} -timeout=10 -rss_limit_mb=2048
          -malloc_limit_mb=1024 -print_final_stats=1 -reload=0
          -artifact_prefix=${WORK}/crashes/ ${WORK}/found ${CORPUS}
  COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
