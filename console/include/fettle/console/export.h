#pragma once
// What a shared libfettle_console shows of itself: what its public headers declare between these
// two marks, and nothing else. Everything is compiled with hidden visibility; a static library
// needs no marks and has FETTLE_CONSOLE_STATIC defined.

#ifdef FETTLE_CONSOLE_STATIC
#define FETTLE_CONSOLE_BEGIN
#define FETTLE_CONSOLE_END
#define FETTLE_CONSOLE_PRIVATE
#else
#define FETTLE_CONSOLE_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_CONSOLE_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_CONSOLE_PRIVATE __attribute__((visibility("hidden")))
#endif
