# `cpack` makes two Debian packages: `fettle` (program, shared libraries, modules, demos) and `fettle-dev` (headers and what
# finds them).

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fettle)
set(CPACK_PACKAGE_VENDOR Fettle)
set(CPACK_PACKAGE_CONTACT "The Fettle authors <fettle@localhost>")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME fettle)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION games)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)  # what the libraries need is read off them
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  "${PROJECT_BINARY_DIR}/physics" "${PROJECT_BINARY_DIR}/physics/module" "${PROJECT_BINARY_DIR}/console"
  "${PROJECT_BINARY_DIR}/framework/property" "${PROJECT_BINARY_DIR}/framework/property/storage"
  "${PROJECT_BINARY_DIR}/framework/module" "${PROJECT_BINARY_DIR}/framework/script"
  "${PROJECT_BINARY_DIR}/framework/app")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME fettle-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "fettle (= ${PROJECT_VERSION}), libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, pkgconf, libsfml-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers of Fettle, and the files by which CMake and pkg-config find it")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}")
include(CPack)
