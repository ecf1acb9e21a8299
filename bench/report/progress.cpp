#include "report/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace fettle::bench {

Progress::Progress(double units)
    : units_(std::max(units, 1e-9)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    wipe();
}

void Progress::begin(const std::string& what) {
    what_ = what;
    shown_ = -1;
    if (terminal_)
        draw();
    else
        std::fprintf(stderr, "%s\n", what.c_str());
}

void Progress::add(double units) {
    done_ += units;
    if (terminal_) draw();
}

void Progress::draw() {
    constexpr int width = 30;
    const double fraction = std::clamp(done_ / units_, 0.0, 1.0);
    const int now = static_cast<int>(1000 * fraction);
    if (now == shown_) return;
    shown_ = now;
    std::string bar(static_cast<std::size_t>(width * fraction), '#');
    bar.resize(width, '.');
    std::fprintf(stderr, "\r\x1b[K[%s] %3d %%  %s", bar.c_str(), now / 10, what_.c_str());
    std::fflush(stderr);
}

void Progress::wipe() {
    if (terminal_) std::fprintf(stderr, "\r\x1b[K");
}

}  // namespace fettle::bench
