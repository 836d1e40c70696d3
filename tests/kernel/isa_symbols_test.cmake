# cmake -D NM=... -D OBJECTS=... -P isa_symbols_test.cmake
#
# The files of src/kernel/isa/ for newer processors must not define a function that other files define
# as well: the linker keeps one copy of an inline function, and it could be that one, which older
# processors cannot run. So whatever they define weakly names lanes of their own instruction set.
set(checked 0)
foreach(object IN LISTS OBJECTS)
  if(NOT object MATCHES "/isa/(avx[0-9]*)\\.cpp\\.o(bj)?$")
    continue()
  endif()
  set(isa ${CMAKE_MATCH_1})
  math(EXPR checked "${checked} + 1")
  execute_process(COMMAND ${NM} -C --defined-only ${object}
    OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${NM} cannot read ${object}")
  endif()
  string(REPLACE ";" "," symbols "${symbols}")
  string(REPLACE "\n" ";" symbols "${symbols}")
  set(shared "")
  foreach(symbol IN LISTS symbols)
    # W: weak functions. Data may be shared: it is the same for all processors.
    if(symbol MATCHES "^[0-9a-f]+ W (.*)$")
      set(name "${CMAKE_MATCH_1}")
      if(NOT name MATCHES "candela::kernel::${isa}::")
        string(APPEND shared "\n  ${name}")
      endif()
    endif()
  endforeach()
  if(shared)
    message(SEND_ERROR "isa/${isa}.cpp defines what other files may share:${shared}")
  endif()
endforeach()
if(checked EQUAL 0)
  message(FATAL_ERROR "no object file of an instruction set among ${OBJECTS}")
endif()
message(STATUS "${checked} object files share nothing")
