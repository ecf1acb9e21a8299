# Makes builds faster. Nothing here is needed, and nothing changes what is built.

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

# A compiler cache. With precompiled headers it has to trust that their macros have not changed meanwhile.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(FETTLE_CCACHE ccache)
  if(FETTLE_CCACHE)
    set(launcher "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${FETTLE_CCACHE}")
    set(CMAKE_C_COMPILER_LAUNCHER "${launcher}")
    set(CMAKE_CXX_COMPILER_LAUNCHER "${launcher}")
  endif()
endif()

# Several sources in one go: what they all read and instantiate is compiled once for all of them. The preset `clang`
# compiles each alone, so every source still includes what it uses.
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()

# A linker faster than the usual one.
include(CheckLinkerFlag)
foreach(linker mold lld)
  check_linker_flag(CXX "-fuse-ld=${linker}" FETTLE_LINKS_WITH_${linker})
  if(FETTLE_LINKS_WITH_${linker})
    add_link_options("-fuse-ld=${linker}")
    break()
  endif()
endforeach()
