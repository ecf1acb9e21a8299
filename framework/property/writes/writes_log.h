#pragma once
// Who wrote last. Every edit leaves its entry in a log: the typed ways put theirs there as they
// write, so that it costs a callback of a game next to nothing. Edits by people and changes of
// watched cells also keep where they came from.

#include <array>
#include <cassert>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/history.h>
#include <fettle/property/observer.h>

#include <instances/cell.h>

#include "packed_writes.h"

namespace fettle::property {

class WritesLog {
  public:
    WritesLog() { spare_.reserve(most_spare); }
    /// It is time to tell of them: no other write can begin.
    bool full() const { return next_ == end_; }
    /// A write of the shortest way can begin: all that could be against it and does not depend on
    /// the cell is in this one answer.
    bool open() const { return next_ < open_end_; }
    /// Why the shortest way is closed: what is written is an edit to be recorded, a formula runs,
    /// an inquiry is made, or a cell has a shadow.
    enum class Reason : std::uint8_t { recorded = 1, formula = 2, inquiry = 4, shadow = 8 };
    void close(Reason reason, bool closed) {
        const auto bit = static_cast<std::uint8_t>(reason);
        reasons_ = static_cast<std::uint8_t>(closed ? reasons_ | bit : reasons_ & ~bit);
        set_end();
    }
    bool closed_for(Reason reason) const {
        return (reasons_ & static_cast<std::uint8_t>(reason)) != 0;
    }
    /// What is written is an edit to be recorded, or not allowed.
    bool only_the_long_way() const {
        return (reasons_ & ~static_cast<std::uint8_t>(Reason::shadow)) != 0;
    }
    /// A write of the typed ways begins: its entry, to be filled in. It counts unless it is taken
    /// back; a setter may itself write before that is known.
    PlainWrite& begin() { return *next_++; }
    void take_back(PlainWrite& entry);
    /// The one that began last. Nobody may have been told since.
    void take_back_last() {
        assert(any_untold());
        next_ -= any_untold();
    }

    /// What has begun and was not yet told of.
    PlainWrites untold() const { return {{untold_, next_}, chunk_}; }
    bool any_untold() const { return next_ != untold_; }
    /// How many have begun. Falls by one where the last is taken back.
    std::uint64_t ever() const { return told_ + static_cast<std::uint64_t>(next_ - untold_); }
    /// Says who wrote them, and when.
    void tell(Writer writer, std::uint64_t step);

    /// A write of any other kind. Nothing may be untold.
    void note(Handle instance, const Property& property, Writer writer, std::uint64_t step) {
        begin() = {.instance = instance, .property = &property};
        tell(writer, step);
    }
    void note_in_full(Handle instance, Symbol property, const Cause& cause) {
        if (full_.size() >= most) full_.clear();
        full_[{instance.index, property}] = {instance.generation, cause};
    }
    /// The tree is what it was at `step`: whatever was written later is no longer there, and what
    /// there is in its place was restored.
    void went_back(std::uint64_t step);
    Provenance find(Handle instance, Symbol property) const;

  private:
    static constexpr std::size_t most = std::size_t{1} << 18;
    // As many as may be untold: they stay in the nearest cache.
    static constexpr std::size_t in_chunk = 512;
    static constexpr std::size_t most_spare = 64;
    using Chunk = std::array<PlainWrite, in_chunk>;

    /// One after the other by one writer in one step.
    struct Run {
        std::uint64_t end;  // how many writes there had been after it
        std::uint64_t step;
        Writer writer;
    };

    void next_chunk();
    void set_end() { open_end_ = reasons_ == 0 ? end_ : nullptr; }
    PackedWrites::Found last_packed(std::uint32_t index, Symbol property) const;

    std::shared_ptr<Chunk> chunk_ = std::make_shared<Chunk>();  // is filled
    std::vector<std::shared_ptr<Chunk>> spare_;  // were full; used again when nobody keeps them
    std::deque<PackedWrites> packed_;            // what was in full ones
    std::uint64_t first_ = 0;  // how many writes there had been before those in `packed_`
    PlainWrite* untold_ = chunk_->data();
    PlainWrite* next_ = untold_;
    PlainWrite* end_ = untold_ + in_chunk;
    PlainWrite* open_end_ = end_;  // nullptr where the shortest way is closed
    std::uint8_t reasons_ = 0;
    std::uint64_t told_ = 0;  // writes that were told, ever
    std::deque<Run> runs_;
    std::unordered_map<Cell, std::pair<std::uint32_t, Cause>, CellHash> full_;
};

}  // namespace fettle::property
