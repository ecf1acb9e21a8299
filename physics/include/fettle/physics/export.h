#pragma once
// Exported symbols of a shared libfettle_physics: only declarations between these two marks in its
// public headers. Everything is compiled with hidden visibility. A static library needs no marks
// and defines FETTLE_PHYSICS_STATIC.

#if defined(FETTLE_PHYSICS_STATIC) || !defined(__GNUC__)
#define FETTLE_PHYSICS_BEGIN
#define FETTLE_PHYSICS_END
#define FETTLE_PHYSICS_PRIVATE
#else
#define FETTLE_PHYSICS_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_PHYSICS_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_PHYSICS_PRIVATE __attribute__((visibility("hidden")))
#endif
