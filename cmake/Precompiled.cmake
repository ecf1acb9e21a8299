# Precompiled headers: most of the time that a source of this project takes to compile goes into reading headers.
#
# Sources still include all that they use, so that each compiles alone too: the preset `alone` has no precompiled
# headers. A header that changes often does not belong here, since everything that uses it is compiled again.

# What nearly every source includes of the standard library.
set(fettle_common_headers <algorithm> <array> <cmath> <cstdint> <cstring> <functional> <limits> <memory> <optional> <span>
    <stdexcept> <string> <string_view> <unordered_map> <utility> <vector>)

# fettle_precompile(TARGET HEADER...) compiles the common headers and HEADER... once for TARGET.
function(fettle_precompile target)
  target_precompile_headers(${target} PRIVATE ${fettle_common_headers} ${ARGN})
endfunction()

# fettle_precompile_tree(TARGET): for a library on top of the property tree, after fettle_optimize_little(TARGET) or
# fettle_optimize_least(TARGET) if there is one. All of these share one precompiled header, those that are optimized little
# another one, and the least a third: it needs the very same flags for each, also those of the optimization. That is why it is
# made of fettle_compile_options and nothing else.
function(fettle_precompile_tree target)
  set(headers fettle_tree_headers)
  get_target_property(optimization ${target} FETTLE_OPTIMIZATION)
  if(optimization)
    string(APPEND headers "_O${optimization}")
  endif()
  if(NOT TARGET ${headers})
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/cmake/${headers}.cpp"
      CONTENT "// Has no code: the precompiled header is made for it.\n")
    add_library(${headers} OBJECT "${PROJECT_BINARY_DIR}/cmake/${headers}.cpp")
    target_include_directories(${headers} PRIVATE "${PROJECT_SOURCE_DIR}/framework/include")
    fettle_with_vectors(${headers})
    if(NOT BUILD_SHARED_LIBS)
      target_compile_definitions(${headers} PRIVATE FETTLE_PROPERTY_STATIC)
    endif()
    fettle_compile_options(${headers})
    if(optimization)
      set_target_properties(${headers} PROPERTIES FETTLE_OPTIMIZATION ${optimization})
    endif()
    set_target_properties(${headers} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    fettle_precompile(${headers} <chrono> <filesystem> <fettle/property/tree.h>)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()
