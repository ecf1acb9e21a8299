# Makes builds faster. Nothing here is needed, and nothing changes what is built.

# fettle_compile_together(VARIABLE PATTERN) moves the files of the list VARIABLE that have a line which matches PATTERN to its
# front, so that they are compiled in one go and what they include is instantiated once.
function(fettle_compile_together variable pattern)
  set(first "")
  set(others "")
  foreach(source IN LISTS ${variable})
    file(STRINGS "${source}" found REGEX "${pattern}" LIMIT_COUNT 1)
    if(found)
      list(APPEND first "${source}")
    else()
      list(APPEND others "${source}")
    endif()
  endforeach()
  set(${variable} ${first} ${others} PARENT_SCOPE)
endfunction()

# fettle_compile_apart(TARGET NAME SOURCE...): where several sources are compiled in one go, these are one such group, which becomes
# the object unity_NAME_*; the other sources of TARGET make groups of the usual size.
function(fettle_compile_apart target name)
  get_target_property(sources ${target} SOURCES)
  get_target_property(size ${target} UNITY_BUILD_BATCH_SIZE)
  if(NOT size)
    set(size 1000)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  set(number 0)
  foreach(source IN LISTS sources)
    if(source IN_LIST ARGN)
      set(group ${name})
    else()
      math(EXPR group "${number} / ${size}")
      math(EXPR number "${number} + 1")
    endif()
    set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# fettle_compile_in_small_groups(TARGET): for a library that is changed often and whose sources take long to optimize. After a
# change of one source half as much is compiled; to compile all takes at most a tenth more time.
function(fettle_compile_in_small_groups target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 9)
endfunction()

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

# Several sources in one go: what they all read and instantiate is compiled once for all of them. The preset `alone`
# has each alone, and clang-tidy reads it, so every source still includes what it uses.
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 18)
endif()

# GCC collects its garbage often unless it may use more memory first. With 512 MB it needs at most 60 MB more and a tenth less
# time.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()

# A faster linker, if one is installed. Not for cross builds: it may only link programs for this machine.
if(CMAKE_CROSSCOMPILING)
  return()
endif()
include(CheckLinkerFlag)
foreach(linker mold lld)
  check_linker_flag(CXX "-fuse-ld=${linker}" FETTLE_LINKS_WITH_${linker})
  if(FETTLE_LINKS_WITH_${linker})
    add_link_options("-fuse-ld=${linker}")
    break()
  endif()
endforeach()
