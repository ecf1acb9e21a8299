#include <ending/crash_report.h>

#include <stdio_ext.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <fettle/module/running.h>

#include <ending/exit_guard.h>

namespace fettle::program {

namespace {

struct CrashSignal {
    int number;
    const char* reason;
};
constexpr std::array crash_signals{
    CrashSignal{SIGSEGV, "it crashed: segmentation fault"},
    CrashSignal{SIGBUS, "it crashed: bus error"},
    CrashSignal{SIGFPE, "it crashed: arithmetic error"},
    CrashSignal{SIGILL, "it crashed: illegal instruction"},
    CrashSignal{SIGABRT, "it crashed: aborted"},
};

// The buffer of stdout is here, since no function of the standard library that writes it out may be
// called in a signal handler.
std::array<char, 65536> output_buffer;
bool output_is_buffered = false;

std::atomic<const char*> collected_text{nullptr};
std::atomic<std::size_t> collected_size{0};

void write_all(int file, std::string_view text) noexcept {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// A line that is put together without the heap. What does not fit is cut off.
class Line {
  public:
    Line& operator<<(const char* text) noexcept {
        for (; text != nullptr && *text != '\0' && size_ < text_.size(); ++text)
            text_[size_++] = static_cast<unsigned char>(*text) < ' ' ? '?' : *text;
        return *this;
    }
    void write_as_line() noexcept {
        if (size_ == text_.size()) --size_;
        text_[size_++] = '\n';
        write_all(STDERR_FILENO, {text_.data(), size_});
    }

  private:
    std::array<char, 1024> text_;
    std::size_t size_ = 0;
};

void add_running_function(Line& line) noexcept {
    const module::RunningFunction now = module::running_function();
    if (now.module == nullptr) return;
    line << " (in the native module " << now.module << ", in its " << now.function;
    if (now.class_name != nullptr) line << " of " << now.class_name;
    if (now.member != nullptr) line << "." << now.member;
    line << ")";
}

void on_crash(int number) {
    std::signal(number, SIG_DFL);  // a crash within this function ends the process at once
    const char* reason = "it crashed";
    for (const CrashSignal& each : crash_signals)
        if (each.number == number) reason = each.reason;
    report_sudden_end(reason);
    std::raise(number);  // the signal is delivered when this handler returns
}

}  // namespace

void report_crashes() {
    static bool done = false;
    if (std::exchange(done, true)) return;
    if (::isatty(STDOUT_FILENO) == 0)
        output_is_buffered =
            std::setvbuf(stdout, output_buffer.data(), _IOFBF, output_buffer.size()) == 0;
    // An endless recursion leaves no room on the stack of the thread.
    alignas(16) static std::array<char, 65536> memory;
    stack_t stack{};
    stack.ss_sp = memory.data();
    stack.ss_size = memory.size();
    ::sigaltstack(&stack, nullptr);
    for (const CrashSignal& each : crash_signals) {
        struct sigaction was {
        }, action{};
        ::sigaction(each.number, nullptr, &was);
        if (was.sa_handler != SIG_DFL) continue;
        action.sa_handler = on_crash;
        action.sa_flags = SA_ONSTACK;
        sigemptyset(&action.sa_mask);
        ::sigaction(each.number, &action, nullptr);
    }
}

void report_sudden_end(const char* reason) noexcept {
    if (output_is_buffered) write_all(STDOUT_FILENO, {output_buffer.data(), __fpending(stdout)});
    if (const char* const text = collected_text.load(std::memory_order_relaxed))
        write_all(STDOUT_FILENO, {text, collected_size.load(std::memory_order_relaxed)});
    Line line;
    line << "fettle: ";
    if (const char* const work = guarded_work()) line << work << ": ";
    line << reason;
    add_running_function(line);
    line.write_as_line();
}

CollectedOutput::~CollectedOutput() {
    is({});
}

void CollectedOutput::is(std::string_view text) noexcept {
    collected_text.store(nullptr, std::memory_order_relaxed);
    collected_size.store(text.size(), std::memory_order_relaxed);
    collected_text.store(text.empty() ? nullptr : text.data(), std::memory_order_relaxed);
}

}  // namespace fettle::program
