#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// A set of unordered pairs of shapes, each with the contact made for it: open addressing, linear
/// probing, deletion by shifting back, so that no tombstones pile up in a world that churns.
class PairSet {
  public:
    static constexpr uint32_t absent = 0xffffffffu;

    uint32_t find(uint32_t a, uint32_t b) const {
        if (slots_.empty()) return absent;
        const uint64_t key = key_of(a, b);
        for (std::size_t i = home(key);; i = (i + 1) & mask_) {
            if (slots_[i].key == key) return slots_[i].contact;
            if (slots_[i].key == 0) return absent;
        }
    }

    /// The pair must not be in the set.
    void insert(uint32_t a, uint32_t b, uint32_t contact) {
        if ((count_ + 1) * 2 > slots_.size()) enlarge();
        place({key_of(a, b), contact});
        ++count_;
    }

    void erase(uint32_t a, uint32_t b) {
        if (slots_.empty()) return;
        const uint64_t key = key_of(a, b);
        std::size_t hole = home(key);
        while (slots_[hole].key != key) {
            if (slots_[hole].key == 0) return;
            hole = (hole + 1) & mask_;
        }
        // Whoever was pushed past the hole by it moves back.
        for (std::size_t i = (hole + 1) & mask_; slots_[i].key != 0; i = (i + 1) & mask_) {
            const std::size_t distance = (i - home(slots_[i].key)) & mask_;
            if (distance >= ((i - hole) & mask_)) {
                slots_[hole] = slots_[i];
                hole = i;
            }
        }
        slots_[hole] = {};
        --count_;
    }

    std::size_t size() const { return count_; }
    /// Every contact is below `contacts` and a search ends, whatever the set came from.
    bool is_walkable(uint32_t contacts) const {
        if (slots_.empty()) return count_ == 0;
        if (!std::has_single_bit(slots_.size()) || mask_ != slots_.size() - 1) return false;
        std::size_t used = 0;
        for (const Slot& slot : slots_) {
            if (slot.key == 0) continue;
            if (slot.contact >= contacts) return false;
            ++used;
        }
        return used == count_ && used * 2 <= slots_.size();
    }

    /// For saving and restoring.
    template <class Io, class Self>
    static void members(Io& io, Self& self) {
        io(self.slots_), io(self.mask_), io(self.count_);
    }
    void clear() { *this = {}; }

  private:
    struct Slot {
        uint64_t key = 0;  // 0: empty
        uint32_t contact = 0;
    };

    /// Never 0: the greater index is at least 1.
    static uint64_t key_of(uint32_t a, uint32_t b) {
        return a < b ? (uint64_t{b} << 32 | a) : (uint64_t{a} << 32 | b);
    }
    std::size_t home(uint64_t key) const {
        key ^= key >> 29;
        key *= 0x9e3779b97f4a7c15u;  // 2⁶⁴ over the golden ratio
        return std::size_t(key >> 32) & mask_;
    }
    void place(const Slot& slot) {
        std::size_t i = home(slot.key);
        while (slots_[i].key != 0) i = (i + 1) & mask_;
        slots_[i] = slot;
    }
    void enlarge() {
        std::vector<Slot> old(slots_.empty() ? 64 : slots_.size() * 2);
        old.swap(slots_);
        mask_ = slots_.size() - 1;
        for (const Slot& slot : old) {
            if (slot.key != 0) place(slot);
        }
    }

    std::vector<Slot> slots_;
    std::size_t mask_ = 0;
    std::size_t count_ = 0;
};

}  // namespace fettle::physics::detail
