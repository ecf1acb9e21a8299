# Eigen: linear algebra. 3.4 and 5 are one interface under two numbers, so the version is checked by hand.
find_package(Eigen3 QUIET NO_MODULE)
if(NOT TARGET Eigen3::Eigen)
  set(FETTLE_MISSING "Eigen 3.4 or newer (Debian: libeigen3-dev) is needed")
elseif(Eigen3_VERSION VERSION_LESS 3.4)
  set(FETTLE_MISSING "Eigen 3.4 or newer is needed, found ${Eigen3_VERSION}")
endif()
