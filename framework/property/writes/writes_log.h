#pragma once
// The log of the last writers. Every write leaves an entry. The typed functions write their entries
// directly, so the cost for a game is very small. Edits by people and changes of watched cells also
// store their full cause.

#include <array>
#include <cassert>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fettle/property/history.h>
#include <fettle/property/observer.h>

#include <instances/cell.h>

#include "packed_writes.h"

namespace fettle::property {

class WritesLog {
  public:
    WritesLog() { spare_.reserve(max_spare); }
    /// No further write can begin before the entries are reported.
    bool full() const { return next_ == end_; }
    /// Whether a write on the fastest path can begin. This tests all conditions that do not depend
    /// on the cell.
    bool open() const { return next_ < open_end_; }
    /// Reasons that close the fastest path: edits are recorded, a formula runs, an inquiry runs,
    /// a cell has a shadow, or the place of each write is kept.
    enum class Reason : std::uint8_t {
        recorded = 1,
        formula = 2,
        inquiry = 4,
        shadow = 8,
        located = 16
    };
    void close(Reason reason, bool closed) {
        const auto bit = static_cast<std::uint8_t>(reason);
        reasons_ = static_cast<std::uint8_t>(closed ? reasons_ | bit : reasons_ & ~bit);
        set_end();
    }
    bool closed_for(Reason reason) const {
        return (reasons_ & static_cast<std::uint8_t>(reason)) != 0;
    }
    /// Whether writes are recorded as edits, forbidden, or kept with their places.
    bool needs_general_write() const {
        return (reasons_ & ~static_cast<std::uint8_t>(Reason::shadow)) != 0;
    }
    /// Begins a typed write and returns its entry, which the caller fills in. The entry counts
    /// unless it is taken back. A setter may itself write before that is known.
    PlainWrite& begin() { return *next_++; }
    void take_back(PlainWrite& entry);
    /// Takes back the latest entry, which must not have been reported yet.
    void take_back_last() {
        assert(any_unreported());
        next_ -= any_unreported();
    }

    /// Entries that have begun and were not yet reported.
    PlainWrites unreported() const { return {{unreported_, next_}, chunk_}; }
    bool any_unreported() const { return next_ != unreported_; }
    /// Number of entries so far. Taking back the last one decreases it by one.
    std::uint64_t ever() const {
        return reported_ + static_cast<std::uint64_t>(next_ - unreported_);
    }
    /// Marks the entries as reported, with their writer and step. `repeated`: by repeating the
    /// past, which has its writers already.
    void mark_reported(Writer writer, std::uint64_t step, bool repeated = false);

    /// Logs a write of any other kind. All entries must have been reported.
    void note(Handle instance, const Property& property, Writer writer, std::uint64_t step) {
        begin() = {.instance = instance, .property = &property};
        mark_reported(writer, step);
    }
    /// `left`: the value after the write, if the simulation may change it without a report.
    void note_in_full(Handle instance, Symbol property, const Cause& cause, Value left = {});
    /// Must be called when all writes of a step were made: the next ones are in the states after
    /// later steps. All entries must have been reported.
    void end_step() { between_steps_ = true; }
    /// Must be called after the tree has gone from its state at step `from` to that at step `to`.
    /// If `from` was not the latest step, the writes since the last call are marked as lost,
    /// because they are not in the kept past.
    void note_jump(std::uint64_t from, std::uint64_t to);
    /// Must be called at the beginning of a step. If the game went back before it, the entries of
    /// this step and of later ones are marked as lost: they are on the abandoned timeline.
    void begin_step(std::uint64_t step);
    /// Must be called when the state of another past is restored that is the same up to `step`. The
    /// writer of later entries becomes `restore`, because the real ones are unknown.
    void forget_after(std::uint64_t step);
    /// Among the writes up to the step `now`. The writer is `restore` if there are only later ones.
    Provenance find(Handle instance, Symbol property, std::uint64_t now) const;
    /// A write, with the cause that `find` would return if it were the last one of its cell.
    struct Entry {
        Handle instance;
        std::uint32_t property = 0;  // the id of its symbol
        bool later = false;          // than the step `now`, or lost
        std::uint64_t number = 0;    // a later write has a greater one
        Cause cause{};
    };
    /// Calls `visit` with all writes, the latest first; and then with those that are noted in full.
    void each_backwards(std::uint64_t now, const std::function<void(const Entry&)>& visit) const;
    std::uint64_t arrival_step() const { return arrival_step_; }
    /// The value after the write; nil if it is not known.
    Value left_by(Handle instance, Symbol property, const Cause& write) const;

  private:
    static constexpr std::size_t max_count = std::size_t{1} << 18;
    // Number of entries that can wait for their report; a chunk fits into the L1 cache.
    static constexpr std::size_t in_chunk = 512;
    static constexpr std::size_t max_spare = 64;
    using Chunk = std::array<PlainWrite, in_chunk>;

    /// The states of the tree that contain a write. A write between two steps is in the state after
    /// the first one only as long as the second was not made.
    struct Presence {
        std::uint64_t from = 0;  // the first step
        bool between_steps = false;
        /// Whether a past that is the same up to `step` lacks the write.
        bool is_after(std::uint64_t step) const {
            return from > step || (between_steps && from == step);
        }
    };

    /// Consecutive writes by one writer in one step.
    struct Run {
        std::uint64_t end;  // number of all writes up to its end
        std::uint64_t step;
        Writer writer;
        bool lost = false;  // its writes are not in the present timeline
        Presence presence{};
    };

    struct FullWrite {
        std::uint32_t generation = 0;
        std::uint64_t number = 0;  // of all entries when it was logged: a later one is newer
        Cause cause{};
        Value left{};
        Presence presence{};
    };

    void next_chunk();
    void join_lost_runs();
    void set_end() { open_end_ = reasons_ == 0 ? end_ : nullptr; }
    const Run& run_of(std::uint64_t number) const;
    /// The last number of an entry of the cell that is at most `number`; 0 if there is none.
    std::uint64_t last_number(Handle instance, Symbol property, std::uint64_t number) const;

    std::shared_ptr<Chunk> chunk_ = std::make_shared<Chunk>();  // the chunk that is being filled
    std::vector<std::shared_ptr<Chunk>> spare_;  // former chunks, reused when unshared
    std::deque<PackedWrites> packed_;            // content of the full chunks
    std::uint64_t first_ = 0;                    // number of writes before those in `packed_`
    PlainWrite* unreported_ = chunk_->data();
    PlainWrite* next_ = unreported_;
    PlainWrite* end_ = unreported_ + in_chunk;
    PlainWrite* open_end_ = end_;  // nullptr while the fastest path is closed
    std::uint8_t reasons_ = 0;
    std::uint64_t reported_ = 0;  // number of writes that were ever reported
    std::deque<Run> runs_;
    std::uint64_t latest_step_ = 0;  // of entries that are not lost
    std::uint64_t arrival_step_ = 0;
    std::uint64_t arrived_ = 0;  // number of entries when the tree came to its state
    std::unordered_map<Cell, FullWrite, CellHash> full_;
    bool between_steps_ = false;
    std::unordered_set<Cell, CellHash> full_between_;  // of `full_`: written since the last step
};

}  // namespace fettle::property
