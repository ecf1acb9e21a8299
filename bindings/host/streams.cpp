// Debian's archive of Lua is compiled for programs, which have the streams of C at a fixed
// distance. A shared library has not; the linker gives these variables to Lua instead (`--wrap`). A
// shared library of Lua would not do: in a program that has LuaJIT, its functions of the same names
// would be called.

#include <cstdio>

#ifdef FETTLE_HOST_WRAPS_STREAMS

extern "C" {
// The linker makes these names. NOLINTBEGIN(bugprone-reserved-identifier)
extern std::FILE *__real_stdin, *__real_stdout, *__real_stderr;
std::FILE *__wrap_stdin = __real_stdin, *__wrap_stdout = __real_stdout,
          *__wrap_stderr = __real_stderr;
// NOLINTEND(bugprone-reserved-identifier)
}

#endif
