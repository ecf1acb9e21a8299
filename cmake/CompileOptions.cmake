# Flags every part is built with. `fettle_library(NAME FOLDER_INCLUDE SOURCES...)` and
# `fettle_compile_options(TARGET)` keep them in one place.

option(FETTLE_WERROR "Treat warnings as errors" OFF)
set(FETTLE_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

function(fettle_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    # The same figures from every compiler and instruction set: no fused multiply-add behind our back.
    -ffp-contract=off)
  if(FETTLE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FETTLE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${FETTLE_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${FETTLE_SANITIZE})
  endif()
endfunction()
