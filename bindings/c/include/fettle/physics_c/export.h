/* Marks around the declarations of this library: they have C names and are exported. */

#pragma once

#ifdef __GNUC__
#define FETTLE_PHYSICS_C_SHOW _Pragma("GCC visibility push(default)")
#define FETTLE_PHYSICS_C_SHOWN _Pragma("GCC visibility pop")
#else
#define FETTLE_PHYSICS_C_SHOW
#define FETTLE_PHYSICS_C_SHOWN
#endif

#ifdef __cplusplus
#define FETTLE_PHYSICS_C_OPEN extern "C" {
#define FETTLE_PHYSICS_C_CLOSE }
#else
#define FETTLE_PHYSICS_C_OPEN
#define FETTLE_PHYSICS_C_CLOSE
#endif

#define FETTLE_PHYSICS_C_BEGIN FETTLE_PHYSICS_C_SHOW FETTLE_PHYSICS_C_OPEN
#define FETTLE_PHYSICS_C_END FETTLE_PHYSICS_C_CLOSE FETTLE_PHYSICS_C_SHOWN
