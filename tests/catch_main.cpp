// Catch2 2 is header only: its main program is compiled here, once for all tests.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
