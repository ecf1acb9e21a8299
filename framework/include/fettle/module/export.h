#pragma once
// Macros for the exported symbols of a shared libfettle_module. All code is compiled with hidden
// visibility; only declarations between BEGIN and END in public headers are exported. A static
// library defines FETTLE_MODULE_STATIC and needs no macros.

#if defined(FETTLE_MODULE_STATIC) || !defined(__GNUC__)
#define FETTLE_MODULE_BEGIN
#define FETTLE_MODULE_END
#define FETTLE_MODULE_PRIVATE
#else
#define FETTLE_MODULE_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_MODULE_END _Pragma("GCC visibility pop")
// For structures that public headers only declare and the library defines.
#define FETTLE_MODULE_PRIVATE __attribute__((visibility("hidden")))
#endif
