#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// A set of unordered pairs of shapes, each with its contact: open addressing, linear probing,
/// deletion by shifting back, so that no tombstones accumulate in a world with many new and ended
/// pairs.
class PairSet {
  public:
    static constexpr uint32_t absent = 0xffffffffu;

    uint32_t find(uint32_t a, uint32_t b) const {
        if (slots_.empty()) return absent;
        const Pair pair = pair_of(a, b);
        for (std::size_t i = home(pair);; i = after(i)) {
            if (slots_[i].pair == pair) return slots_[i].contact;
            if (slots_[i].is_empty()) return absent;
        }
    }

    void prefetch(uint32_t a, uint32_t b) const {
        if (!slots_.empty()) __builtin_prefetch(&slots_[home(pair_of(a, b))], 1);
    }

    /// The pair must not be in the set.
    void insert(uint32_t a, uint32_t b, uint32_t contact) {
        if (!has_room(count_ + 1)) enlarge();
        place({pair_of(a, b), contact});
        ++count_;
    }

    void erase(uint32_t a, uint32_t b) {
        if (slots_.empty()) return;
        const Pair pair = pair_of(a, b);
        std::size_t hole = home(pair);
        while (!(slots_[hole].pair == pair)) {
            if (slots_[hole].is_empty()) return;
            hole = after(hole);
        }
        // Entries behind the hole move back if the hole is nearer to their home.
        for (std::size_t i = after(hole); !slots_[i].is_empty(); i = after(i)) {
            if (distance(home(slots_[i].pair), i) >= distance(hole, i)) {
                slots_[hole] = slots_[i];
                hole = i;
            }
        }
        slots_[hole] = {};
        --count_;
    }

    std::size_t size() const { return count_; }
    /// False if deserialized data are damaged. If true, every contact is below `contacts`, and
    /// every search ends.
    bool is_walkable(uint32_t contacts) const {
        std::size_t used = 0;
        for (const Slot& slot : slots_) {
            if (slot.is_empty()) continue;
            if (slot.contact >= contacts) return false;
            ++used;
        }
        return used == count_ && has_room(used);
    }

    /// For saving and restoring.
    static void members(auto& io, auto& self) { io(self.slots_), io(self.count_); }
    void clear() { *this = {}; }

  private:
    struct Pair {
        uint32_t lower = 0, upper = 0;
        bool operator==(const Pair&) const = default;
    };
    struct Slot {
        Pair pair;
        uint32_t contact = 0;
        bool is_empty() const { return pair.upper == 0; }  // `upper` of a pair is at least 1
    };
    static_assert(sizeof(Slot) == 12);

    static Pair pair_of(uint32_t a, uint32_t b) { return a < b ? Pair{a, b} : Pair{b, a}; }
    /// The upper half of a hash, scaled to the size of the table. So any table size works, and a
    /// growing table is read and written in order.
    std::size_t home(Pair pair) const {
        uint64_t key = uint64_t{pair.upper} << 32 | pair.lower;
        key ^= key >> 29;
        key *= 0x9e3779b97f4a7c15u;  // 2⁶⁴ divided by the golden ratio
        key ^= key >> 32;
        key *= 0x9e3779b97f4a7c15u;
        return std::size_t((key >> 32) * slots_.size() >> 32);
    }
    std::size_t after(std::size_t i) const { return i + 1 < slots_.size() ? i + 1 : 0; }
    std::size_t distance(std::size_t from, std::size_t to) const {
        return to >= from ? to - from : to + slots_.size() - from;
    }
    /// At most two thirds of the table are in use.
    bool has_room(std::size_t count) const { return count * 3 <= slots_.size() * 2; }
    void place(const Slot& slot) {
        std::size_t i = home(slot.pair);
        while (!slots_[i].is_empty()) i = after(i);
        slots_[i] = slot;
    }
    void enlarge() {
        std::vector<Slot> old(slots_.size() + slots_.size() / 5 + 32);
        old.swap(slots_);
        for (const Slot& slot : old) {
            if (!slot.is_empty()) place(slot);
        }
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

}  // namespace fettle::physics::detail
