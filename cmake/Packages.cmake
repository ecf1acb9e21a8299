# `cpack` makes three Debian packages: `fettle` (program, shared libraries, modules, demos), `fettle-dev` (headers and what
# finds them) and, where cffi is installed, `python3-fettle`. tests/hosting/packages.sh installs them on a bare Debian.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fettle)
set(CPACK_PACKAGE_VENDOR Fettle)
set(CPACK_PACKAGE_CONTACT "The Fettle authors <authors@fettle.invalid>")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "2D games in which every property is live")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL runtime development)
if(BUILD_SHARED_LIBS)
  add_subdirectory(bindings/python)
  if(FETTLE_PYTHON_PACKAGE)
    list(APPEND CPACK_COMPONENTS_ALL python)
  endif()
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME fettle)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION interpreters)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)  # what the libraries need is read off them
get_property(libraries GLOBAL PROPERTY fettle_components)
set(shlibs)
foreach(library IN LISTS libraries)
  get_target_property(folder fettle_${library} BINARY_DIR)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${folder}")
  get_target_property(type fettle_${library} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    string(APPEND shlibs "libfettle_${library} ${fettle_soversion} fettle (= ${PROJECT_VERSION})\n")
  endif()
endforeach()
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-dejavu-core, fonts-droid-fallback, fonts-noto-color-emoji")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Runs games written in Lua. A console in the game reaches every value of
every object by its path: to look, to edit, to bind by a formula, to
rewind and to keep.
.
With the shared libraries for programs that host parts of it, and some
games to begin with.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME fettle-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "fettle (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, pkgconf, libsfml-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "Headers of Fettle's libraries: rigid bodies, the live property tree,
modules that plug in, the console for other people's windows; and the
files by which CMake and pkg-config find them.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-fettle)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "fettle (= ${PROJECT_VERSION}), python3, python3-cffi-backend, python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "Rigid bodies in the plane, for Python.
.
Positions and velocities are arrays of numpy that are never copied, and
many worlds are stepped at once, as learning programs need it.")

# --- What every package of Debian has -----------------------------------------------------------------------------------

set(made "${PROJECT_BINARY_DIR}/debian")
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" license)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]+)" ignored "${license}")
set(holder "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*Copyright[^\n]+\n+" "" license "${license}")
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" license "\n${license}")
file(WRITE "${made}/copyright" "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Fettle

Files: *
Copyright: ${holder}
License: Expat

License: Expat${license}")
string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)  # or what SOURCE_DATE_EPOCH says
file(WRITE "${made}/changelog" "fettle (${PROJECT_VERSION}) unstable; urgency=medium

  * What is new stands in CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${today}
")
file(WRITE "${made}/triggers" "activate-noawait ldconfig\n")
file(WRITE "${made}/shlibs" "${shlibs}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${made}/triggers;${made}/shlibs")

find_program(FETTLE_GZIP gzip)
if(FETTLE_GZIP)
  foreach(name changelog fettle.1)
    set(from "${made}/${name}")
    if(name STREQUAL "fettle.1")
      set(from "${PROJECT_SOURCE_DIR}/docs/fettle.1")
    endif()
    execute_process(COMMAND "${FETTLE_GZIP}" -9nc "${from}" OUTPUT_FILE "${made}/${name}.gz" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  install(FILES "${made}/fettle.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT runtime)
  foreach(package IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${package} upper)
    set(documents "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
    set(unless)
    if(package STREQUAL "python")
      set(unless EXCLUDE_FROM_ALL)
    endif()
    install(FILES "${made}/copyright" "${made}/changelog.gz" DESTINATION "${documents}" COMPONENT ${package} ${unless})
  endforeach()
endif()
include(CPack)
