# What all libraries of Fettle have in common: names, exported symbols and installation.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The version in the name of the shared libraries: a program needs a library with the same one. Before 1.0 the binary interface may
# change with every minor version; docs/design/modules.md describes when versions change.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(fettle_soversion "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
else()
  set(fettle_soversion "${PROJECT_VERSION_MAJOR}")
endif()
set(fettle_cmake_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Fettle")

# Builds everything that `cmake --install` takes from the build folder: `./play --build` asks for this target.
add_custom_target(fettle_installed)
if(FETTLE_INSTALL)
  # The first thing an installation does: it refuses to copy anything while a part is not built.
  install(CODE "set(fettle_folder \"${PROJECT_BINARY_DIR}\")
set(fettle_files \"$<TARGET_GENEX_EVAL:fettle_installed,$<TARGET_PROPERTY:fettle_installed,FETTLE_FILES>>\")" ALL_COMPONENTS)
  install(SCRIPT "${PROJECT_SOURCE_DIR}/cmake/CheckBuilt.cmake" ALL_COMPONENTS)
endif()

# fettle_install(TARGET ARGUMENT...): install(TARGETS TARGET ARGUMENT...), and `fettle_installed` builds it.
# Every target must be installed by this function, so that `fettle_installed` contains all of them.
function(fettle_install target)
  if(FETTLE_INSTALL)
    install(TARGETS ${target} ${ARGN})
    add_dependencies(fettle_installed ${target})
    set_property(TARGET fettle_installed APPEND PROPERTY FETTLE_FILES "$<TARGET_FILE:${target}>")
  endif()
endfunction()

# fettle_library(NAME TEXT
#   INCLUDE FOLDER      of the public headers, below which lies HEADERS
#   HEADERS FOLDER      what of it is this library's, as in fettle/physics
#   WITHOUT PATTERN     more for install(DIRECTORY)
#   NEEDS PART...       parts of Fettle that its users need too
#   PACKAGES NAME...    files of cmake/packages/ that its users need; those in BEHIND only where it is static
#   PKGCONFIG NAME...   the same as pkg-config calls them; PKGCONFIG_BEHIND likewise
#   VARIABLES NAME=VALUE...  more variables of its file for pkg-config
#   )
# gives the target fettle_NAME its alias Fettle::NAME, flags, visibility and versions, and installs it.
function(fettle_library name text)
  cmake_parse_arguments(of "" "INCLUDE;HEADERS" "WITHOUT;NEEDS;PACKAGES;BEHIND;PKGCONFIG;PKGCONFIG_BEHIND;LIBS_BEHIND;VARIABLES"
    ${ARGN})
  set(target fettle_${name})
  add_library(Fettle::${name} ALIAS ${target})
  fettle_compile_options(${target})
  string(TOUPPER ${name} upper)
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${fettle_soversion}
    INSTALL_RPATH "$ORIGIN"
    CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${of_INCLUDE}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  get_target_property(type ${target} TYPE)
  set(defines)
  if(FETTLE_PHYSICS_DOUBLE AND name MATCHES "^physics(_c)?$")
    set(defines FETTLE_PHYSICS_DOUBLE)
    target_compile_definitions(${target} PUBLIC ${defines})
  endif()
  if(type STREQUAL STATIC_LIBRARY)
    list(APPEND defines FETTLE_${upper}_STATIC)
    target_compile_definitions(${target} PUBLIC ${defines})
    list(APPEND of_PACKAGES ${of_BEHIND})
    list(APPEND of_PKGCONFIG ${of_PKGCONFIG_BEHIND})
  elseif(MINGW)
    # Linkers for Windows export all names, but here none of the static libraries behind this one.
    target_link_options(${target} PRIVATE LINKER:--exclude-libs,ALL)
  elseif(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    # A missing symbol is an error here, not later in a program that links the library.
    set(exports "${PROJECT_SOURCE_DIR}/cmake/exports.map")
    target_link_options(${target} PRIVATE "LINKER:--version-script=${exports}")
    if(NOT FETTLE_SANITIZE)  # clang puts the functions of its sanitizers into programs only
      target_link_options(${target} PRIVATE LINKER:-z,defs)
    endif()
    set_target_properties(${target} PROPERTIES LINK_DEPENDS "${exports}")
  endif()
  if(NOT FETTLE_INSTALL)
    return()
  endif()

  fettle_install(${target} EXPORT fettle_${name}
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT runtime
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT development
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
  install(EXPORT fettle_${name} NAMESPACE Fettle:: FILE ${name}.cmake
    DESTINATION "${fettle_cmake_folder}" COMPONENT development)
  install(DIRECTORY "${of_INCLUDE}/${of_HEADERS}/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${of_HEADERS}"
    COMPONENT development FILES_MATCHING PATTERN "*.h" ${of_WITHOUT})
  set_property(GLOBAL APPEND PROPERTY fettle_components ${name})
  set_property(GLOBAL APPEND_STRING PROPERTY fettle_component_table
    "set(_fettle_needs_${name} ${of_NEEDS})\nset(_fettle_packages_${name} ${of_PACKAGES})\n")
  if(of_PACKAGES)
    set_property(GLOBAL APPEND PROPERTY fettle_packages ${of_PACKAGES})
  endif()
  fettle_pkgconfig(${name} "${text}" "${of_NEEDS}" "${of_PKGCONFIG}" "${defines}" "${of_LIBS_BEHIND}" "${of_VARIABLES}")
endfunction()

# fettle_with_vectors(TARGET): TARGET and its users include <fettle/vector/...>, headers without a library.
function(fettle_with_vectors target)
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/vector/include>")
  get_property(installed GLOBAL PROPERTY fettle_vectors_installed)
  if(FETTLE_INSTALL AND NOT installed)
    set_property(GLOBAL PROPERTY fettle_vectors_installed ON)
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/vector/include/fettle/vector" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/fettle"
      COMPONENT development)
  endif()
endfunction()

# fettle_plugin(NAME): the target fettle_NAME_plugin is a module in a shared object, found by its name.
function(fettle_plugin name)
  set(target fettle_${name}_plugin)
  fettle_compile_options(${target})
  file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/fettle/modules" "/${CMAKE_INSTALL_LIBDIR}")
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME ${name} INSTALL_RPATH "$ORIGIN/${up}"
    LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib/fettle/modules"
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  fettle_install(${target} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/fettle/modules" COMPONENT runtime)
endfunction()

function(fettle_pkgconfig name text needs packages defines libs variables)
  set(requires)
  foreach(need IN LISTS needs)
    list(APPEND requires "fettle-${need} = ${PROJECT_VERSION}")
  endforeach()
  list(APPEND requires ${packages})
  list(JOIN requires ", " requires)
  list(TRANSFORM defines PREPEND "-D")
  list(JOIN libs " " libs)
  list(TRANSFORM variables APPEND "\n")
  list(JOIN variables "" variables)
  # Relative to the file, so that a prefix may be moved.
  string(REGEX REPLACE "[^/]+" ".." up "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  set(file "${PROJECT_BINARY_DIR}/pkgconfig/fettle-${name}.pc")
  file(WRITE "${file}" "prefix=\${pcfiledir}/${up}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}
${variables}
Name: fettle-${name}
Description: ${text}
Version: ${PROJECT_VERSION}
Requires: ${requires}
Cflags: -I\${includedir} ${defines}
Libs: -L\${libdir} -lfettle_${name} ${libs}
")
  install(FILES "${file}" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
endfunction()

# To be called after all libraries are defined.
function(fettle_install_package)
  get_property(components GLOBAL PROPERTY fettle_components)
  get_property(fettle_table GLOBAL PROPERTY fettle_component_table)
  get_property(packages GLOBAL PROPERTY fettle_packages)
  list(REMOVE_DUPLICATES packages)
  list(JOIN components " " fettle_component_names)
  set(made "${PROJECT_BINARY_DIR}/cmake")
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/FettleConfig.cmake.in" "${made}/FettleConfig.cmake"
    INSTALL_DESTINATION "${fettle_cmake_folder}")
  # As for the soversion: before 1.0 a minor version may change the interface.
  if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(compatibility SameMinorVersion)
  else()
    set(compatibility SameMajorVersion)
  endif()
  write_basic_package_version_file("${made}/FettleConfigVersion.cmake" COMPATIBILITY ${compatibility})
  install(FILES "${made}/FettleConfig.cmake" "${made}/FettleConfigVersion.cmake"
    DESTINATION "${fettle_cmake_folder}" COMPONENT development)
  if(TARGET fettle_module AND NOT BUILD_SHARED_LIBS)
    install(FILES "${PROJECT_SOURCE_DIR}/cmake/trial_place.cpp"
      DESTINATION "${fettle_cmake_folder}" COMPONENT development)
  endif()
  foreach(package IN LISTS packages)
    install(FILES "${PROJECT_SOURCE_DIR}/cmake/packages/${package}.cmake"
      DESTINATION "${fettle_cmake_folder}/packages" COMPONENT development)
  endforeach()
endfunction()
