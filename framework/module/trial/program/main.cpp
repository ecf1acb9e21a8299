// fettle-trial: tries a module out before a program loads it.

#include <fettle/module/trial_program.h>

int main() {
    return fettle::module::trial_main();
}
