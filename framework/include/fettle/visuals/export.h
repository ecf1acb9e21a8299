#pragma once
// Macros for the exported symbols of a shared libfettle_visuals. All code is compiled with hidden
// visibility; only declarations between BEGIN and END in public headers are exported. A static
// library defines FETTLE_VISUALS_STATIC and needs no macros.

#if defined(FETTLE_VISUALS_STATIC) || !defined(__GNUC__)
#define FETTLE_VISUALS_BEGIN
#define FETTLE_VISUALS_END
#else
#define FETTLE_VISUALS_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_VISUALS_END _Pragma("GCC visibility pop")
#endif
