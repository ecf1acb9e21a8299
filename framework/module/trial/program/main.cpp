// fettle-trial: tries a module out for a program that wants to load it.

#include <fettle/module/trial_program.h>

int main() {
    return fettle::module::trial_main();
}
