# The state hash of a game, with physics linked in and with physics plugged in: printed when they agree.
foreach(way IN ITEMS "" "--module;physics")
  execute_process(COMMAND "${FETTLE}" run "${GAME}" --headless --steps 240 --hash ${way}
    OUTPUT_VARIABLE said ERROR_VARIABLE problem COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "[0-9a-f]+\n$" hash "${said}")
  list(APPEND hashes "${hash}")
endforeach()
list(REMOVE_DUPLICATES hashes)
list(LENGTH hashes different)
if(NOT different EQUAL 1)
  message(FATAL_ERROR "linked in and plugged in differ: ${hashes}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" -E echo_append "${hashes}")
