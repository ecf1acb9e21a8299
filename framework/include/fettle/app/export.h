#pragma once
// Macros for the exported symbols of a shared libfettle_app. All code is compiled with hidden
// visibility; only declarations between BEGIN and END in public headers are exported. A static
// library defines FETTLE_APP_STATIC and needs no macros.

#if defined(FETTLE_APP_STATIC) || !defined(__GNUC__)
#define FETTLE_APP_BEGIN
#define FETTLE_APP_END
#define FETTLE_APP_PRIVATE
#else
#define FETTLE_APP_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_APP_END _Pragma("GCC visibility pop")
// For structures that public headers only declare and the library defines.
#define FETTLE_APP_PRIVATE __attribute__((visibility("hidden")))
#endif
