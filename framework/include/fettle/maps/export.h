#pragma once
// Exported symbols of a shared libfettle_maps: only declarations between these two marks in its
// public headers. Everything is compiled with hidden visibility. A static library needs no marks
// and defines FETTLE_MAPS_STATIC.

#if defined(FETTLE_MAPS_STATIC) || !defined(__GNUC__)
#define FETTLE_MAPS_BEGIN
#define FETTLE_MAPS_END
#else
#define FETTLE_MAPS_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_MAPS_END _Pragma("GCC visibility pop")
#endif
