# Precompiled headers: most of the time that a source of this project takes to compile goes into reading headers.
#
# Sources still include all that they use, so that each compiles alone too: the preset `clang` builds without precompiled
# headers. A header that changes often does not belong here, since everything that uses it is compiled again.

# What nearly every source includes of the standard library.
set(fettle_common_headers <algorithm> <array> <cmath> <cstdint> <cstring> <functional> <limits> <memory> <optional> <span>
    <stdexcept> <string> <string_view> <unordered_map> <utility> <vector>)

# fettle_precompile(TARGET HEADER...) compiles the common headers and HEADER... once for TARGET.
function(fettle_precompile target)
  target_precompile_headers(${target} PRIVATE ${fettle_common_headers} ${ARGN})
endfunction()

# fettle_precompile_tree(TARGET): for a library on top of the property tree. All of these share one precompiled header,
# which needs the very same flags for each; that is why it is made of fettle_compile_options and nothing else.
function(fettle_precompile_tree target)
  if(NOT TARGET fettle_tree_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/cmake/tree_headers.cpp"
      CONTENT "// Has no code: the precompiled header is made for it.\n")
    add_library(fettle_tree_headers OBJECT "${PROJECT_BINARY_DIR}/cmake/tree_headers.cpp")
    target_include_directories(fettle_tree_headers PRIVATE "${PROJECT_SOURCE_DIR}/framework/include")
    fettle_with_vectors(fettle_tree_headers)
    if(NOT BUILD_SHARED_LIBS)
      target_compile_definitions(fettle_tree_headers PRIVATE FETTLE_PROPERTY_STATIC)
    endif()
    fettle_compile_options(fettle_tree_headers)
    set_target_properties(fettle_tree_headers PROPERTIES
      CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    fettle_precompile(fettle_tree_headers <chrono> <filesystem> <fettle/property/tree.h>)
  endif()
  target_precompile_headers(${target} REUSE_FROM fettle_tree_headers)
endfunction()
