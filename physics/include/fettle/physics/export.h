#pragma once
// What a shared libfettle_physics shows of itself: what its public headers declare between these
// two marks, and nothing else. Everything is compiled with hidden visibility; a static library
// needs no marks and has FETTLE_PHYSICS_STATIC defined.

#ifdef FETTLE_PHYSICS_STATIC
#define FETTLE_PHYSICS_BEGIN
#define FETTLE_PHYSICS_END
#else
#define FETTLE_PHYSICS_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_PHYSICS_END _Pragma("GCC visibility pop")
#endif
