# WebAssembly with SIMD128 and its own exceptions, from Debian's emscripten; programs run by node. Without threads: a world
# that asks for more works with one.
set(fettle_emscripten /usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
if(NOT EXISTS "${fettle_emscripten}")
  message(FATAL_ERROR "emscripten (Debian: emscripten) is needed; ${fettle_emscripten} is missing")
endif()
include("${fettle_emscripten}")
set(CMAKE_C_FLAGS_INIT -msimd128)
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1MB")
# The loader of Emscripten 3.1 takes any `fetch` for that of a browser.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
# Libraries of the machine that compiles have no place in the program.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
include("${CMAKE_CURRENT_LIST_DIR}/header_only.cmake")
