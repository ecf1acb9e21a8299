#include <fettle/app/frame_log.h>

#include <algorithm>

namespace fettle::app {

void FrameLog::add(const FrameTimes& times) {
    frames_.push_back(times);
    if (frames_.size() > most) frames_.pop_front();
    open_ = true;
}

void FrameLog::add_drawing(double ms) {
    if (open_) frames_.back().ms.draw += ms;
}

const FrameTimes* FrameLog::complete(double ms) {
    if (!open_) return nullptr;
    open_ = false;
    Timings& of = frames_.back().ms;
    of.frame = std::max(ms, of.work());
    of.wait = of.frame - of.work();
    return &frames_.back();
}

}  // namespace fettle::app
