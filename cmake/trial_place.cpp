// Compiled into each program that is linked with an installed static library of Fettle. Returns the
// folder of the program `fettle-trial`, which tries modules out. Several libraries of one program
// may contain this function, so it is weak.
extern "C" __attribute__((weak)) const char* fettle_trial_place() {
    return FETTLE_TRIAL_PLACE;
}
