// The source for whose sake CMake precompiles catch.h; every test program uses the result.
#include "catch.h"
