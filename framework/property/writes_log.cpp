#include "writes_log.h"

#include <algorithm>
#include <new>

namespace fettle::property {

PlainWrite* WritesLog::new_ring() {
    static_assert(most % most_untold == 0);
    void* const ring = std::calloc(most, sizeof(PlainWrite));
    if (ring == nullptr) throw std::bad_alloc();
    return static_cast<PlainWrite*>(ring);
}

void WritesLog::tell(Writer writer, std::uint64_t step) {
    told_ += static_cast<std::uint64_t>(next_ - untold_);
    if (runs_.empty() || runs_.back().writer != writer || runs_.back().step != step) {
        while (!runs_.empty() && runs_.front().end + most <= told_) runs_.pop_front();
        runs_.push_back({.end = told_, .step = step, .writer = writer});
    } else {
        runs_.back().end = told_;
    }
    PlainWrite* const ring_end = ring_.get() + most;
    if (next_ == ring_end) next_ = ring_.get();
    untold_ = next_;
    end_ = untold_ + std::min<std::ptrdiff_t>(most_untold, ring_end - untold_);
    open(open_);
}

void WritesLog::take_back(PlainWrite& entry) {
    if (&entry + 1 == next_ && &entry >= untold_)
        --next_;
    else if (&entry >= untold_ && &entry < next_)
        entry.instance = {};  // others came after it: nobody's
}

Provenance WritesLog::find(Handle instance, Symbol property) const {
    Provenance out;
    for (std::uint64_t number = told_; number > 0 && told_ - number < most; --number) {
        const PlainWrite& write = ring_.get()[(number - 1) % most];
        if (write.instance.index != instance.index || write.property->symbol != property) continue;
        // A slot's next owner has been written by nobody yet.
        if (write.instance.generation != instance.generation) break;
        const auto run = std::lower_bound(runs_.begin(), runs_.end(), number,
                                          [](const Run& r, std::uint64_t n) { return r.end < n; });
        out.known = true;
        out.cause.writer = run->writer;
        out.cause.step = run->step;
        break;
    }
    const auto full = full_.find({instance.index, property});
    if (full == full_.end() || full->second.first != instance.generation) return out;
    if (out.known && full->second.second.step < out.cause.step) return out;
    return {.known = true, .cause = full->second.second};
}

}  // namespace fettle::property
