#include <commands/commands.h>

int main(int argc, char** argv) {
    return fettle::program::run_program(argc, argv);
}
