# Installs BUILD into a fresh prefix below WORK, then configures, builds and runs EXAMPLE against it.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${EXAMPLE} -B ${WORK}/build -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} -E chdir ${WORK} build/embed)

# A lit sphere is not one colour: the picture of an empty scene compresses to a tenth of this.
file(SIZE ${WORK}/embed.png size)
if(size LESS 3000)
  message(FATAL_ERROR "embed.png has ${size} bytes: the sphere is missing")
endif()
