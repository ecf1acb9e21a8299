#pragma once
// Exported symbols of a shared libfettle_storage: only declarations between these two marks in its
// public headers. Everything is compiled with hidden visibility. A static library needs no marks
// and defines FETTLE_STORAGE_STATIC.

#if defined(FETTLE_STORAGE_STATIC) || !defined(__GNUC__)
#define FETTLE_STORAGE_BEGIN
#define FETTLE_STORAGE_END
#define FETTLE_STORAGE_PRIVATE
#else
#define FETTLE_STORAGE_BEGIN _Pragma("GCC visibility push(default)")
#define FETTLE_STORAGE_END _Pragma("GCC visibility pop")
// For structures that are only declared in public headers and defined inside the library.
#define FETTLE_STORAGE_PRIVATE __attribute__((visibility("hidden")))
#endif
