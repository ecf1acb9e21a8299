# Flags every part is built with: `fettle_compile_options(TARGET)` keeps them in one place.

include(BuildSpeed)

# Warnings are errors where `check` tries that with the very compiler: these releases of Debian no longer change. `play` then
# compiles with the flags of `check`, so that each of the two uses what the other has built.
set(werror OFF)
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12
   AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
  set(werror ON)
endif()
option(FETTLE_WERROR "Treat warnings as errors" ${werror})
set(FETTLE_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

function(fettle_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    # The same results from every compiler and instruction set: the compiler must not make fused multiply-adds.
    -ffp-contract=off
    # -O3, the default of CMake, takes a sixth longer to compile. A step of physics has it, and fettle_hot_sources.
    $<$<CONFIG:Release>:-O$<IF:$<BOOL:$<TARGET_PROPERTY:FETTLE_OPTIMIZATION>>,$<TARGET_PROPERTY:FETTLE_OPTIMIZATION>,2>>)
  # GCC 12 to 14 warn of overlaps and overflows that do not exist where texts are joined to a std::string (bugs 105651 and
  # 105329 of GCC). Builds with clang and with later releases have these warnings.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
  # Of sources that are compiled together, clang also warns where a local name of one is in an anonymous namespace of another.
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_UNITY_BUILD)
    target_compile_options(${target} PRIVATE -Wno-shadow)
  endif()
  # GCC 12.4, 13.3 and 14.2 take a function for one that reads no memory if a function that is inlined into it reads through a
  # pointer, the pointer is a member of an argument, and what is read may be anything: characters, or all types at -O1. Then they
  # leave out what was written for it: an array that is passed as a std::span is not filled. GCC 12.2, 13.5, 14.4 and 16 do not.
  # Without this analysis, GCC warns of variables that might be uninitialized and are not. The other builds have this warning.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12.3
     AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14.3)
    target_compile_options(${target} PRIVATE -fno-ipa-modref -Wno-maybe-uninitialized)
  endif()
  # With -fipa-ra, GCC assumes that a call of an inline function changes only the registers that the copy in the same file
  # changes. On Windows the linker may use the copy of another file, which was compiled with other optimization and changes
  # other registers.
  if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fno-ipa-ra)
  endif()
  if(FETTLE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FETTLE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${FETTLE_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    # In instrumented code GCC gives false warnings about uninitialized values. The other builds have this warning.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${FETTLE_SANITIZE})
  endif()
endfunction()

# For code that mostly calls other libraries: -O1 takes an eighth to a third less time to compile than -O2.
# The few functions of such a target that a game calls very often are named with fettle_hot_sources.
function(fettle_optimize_little target)
  set_target_properties(${target} PROPERTIES FETTLE_OPTIMIZATION 1)
endfunction()

# For code that runs rarely, or a few hundred times a frame: -Og takes a sixth to a quarter less time to compile than -O1, and what
# draws every frame would take a quarter longer.
function(fettle_optimize_least target)
  set_target_properties(${target} PROPERTIES FETTLE_OPTIMIZATION g)
endfunction()

# Files whose functions a game calls ten thousand times a frame: optimized fully, also in a target that is optimized little.
# Their alignment in the instruction cache changes the time of such a call by a twentieth; without this it would depend on
# the code that is linked before them.
function(fettle_hot_sources)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS
    "$<$<CONFIG:Release>:-O3>" "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-falign-functions=64>")
  # The precompiled header of the target was made with other flags.
  set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
endfunction()
