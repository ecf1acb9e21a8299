// The program of a trial: reads what is to be tried out, and reports each phase and the result.

#include <link.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include <fettle/module/trial_program.h>
#include <fettle/property/exception_text.h>

#include "../plugin_state.h"
#include "../reload.h"
#include "stand_in.h"
#include "trial.h"

namespace fettle::module {
namespace {

void write_output(std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = ::write(trial_stream, text.data(), text.size());
        if (n < 0 && errno != EINTR) return;
        if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
    }
}

void write_phase(std::string_view phase) {
    write_output("@" + std::string(phase) + "\n");
}

void write_libraries() {
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void*) {
            if (std::strchr(info->dlpi_name, '/') != nullptr)
                write_output("+" + std::string(info->dlpi_name) + "\n");
            return 0;
        },
        nullptr);
}

std::vector<std::byte> all_bytes() {
    std::vector<std::byte> bytes;
    std::byte buffer[65536];
    for (;;) {
        const ssize_t n = ::read(trial_stream, buffer, sizeof buffer);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return bytes;
        bytes.insert(bytes.end(), buffer, buffer + n);
    }
}

/// Opens the module, attaches it to the tree and runs its own test.
void attach(Plugin::State& state, const Trial& trial) {
    write_phase(while_opened);
    state.open = state.open_file(trial.copy);
    state.prepare(*state.host.tree);
    write_phase(while_attached);
    state.attach_native();
    write_phase(in_its_test);
    state.check_native();
}

void run(const Trial& trial) {
    // None of these is destroyed: the process ends without a call of the module.
    auto& state = *new Plugin::State;
    state.file = trial.file;
    state.name = trial.name;
    if (trial.kind == TrialKind::open) {
        write_phase(while_opened);
        state.open = state.open_file(trial.copy);
        return;
    }
    auto& tree = *new property::Tree;
    state.host.tree = &tree;
    new StandIn(tree, trial.tree, state.host, state.classes);
    if (trial.kind == TrialKind::attach)
        attach(state, trial);
    else
        reload(state, trial.copy, write_phase);
    write_phase(in_a_step);
    state.step_once();
}

}  // namespace

int trial_main() {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);  // a crash is reported as text, so no core file is needed
    // The signal itself must end the process: its number is reported. Sanitizers have handlers.
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
        signal(number, SIG_DFL);
    alarm(2 * unsigned(trial_seconds));  // ends it also where the game has ended meanwhile
    try {
        run(trial_from(all_bytes()));
        write_libraries();
        write_output(success_line);
    } catch (...) {
        write_output("!" + property::exception_text());
    }
    _exit(0);  // no function of the module may run here
}

}  // namespace fettle::module
