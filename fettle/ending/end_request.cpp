#include <ending/end_request.h>

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string_view>

#include <fettle/script/runtime.h>

#include <ending/crash_report.h>
#include <ending/exit_status.h>

namespace fettle::program {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t end_signal = 0;
std::atomic<script::Runtime*> interruptible{nullptr};
static_assert(std::atomic<script::Runtime*>::is_always_lock_free, "a signal handler reads it");
std::array<struct sigaction, signals.size() + 1> previous_actions;

/// Scripts are interrupted once a second. If the run has not ended after this number of interrupts,
/// its cause is not a script, and the process is ended.
constexpr int max_alarms = 10;
volatile std::sig_atomic_t alarms = 0;

volatile std::sig_atomic_t interrupts_handled = 0;  // while an `Interrupts` exists
volatile std::sig_atomic_t interrupt_arrived = 0;
volatile std::sig_atomic_t command_runs = 0;

/// Writes to stderr. It may run in a signal handler, so it uses no stream and allocates nothing.
void write_at_once(std::string_view text) {
    const auto written = ::write(STDERR_FILENO, text.data(), text.size());
    (void)written;  // a failure cannot be reported anywhere else
}

void on_signal(int number) {
    if (number == SIGINT && interrupts_handled != 0 && interrupt_arrived == 0 && end_signal == 0) {
        interrupt_arrived = 1;
        script::Runtime* const runtime = interruptible.load();
        if (command_runs != 0 && runtime != nullptr) runtime->interrupt();
        return;
    }
    if (end_signal != 0) {
        write_at_once("fettle: a second signal: the run ends at once\n");
        std::signal(number, SIG_DFL);
        std::raise(number);  // the signal is delivered when this handler returns
        return;
    }
    end_signal = number;
    alarms = 0;
    ::alarm(1);
}

void on_alarm(int) {
    alarms = alarms + 1;
    if (alarms > max_alarms) {
        report_sudden_end("the run did not end in time: it ends at once");
        ::_exit(status_of_signal(end_signal));
    }
    if (script::Runtime* runtime = interruptible.load()) runtime->interrupt();
    ::alarm(1);
}

void install(int number, void (*handler)(int), struct sigaction& was) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    ::sigaction(number, nullptr, &was);
    if (was.sa_handler != SIG_IGN) ::sigaction(number, &action, nullptr);
}

}  // namespace

EndRequest::EndRequest() {
    end_signal = 0;
    for (std::size_t i = 0; i < signals.size(); ++i)
        install(signals[i], on_signal, previous_actions[i]);
    install(SIGALRM, on_alarm, previous_actions.back());
}

EndRequest::~EndRequest() {
    ::alarm(0);
    interruptible = nullptr;
    for (std::size_t i = 0; i < signals.size(); ++i)
        ::sigaction(signals[i], &previous_actions[i], nullptr);
    ::sigaction(SIGALRM, &previous_actions.back(), nullptr);
}

int EndRequest::signal() {
    return end_signal;
}

void EndRequest::limit_scripts(unsigned seconds) {
    alarms = 0;
    ::alarm(seconds);
}

EndRequest::Scripts::Scripts(script::Runtime& runtime) {
    interruptible = &runtime;
}

EndRequest::Scripts::~Scripts() {
    interruptible = nullptr;
}

EndRequest::Interrupts::Interrupts() {
    interrupt_arrived = 0;
    interrupts_handled = 1;
}

EndRequest::Interrupts::~Interrupts() {
    interrupts_handled = 0;
    interrupt_arrived = 0;
}

bool EndRequest::Interrupts::arrived() {
    return interrupt_arrived != 0;
}

bool EndRequest::Interrupts::test_and_clear() {
    const bool arrived = interrupt_arrived != 0;
    interrupt_arrived = 0;
    return arrived;
}

EndRequest::Command::Command() {
    command_runs = 1;
    // The signal may have arrived after the line was complete and before the command began.
    script::Runtime* const runtime = interruptible.load();
    if (runtime != nullptr && interrupt_arrived != 0) runtime->interrupt();
}

EndRequest::Command::~Command() {
    command_runs = 0;
    // If the run is to end, its scripts stay interrupted until `closing`.
    script::Runtime* const runtime = interruptible.load();
    if (runtime != nullptr && interrupt_arrived != 0 && end_signal == 0) runtime->go_on();
}

}  // namespace fettle::program
