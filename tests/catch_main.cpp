// The main program of all tests, where that of Catch2 2 is not taken from its library.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_CONSOLE_WIDTH 160
#include <catch2/catch.hpp>
#endif

#ifdef __SANITIZE_ADDRESS__
// The search for leaks guesses the size of a module's thread-local data from bytes in front of it,
// and after a module is unloaded it may read elsewhere and end the test with signal 11. These data
// have no pointer to what is not freed.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "intercept_tls_get_addr=0";
}
// Leaks to be ignored: fontconfig keeps some data until the program ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig";
}
#endif
