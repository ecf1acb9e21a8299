#pragma once
// Macros for the exported symbols of a shared libfettle_script. All code is compiled with hidden
// visibility; only declarations between BEGIN and END in public headers are exported. A static
// library defines FETTLE_SCRIPT_STATIC and needs no macros.

#if defined(FETTLE_SCRIPT_STATIC) || !defined(__GNUC__)
#define FETTLE_SCRIPT_BEGIN
#define FETTLE_SCRIPT_END
#define FETTLE_SCRIPT_PRIVATE
#else
#define FETTLE_SCRIPT_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_SCRIPT_END _Pragma("GCC visibility pop")
// For structures that public headers only declare and the library defines.
#define FETTLE_SCRIPT_PRIVATE __attribute__((visibility("hidden")))
#endif
