#pragma once
// Exported symbols of a shared libfettle_property: only declarations between these two marks in its
// public headers. Everything is compiled with hidden visibility. A static library needs no marks
// and defines FETTLE_PROPERTY_STATIC.

#if defined(FETTLE_PROPERTY_STATIC) || !defined(__GNUC__)
#define FETTLE_PROPERTY_BEGIN
#define FETTLE_PROPERTY_END
#define FETTLE_PROPERTY_PRIVATE
#else
#define FETTLE_PROPERTY_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_PROPERTY_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_PROPERTY_PRIVATE __attribute__((visibility("hidden")))
#endif
