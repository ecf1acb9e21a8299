#include "writes_log.h"

#include <algorithm>

namespace fettle::property {

// The log keeps the written cells for a long time. The old values are kept only as long as a reader
// holds their chunk.
void WritesLog::next_chunk() {
    PackedWrites packed(*chunk_);
    const bool one_is_free = !spare_.empty() && spare_.front().use_count() == 1;
    std::shared_ptr<Chunk> next = one_is_free ? spare_.front() : std::make_shared<Chunk>();
    packed_.push_back(std::move(packed));
    if (one_is_free) spare_.erase(spare_.begin());
    if (spare_.size() < max_spare) spare_.push_back(chunk_);
    if (packed_.size() == max_count / in_chunk) {
        packed_.pop_front();
        first_ += in_chunk;
    }
    chunk_ = std::move(next);
    next_ = chunk_->data();
    end_ = next_ + in_chunk;
    set_end();
}

void WritesLog::tell(Writer writer, std::uint64_t step) {
    const std::uint64_t count = ever();
    if (runs_.empty() || runs_.back().writer != writer || runs_.back().step != step) {
        while (!runs_.empty() && runs_.front().end + max_count <= count) runs_.pop_front();
        runs_.push_back({.end = reported_, .step = step, .writer = writer});
    }
    // Allocations up to here may fail; then nothing has been reported yet.
    if (next_ == end_) next_chunk();
    runs_.back().end = reported_ = count;
    unreported_ = next_;
}

void WritesLog::take_back(PlainWrite& entry) {
    if (&entry + 1 == next_ && &entry >= unreported_)
        --next_;
    else if (&entry >= unreported_ && &entry < next_)
        // Later entries exist, so this entry stays and is marked as belonging to no instance.
        entry.instance = {};
}

void WritesLog::went_back(std::uint64_t step) {
    for (Run& run : runs_)
        if (run.step > step) run = {.end = run.end, .step = step, .writer = Writer::restore};
    for (auto& [cell, written] : full_)
        if (written.second.step > step)
            written.second = {.writer = Writer::restore, .where = {}, .step = step};
}

/// Searches the full chunks. Numbers count from `first_`.
PackedWrites::Found WritesLog::last_packed(std::uint32_t index, Symbol property) const {
    for (std::size_t piece = packed_.size(); piece > 0; --piece) {
        PackedWrites::Found found = packed_[piece - 1].last(index, property);
        if (found.number == 0) continue;
        found.number += (piece - 1) * in_chunk;
        return found;
    }
    return {};
}

Provenance WritesLog::find(Handle instance, Symbol property) const {
    Provenance out;
    std::uint64_t number = reported_;
    const PlainWrite* write = unreported_;
    const auto is_it = [&](const PlainWrite& w) {
        return w.instance.index == instance.index && w.property->symbol == property;
    };
    while (write != chunk_->data() && !is_it(*(write - 1))) --write, --number;
    std::uint32_t generation = 0;
    if (write != chunk_->data()) {
        generation = (write - 1)->instance.generation;
    } else {
        const PackedWrites::Found found = last_packed(instance.index, property);
        number = found.number == 0 ? 0 : first_ + found.number;
        generation = found.generation;
    }
    // The write belongs to the instance only if the generation matches.
    if (number != 0 && generation == instance.generation) {
        const auto run = std::lower_bound(runs_.begin(), runs_.end(), number,
                                          [](const Run& r, std::uint64_t n) { return r.end < n; });
        out.known = true;
        out.cause.writer = run->writer;
        out.cause.step = run->step;
    }
    const auto full = full_.find({instance.index, property});
    if (full == full_.end() || full->second.first != instance.generation) return out;
    if (out.known && full->second.second.step < out.cause.step) return out;
    return {.known = true, .cause = full->second.second};
}

}  // namespace fettle::property
