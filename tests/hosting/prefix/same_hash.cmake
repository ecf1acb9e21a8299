# Compares the state hashes of a heap of bodies in four runs: with physics linked in or loaded as a module, and without or with
# going back in time. Prints the hash if all are equal.
file(WRITE "${FOLDER}/main.lua" [[
world.floor = Body { type = "static", position = vec(0, -1), Box { width = 40, height = 2 } }
for i = 0, 29 do
    world:add(Body { position = vec(0.7 * (i % 6) - 2, 1 + i // 6), (i % 2 == 0 and Box or Circle) {} })
end
past = false
]])
set(straight --steps 240)
set(restored --steps 360 --at "60:past = snapshot()" --at "120:world.gravity = vec(3, 4)" --at "180:restore(past)")
set(rewound --steps 330 --at "120:world.gravity = vec(3, 4)" --at "180:rewind(1.5)")
foreach(way IN ITEMS "" "--module;physics")
  foreach(course IN ITEMS straight restored rewound)
    execute_process(COMMAND "${FETTLE}" run "${FOLDER}" --headless --hash ${way} ${${course}}
      OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCH "[0-9a-f]+\n$" hash "${said}")
    list(APPEND hashes "${hash}")
  endforeach()
endforeach()
list(REMOVE_DUPLICATES hashes)
list(LENGTH hashes different)
if(NOT different EQUAL 1)
  message(FATAL_ERROR "the hashes of linked in and loaded physics, with and without going back, differ: ${hashes}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" -E echo_append "${hashes}")
