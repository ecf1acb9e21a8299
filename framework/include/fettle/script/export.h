#pragma once
// What a shared libfettle_script shows of itself: what its public headers declare between these two
// marks, and nothing else. Everything is compiled with hidden visibility; a static library needs no
// marks and has FETTLE_SCRIPT_STATIC defined.

#ifdef FETTLE_SCRIPT_STATIC
#define FETTLE_SCRIPT_BEGIN
#define FETTLE_SCRIPT_END
#define FETTLE_SCRIPT_PRIVATE
#else
#define FETTLE_SCRIPT_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_SCRIPT_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_SCRIPT_PRIVATE __attribute__((visibility("hidden")))
#endif
