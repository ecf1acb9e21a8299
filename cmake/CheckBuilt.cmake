# Run by `cmake --install` before anything is copied: stops unless every file of `fettle_files` has been built.
# Without it an installation would copy the headers and fail at the first library that is not there.

set(missing "")
foreach(file IN LISTS fettle_files)
  if(NOT EXISTS "${file}")
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${fettle_folder}")
    string(APPEND missing "  ${file}\n")
  endif()
endforeach()
if(missing)
  message(FATAL_ERROR "Nothing was installed, since these files are not built yet:\n${missing}"
    "`./play --build` builds them, as does this command:\n  cmake --build ${fettle_folder} --target fettle_installed\n")
endif()
