// The source from which CMake precompiles catch.h for every test program.
#include "catch.h"
