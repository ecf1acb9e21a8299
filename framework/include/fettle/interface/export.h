#pragma once
// Macros for the exported symbols of a shared libfettle_interface. All code is compiled with hidden
// visibility; only declarations between BEGIN and END in public headers are exported. A static
// library defines FETTLE_INTERFACE_STATIC and needs no macros.

#if defined(FETTLE_INTERFACE_STATIC) || !defined(__GNUC__)
#define FETTLE_INTERFACE_BEGIN
#define FETTLE_INTERFACE_END
#define FETTLE_INTERFACE_PRIVATE
#else
#define FETTLE_INTERFACE_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_INTERFACE_END _Pragma("GCC visibility pop")
// For structures that public headers only declare and the library defines.
#define FETTLE_INTERFACE_PRIVATE __attribute__((visibility("hidden")))
#endif
