// Debian's static archive of Lua is compiled for programs: it addresses stdin, stdout and stderr
// relative to its own code, which is not possible in a shared library. So the linker replaces them
// with the variables below (`--wrap`). A shared library of Lua would not do: in a program that also
// loads LuaJIT, the functions of LuaJIT with the same names would be called.

#include <cstdio>

#ifdef FETTLE_HOST_WRAPS_STREAMS

extern "C" {
// The linker makes these names.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
extern std::FILE *__real_stdin, *__real_stdout, *__real_stderr;
std::FILE *__wrap_stdin = __real_stdin, *__wrap_stdout = __real_stdout,
          *__wrap_stderr = __real_stderr;
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
}

#endif
