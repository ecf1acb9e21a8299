# Every library that the parts to be built rest on, found once and given one target name. Debian's names are in
# cmake/packages.txt; nothing is downloaded.

# Where Fettle is part of another project, what is found here has to be known there too.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

# What installed libraries need is looked for by the same files when they are used.
macro(fettle_require package)
  set(FETTLE_MISSING "")
  include("${PROJECT_SOURCE_DIR}/cmake/packages/${package}.cmake")
  if(FETTLE_MISSING)
    message(FATAL_ERROR "${FETTLE_MISSING}")
  endif()
endmacro()

fettle_require(eigen)
if("storage" IN_LIST FETTLE_PARTS OR "fettle" IN_LIST FETTLE_PARTS OR FETTLE_BUILD_BENCH)
  find_package(nlohmann_json REQUIRED)
endif()
if("storage" IN_LIST FETTLE_PARTS)
  fettle_require(sqlite)
endif()
if("script" IN_LIST FETTLE_PARTS)
  fettle_require(lua)
endif()
if("app" IN_LIST FETTLE_PARTS)
  fettle_require(sfml)
  fettle_require(zstd)
endif()
if("console" IN_LIST FETTLE_PARTS)
  fettle_require(imgui)
endif()
if("fettle" IN_LIST FETTLE_PARTS OR FETTLE_BUILD_BENCH)
  find_package(CLI11 REQUIRED)
endif()
