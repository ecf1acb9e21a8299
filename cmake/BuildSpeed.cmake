# Makes builds faster with what happens to be installed. Nothing here is needed, and nothing changes what is built.

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

# A linker faster than the usual one.
include(CheckLinkerFlag)
foreach(linker mold lld)
  check_linker_flag(CXX "-fuse-ld=${linker}" FETTLE_LINKS_WITH_${linker})
  if(FETTLE_LINKS_WITH_${linker})
    add_link_options("-fuse-ld=${linker}")
    break()
  endif()
endforeach()
