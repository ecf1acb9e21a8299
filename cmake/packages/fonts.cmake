# FreeType reads fonts, HarfBuzz joins and places letters, FriBidi orders those from right to left, Fontconfig finds the
# fonts that the system has.
if(NOT TARGET fettle_fonts)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(FETTLE_FONTS IMPORTED_TARGET GLOBAL freetype2 harfbuzz fribidi fontconfig)
  if(FETTLE_FONTS_FOUND)
    # With HarfBuzz 12 pkg-config adds -pthread, which the precompiled headers were not compiled with.
    set_target_properties(PkgConfig::FETTLE_FONTS PROPERTIES INTERFACE_COMPILE_OPTIONS "")
    add_library(fettle_fonts INTERFACE IMPORTED GLOBAL)
    target_link_libraries(fettle_fonts INTERFACE PkgConfig::FETTLE_FONTS)
  else()
    set(FETTLE_MISSING "FreeType, HarfBuzz, FriBidi and Fontconfig (Debian: libfreetype-dev, libharfbuzz-dev, libfribidi-dev, libfontconfig-dev) are needed")
  endif()
endif()
