# Every library Fettle builds on, found once and given one target name. Debian's names are in
# cmake/packages.txt; nothing is downloaded.

find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen 3.4 or newer is needed, found ${Eigen3_VERSION}")
endif()
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)

# Lua's C++ build throws where the C build would longjmp, so that destructors run on an error.
pkg_search_module(LUA IMPORTED_TARGET lua5.4-c++ lua-5.4-c++ lua54-c++)
if(NOT LUA_FOUND)
  message(FATAL_ERROR "Lua 5.4 in its C++ build (Debian: liblua5.4-dev) is needed")
endif()
add_library(fettle_lua INTERFACE)
target_link_libraries(fettle_lua INTERFACE PkgConfig::LUA)

# SFML 2 and 3 name their components and targets differently.
find_package(SFML 3 QUIET COMPONENTS Graphics Window System Audio)
add_library(fettle_sfml INTERFACE)
if(SFML_FOUND)
  target_link_libraries(fettle_sfml INTERFACE SFML::Graphics SFML::Window SFML::System SFML::Audio)
else()
  find_package(SFML 2.5 REQUIRED COMPONENTS graphics window system audio)
  target_link_libraries(fettle_sfml INTERFACE sfml-graphics sfml-window sfml-system sfml-audio)
endif()

# Debian's Dear ImGui is a static library that leaves the stb symbols to libstb.
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
find_library(FETTLE_STB NAMES stb)
add_library(fettle_imgui INTERFACE)
target_link_libraries(fettle_imgui INTERFACE PkgConfig::IMGUI $<$<BOOL:${FETTLE_STB}>:${FETTLE_STB}>)
