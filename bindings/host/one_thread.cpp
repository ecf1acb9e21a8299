#include "one_thread.h"

#include "../c/calls/failure.h"

namespace fettle::host {

__attribute__((tls_model("initial-exec"))) constinit thread_local char thread_mark = 0;

std::atomic<const char*> OneThread::holder_ = nullptr;
int OneThread::games_ = 0;

namespace {

[[noreturn]] void refuse() {
    throw physics_c::Failure{FETTLE_LOCKED,
                             "one thread uses all games of a process: another one created the "
                             "games that there are"};
}

}  // namespace

OneThread::OneThread() {
    const char* nobody = nullptr;
    if (!holder_.compare_exchange_strong(nobody, &thread_mark) && nobody != &thread_mark) refuse();
    ++games_;
}

OneThread::~OneThread() {
    if (--games_ == 0) holder_ = nullptr;
}

void OneThread::require() {
    if (!is_here()) refuse();
}

}  // namespace fettle::host
