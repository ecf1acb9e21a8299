// Compiled into each program that is linked with an installed static library of Fettle: tells the
// library where the program is that tries modules out. Several libraries of a program may have it.
extern "C" __attribute__((weak)) const char* fettle_trial_place() {
    return FETTLE_TRIAL_PLACE;
}
