#pragma once
// What a shared libfettle_property shows of itself: what its public headers declare between these
// two marks, and nothing else. Everything is compiled with hidden visibility; a static library
// needs no marks and has FETTLE_PROPERTY_STATIC defined.

#ifdef FETTLE_PROPERTY_STATIC
#define FETTLE_PROPERTY_BEGIN
#define FETTLE_PROPERTY_END
#define FETTLE_PROPERTY_PRIVATE
#else
#define FETTLE_PROPERTY_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_PROPERTY_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_PROPERTY_PRIVATE __attribute__((visibility("hidden")))
#endif
