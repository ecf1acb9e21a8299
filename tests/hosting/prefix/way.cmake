# One way to use Fettle in another project: writes a small project, builds it and runs it.
set(here "${FOLDER}/${WAY}")
file(REMOVE_RECURSE "${here}")
file(MAKE_DIRECTORY "${here}")
set(program "${SOURCES}/examples/bare/main.cpp")

function(must)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY WORKING_DIRECTORY "${here}")
endfunction()

if(WAY STREQUAL "pkgconfig")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${LIBRARIES}/pkgconfig"
    "${PKG_CONFIG}" --cflags --libs fettle-physics OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  must("${CXX}" -std=c++20 -O1 "${program}" -o program ${flags} "-Wl,-rpath,${LIBRARIES}")
  must("${here}/program")
  return()
endif()

if(WAY STREQUAL "pkgconfig_c")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${LIBRARIES}/pkgconfig"
    "${PKG_CONFIG}" --cflags --libs fettle-physics_c OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  file(WRITE "${here}/program.c" "#include <fettle_physics.h>\n#include <stdio.h>\n
int main(void) {
    fettle_world* world;
    const int errors = fettle_world_create(NULL, &world) + fettle_world_step(world, 1);
    printf(\"%d errors, 1 world\\n\", errors);
    return fettle_world_destroy(world);
}
")
  must("${CC}" -std=c11 -Wpedantic -Werror "${here}/program.c" -o program ${flags} "-Wl,-rpath,${LIBRARIES}")
  must("${here}/program")
  return()
endif()

# A static library cannot tell where it was installed; pkg-config knows where the program of trials is.
if(WAY STREQUAL "pkgconfig_module")
  function(ask question answer)
    execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${LIBRARIES}/pkgconfig"
      "${PKG_CONFIG}" ${question} fettle-module OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY OUTPUT_STRIP_TRAILING_WHITESPACE)
    separate_arguments(text UNIX_COMMAND "${text}")
    set(${answer} "${text}" PARENT_SCOPE)
  endfunction()
  ask(--cflags flags)
  ask(--libs libs)
  ask(--variable=trial trial)
  must("${CC}" -std=c11 -c "${SOURCES}/examples/bare/bare.c" -o program.o ${flags})
  must("${CXX}" program.o -o program ${libs} "-Wl,-rpath,${LIBRARIES}")
  must("${CMAKE_COMMAND}" -E env "FETTLE_TRIAL=${trial}" "${here}/program" "${MODULE}")
  return()
endif()

# All files that the compiler reads for the headers of the parts that need neither window nor script.
if(WAY STREQUAL "headers")
  file(GLOB headers RELATIVE "${PREFIX}/include" "${PREFIX}/include/fettle/physics/*.h" "${PREFIX}/include/fettle/property/*.h"
       "${PREFIX}/include/fettle/module/*.h" "${PREFIX}/include/fettle/physics_module/*.h")
  list(TRANSFORM headers PREPEND "#include <")
  list(JOIN headers ">\n" text)
  file(WRITE "${here}/all.cpp" "${text}>\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${LIBRARIES}/pkgconfig"
    "${PKG_CONFIG}" --cflags fettle-physics_module OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  execute_process(COMMAND "${CXX}" -std=c++20 ${flags} -M "${here}/all.cpp" OUTPUT_VARIABLE opened COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^ \n]*/(Eigen|SFML|imgui|lua|lauxlib|sqlite|nlohmann|CLI|zstd)[^ \n]*\\.h(pp)?" foreign "${opened}")
  string(REGEX MATCHALL "[^ \n]*/fettle/[^ \n]*\\.h" own "${opened}")
  list(LENGTH own count)
  if(foreign OR count LESS 30)
    message(FATAL_ERROR "${count} headers open ${foreign}")
  endif()
  message("the standard library is enough for ${count} headers")
  return()
endif()

set(parts physics)
set(version 0.1)
set(link Fettle::physics)
set(take "find_package(Fettle \${version} REQUIRED COMPONENTS \${parts})")
if(WAY STREQUAL "subdirectory")
  set(take "set(FETTLE_PARTS physics)\nadd_subdirectory(\"${SOURCES}\" fettle EXCLUDE_FROM_ALL)")
elseif(WAY STREQUAL "fetch")
  set(take "set(FETTLE_PARTS physics)\ninclude(FetchContent)
FetchContent_Declare(Fettle SOURCE_DIR \"${SOURCES}\")\nFetchContent_MakeAvailable(Fettle)")
elseif(WAY STREQUAL "major")
  set(version 1.0)
elseif(WAY STREQUAL "minor")
  set(version 0.0)
elseif(WAY STREQUAL "newer")  # as if the next minor version were installed
  file(COPY "${LIBRARIES}/cmake/Fettle" DESTINATION "${here}")
  file(READ "${here}/Fettle/FettleConfigVersion.cmake" newer)
  string(REGEX REPLACE "\"0\\.1\\.([0-9]+)\"" "\"0.2.\\1\"" newer "${newer}")
  file(WRITE "${here}/Fettle/FettleConfigVersion.cmake" "${newer}")
  set(take "find_package(Fettle 0.1 REQUIRED COMPONENTS physics PATHS \"${here}/Fettle\" NO_DEFAULT_PATH)")
elseif(WAY STREQUAL "component")
  set(parts "physics sound")
elseif(WAY STREQUAL "lonely")
  # With these, looking for anything else would fail.
  set(take "set(CMAKE_DISABLE_FIND_PACKAGE_SFML ON)\nset(CMAKE_DISABLE_FIND_PACKAGE_PkgConfig ON)\n${take}
if(TARGET fettle_lua OR TARGET fettle_sfml OR TARGET Fettle::property)\n  message(FATAL_ERROR \"more than physics\")\nendif()")
endif()
string(REPLACE "\${version}" "${version}" take "${take}")
string(REPLACE "\${parts}" "${parts}" take "${take}")
file(WRITE "${here}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(Way LANGUAGES C CXX)
${take}
add_executable(program \"${program}\")
target_link_libraries(program PRIVATE ${link})
")
must("${CMAKE_COMMAND}" -S "${here}" -B "${here}/build" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${PREFIX}" -DCMAKE_BUILD_TYPE=None
  "-DCMAKE_UNITY_BUILD=${THOROUGH}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_C_COMPILER_LAUNCHER=${LAUNCHER}")
if(WAY STREQUAL "fetch")  # the same files as above: that they are to be built is enough
  must("${CMAKE_COMMAND}" --build "${here}/build" --target help)
  return()
endif()
if(WAY STREQUAL "subdirectory" AND NOT THOROUGH AND GENERATOR STREQUAL "Ninja")  # all of it takes a minute
  file(GLOB sources "${SOURCES}/physics/world/*.cpp")
  list(GET sources 0 one_source)
  must("${CMAKE_COMMAND}" --build "${here}/build" --target "${program}^" "${one_source}^")
  message("the program and the library compile")
  return()
endif()
must("${CMAKE_COMMAND}" --build "${here}/build" --parallel 2)
must("${here}/build/program")
