# Flags every part is built with: `fettle_compile_options(TARGET)` keeps them in one place.

include(BuildSpeed)

option(FETTLE_WERROR "Treat warnings as errors" OFF)
set(FETTLE_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

function(fettle_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    # The same figures from every compiler and instruction set: no fused multiply-add behind our back.
    -ffp-contract=off)
  # GCC 12 sees overlaps and overflows where short texts are joined to a std::string (its bugs 105651 and 105329); the
  # builds with clang and with later releases have these warnings.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
  endif()
  if(FETTLE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FETTLE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${FETTLE_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    # GCC's data flow warnings go wrong in instrumented code; the other builds have them.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${FETTLE_SANITIZE})
  endif()
endfunction()

# For code that runs rarely, or that mostly calls other libraries: -O1 compiles in little more than half the time of -O3.
function(fettle_optimize_little target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  set_target_properties(${target} PROPERTIES FETTLE_OPTIMIZED_LITTLE ON)
endfunction()

# Files whose functions a game calls ten thousand times a frame. Where they begin in a line of the
# instruction cache is worth a twentieth of such a call, and would change with whatever is linked before them.
function(fettle_hot_sources)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-falign-functions=64>")
  # clang takes no precompiled header that was made with another alignment.
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()
