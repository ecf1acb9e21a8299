/* Marks around the declarations of this library: they have C names and are exported. */

#pragma once

#ifdef __GNUC__
#define FETTLE_HOST_SHOW _Pragma("GCC visibility push(default)")
#define FETTLE_HOST_SHOWN _Pragma("GCC visibility pop")
#else
#define FETTLE_HOST_SHOW
#define FETTLE_HOST_SHOWN
#endif

#ifdef __cplusplus
#define FETTLE_HOST_OPEN extern "C" {
#define FETTLE_HOST_CLOSE }
#else
#define FETTLE_HOST_OPEN
#define FETTLE_HOST_CLOSE
#endif

#define FETTLE_HOST_BEGIN FETTLE_HOST_SHOW FETTLE_HOST_OPEN
#define FETTLE_HOST_END FETTLE_HOST_CLOSE FETTLE_HOST_SHOWN
