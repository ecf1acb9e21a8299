# Runs the window example in a virtual display: with the console open, the file of its picture is much larger.
file(MAKE_DIRECTORY "${FOLDER}")
foreach(console closed open)
  execute_process(COMMAND "${XVFB_RUN}" -a -s "-screen 0 1280x800x24 -noreset" "${WINDOW}" 60 ${console}
    WORKING_DIRECTORY "${FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
  file(SIZE "${FOLDER}/window.png" ${console})
  file(RENAME "${FOLDER}/window.png" "${FOLDER}/${console}.png")
endforeach()
message("closed: ${closed} bytes, open: ${open} bytes")
math(EXPR much "3 * ${closed}")
if(open LESS much)
  message(FATAL_ERROR "the console does not show")
endif()
