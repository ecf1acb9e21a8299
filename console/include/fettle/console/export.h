#pragma once
// Exported symbols of a shared libfettle_console: only declarations between these two marks in its
// public headers. Everything is compiled with hidden visibility. A static library needs no marks
// and defines FETTLE_CONSOLE_STATIC.

#if defined(FETTLE_CONSOLE_STATIC) || !defined(__GNUC__)
#define FETTLE_CONSOLE_BEGIN
#define FETTLE_CONSOLE_END
#define FETTLE_CONSOLE_PRIVATE
#else
#define FETTLE_CONSOLE_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_CONSOLE_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_CONSOLE_PRIVATE __attribute__((visibility("hidden")))
#endif
