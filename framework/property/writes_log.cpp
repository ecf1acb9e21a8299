#include "writes_log.h"

#include <algorithm>

namespace fettle::property {

// The oldest chunk is used again, unless somebody keeps it.
void WritesLog::add_chunk() {
    std::shared_ptr<Chunk> chunk;
    if (chunks_.size() == most / in_chunk) {
        chunk = std::move(chunks_.front());
        chunks_.pop_front();
        first_ += in_chunk;
    }
    if (chunk == nullptr || chunk.use_count() > 1) chunk = std::make_shared<Chunk>();
    chunks_.push_back(std::move(chunk));
    next_ = chunks_.back()->data();
    end_ = next_ + in_chunk;
    open(open_);
}

void WritesLog::tell(Writer writer, std::uint64_t step) {
    const std::uint64_t told = ever();
    if (runs_.empty() || runs_.back().writer != writer || runs_.back().step != step) {
        while (!runs_.empty() && runs_.front().end + most <= told) runs_.pop_front();
        runs_.push_back({.end = told_, .step = step, .writer = writer});
    }
    // Up to here memory may be refused, and nothing has been told.
    if (next_ == end_) add_chunk();
    runs_.back().end = told_ = told;
    untold_ = next_;
}

void WritesLog::take_back(PlainWrite& entry) {
    if (&entry + 1 == next_ && &entry >= untold_)
        --next_;
    else if (&entry >= untold_ && &entry < next_)
        entry.instance = {};  // others came after it: nobody's
}

Provenance WritesLog::find(Handle instance, Symbol property) const {
    Provenance out;
    for (std::uint64_t number = told_; number > first_; --number) {
        const std::uint64_t at = number - 1 - first_;
        const PlainWrite& write = (*chunks_[at / in_chunk])[at % in_chunk];
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
