#pragma once
// What a shared libfettle_storage shows of itself: what its public headers declare between these
// two marks, and nothing else. Everything is compiled with hidden visibility; a static library
// needs no marks and has FETTLE_STORAGE_STATIC defined.

#ifdef FETTLE_STORAGE_STATIC
#define FETTLE_STORAGE_BEGIN
#define FETTLE_STORAGE_END
#define FETTLE_STORAGE_PRIVATE
#else
#define FETTLE_STORAGE_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_STORAGE_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_STORAGE_PRIVATE __attribute__((visibility("hidden")))
#endif
