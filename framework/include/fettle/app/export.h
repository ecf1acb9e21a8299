#pragma once
// What a shared libfettle_app shows of itself: what its public headers declare between these two
// marks, and nothing else. Everything is compiled with hidden visibility; a static library needs no
// marks and has FETTLE_APP_STATIC defined.

#ifdef FETTLE_APP_STATIC
#define FETTLE_APP_BEGIN
#define FETTLE_APP_END
#define FETTLE_APP_PRIVATE
#else
#define FETTLE_APP_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_APP_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_APP_PRIVATE __attribute__((visibility("hidden")))
#endif
