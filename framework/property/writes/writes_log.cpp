#include "writes_log.h"

#include <algorithm>
#include <iterator>

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

void WritesLog::mark_reported(Writer writer, std::uint64_t step, bool repeated) {
    const std::uint64_t count = ever();
    const bool both_lost = repeated && !runs_.empty() && runs_.back().lost;
    if (both_lost) {
        // Nobody asks for the writer of lost writes, so one run is enough for all of them.
    } else if (runs_.empty() || runs_.back().writer != writer || runs_.back().step != step ||
               runs_.back().lost != repeated || runs_.back().end == arrived_ ||
               runs_.back().presence.between_steps != between_steps_) {
        while (!runs_.empty() && runs_.front().end + max_count <= count) runs_.pop_front();
        runs_.push_back({.end = reported_,
                         .step = step,
                         .writer = writer,
                         .lost = repeated,
                         .presence = {.from = step, .between_steps = between_steps_}});
    }
    if (!repeated) latest_step_ = std::max(latest_step_, step);
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

// Going back step by step loses a run at each step. One run is enough for all of them, and each
// step looks at the last runs.
void WritesLog::join_lost_runs() {
    while (runs_.size() > 1 && runs_.back().lost && runs_[runs_.size() - 2].lost) {
        runs_[runs_.size() - 2].end = runs_.back().end;
        runs_.pop_back();
    }
}

void WritesLog::note_in_full(Handle instance, Symbol property, const Cause& cause, Value left) {
    if (full_.size() >= max_count) {
        full_.clear();
        full_between_.clear();
    }
    const Cell cell{instance.index, property};
    full_[cell] = {.generation = instance.generation,
                   .number = ever(),
                   .cause = cause,
                   .left = std::move(left),
                   .presence = {.from = cause.step, .between_steps = between_steps_}};
    if (between_steps_) full_between_.insert(cell);
}

void WritesLog::note_jump(std::uint64_t from, std::uint64_t to) {
    arrival_step_ = to;
    between_steps_ = true;
    if (from == to) return;
    if (latest_step_ > from) {
        for (Run& run : runs_)
            if (run.end > arrived_) run.lost = true;
        join_lost_runs();
        std::erase_if(full_, [&](const auto& each) {
            const Presence& its = each.second.presence;
            return its.between_steps && its.from == from;
        });
    }
    arrived_ = reported_;
}

void WritesLog::begin_step(std::uint64_t step) {
    if (latest_step_ >= step && step != 0) {
        for (Run& run : runs_)
            if (run.presence.from >= step) run.lost = true;
        join_lost_runs();
        std::erase_if(full_, [&](const auto& each) { return each.second.presence.from >= step; });
        latest_step_ = step - 1;
    }
    between_steps_ = false;
    if (step == 0) return;
    // What was written after the last step is in the states from this one on.
    const auto move = [&](Presence& its) {
        if (its.between_steps && its.from == step - 1) its.from = latest_step_ = step;
    };
    for (auto run = runs_.rbegin(); run != runs_.rend(); ++run)
        if (!run->lost) {
            if (run->step + 1 < step) break;
            move(run->presence);
        }
    for (const Cell& cell : full_between_)
        if (const auto full = full_.find(cell); full != full_.end()) move(full->second.presence);
    full_between_.clear();
}

void WritesLog::forget_after(std::uint64_t step) {
    for (Run& run : runs_)
        if (run.presence.is_after(step))
            run = {.end = run.end,
                   .step = step,
                   .writer = Writer::restore,
                   .presence = {.from = step, .between_steps = false}};
    std::erase_if(full_, [&](const auto& each) { return each.second.presence.is_after(step); });
    latest_step_ = std::min(latest_step_, step);
}

const WritesLog::Run& WritesLog::run_of(std::uint64_t number) const {
    return *std::lower_bound(runs_.begin(), runs_.end(), number,
                             [](const Run& r, std::uint64_t n) { return r.end < n; });
}

std::uint64_t WritesLog::last_number(Handle instance, Symbol property, std::uint64_t number) const {
    const std::uint64_t packed = first_ + packed_.size() * in_chunk;
    for (; number > packed; --number) {
        const PlainWrite& write = (*chunk_)[number - packed - 1];
        if (write.instance == instance && write.property->symbol == property) return number;
    }
    while (number > first_) {
        const std::size_t piece = (number - first_ - 1) / in_chunk;
        const std::uint64_t before = first_ + piece * in_chunk;
        const PackedWrites::Found found =
            packed_[piece].last(instance.index, property, number - before);
        // The write belongs to the instance only if the generation matches.
        if (found.number != 0 && found.generation == instance.generation)
            return before + found.number;
        number = found.number == 0 ? before : before + found.number - 1;
    }
    return 0;
}

Provenance WritesLog::find(Handle instance, Symbol property, std::uint64_t now) const {
    Provenance out;
    bool later = false;
    std::uint64_t number = last_number(instance, property, reported_);
    for (; number != 0; number = last_number(instance, property, number - 1)) {
        const Run& run = run_of(number);
        if (!run.lost && run.presence.from <= now) {
            out = {.known = true, .cause = {.writer = run.writer, .where = {}, .step = run.step}};
            break;
        }
        later = true;
    }
    const auto full = full_.find({instance.index, property});
    if (full != full_.end() && full->second.generation == instance.generation) {
        const Cause& cause = full->second.cause;
        if (full->second.presence.from <= now && (!out.known || full->second.number >= number))
            return {.known = true, .cause = cause};
    }
    if (!out.known && later)
        return {.known = true,
                .cause = {.writer = Writer::restore, .where = {}, .step = arrival_step_}};
    return out;
}

void WritesLog::each_backwards(std::uint64_t now,
                               const std::function<void(const Entry&)>& visit) const {
    auto run = runs_.rbegin();
    // The number of the first write of a run is one more than the end of the run before it.
    const auto report = [&](std::uint64_t number, Handle instance, std::uint32_t property) {
        while (run != runs_.rend() && std::next(run) != runs_.rend() &&
               std::next(run)->end >= number)
            ++run;
        if (run == runs_.rend()) return;
        const bool later = run->lost || run->presence.from > now;
        const Cause cause{.writer = run->writer, .where = {}, .step = run->step};
        visit({instance, property, later, number, cause});
    };
    const std::uint64_t packed = first_ + packed_.size() * in_chunk;
    for (std::uint64_t number = reported_; number > packed; --number) {
        const PlainWrite& write = (*chunk_)[number - packed - 1];
        if (write.property != nullptr) report(number, write.instance, write.property->symbol.id());
    }
    for (std::size_t piece = packed_.size(); piece-- > 0;)
        for (std::size_t i = packed_[piece].count(); i-- > 0;) {
            const PackedWrites::Write write = packed_[piece].at(i);
            report(first_ + piece * in_chunk + i + 1, write.instance, write.property);
        }
    for (const auto& [cell, full] : full_)
        if (full.presence.from <= now)
            visit({{cell.index, full.generation},
                   cell.property.id(),
                   false,
                   full.number,
                   full.cause});
}

Value WritesLog::left_by(Handle instance, Symbol property, const Cause& write) const {
    const auto full = full_.find({instance.index, property});
    const bool found = full != full_.end() && full->second.generation == instance.generation &&
                       full->second.cause.step == write.step &&
                       full->second.cause.writer == write.writer;
    return found ? full->second.left : Value();
}

}  // namespace fettle::property
