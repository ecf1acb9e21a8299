#pragma once
// Who wrote last. Every edit leaves sixteen bytes in a ring, which costs a callback of a game next
// to nothing; edits by people and changes of watched cells also keep where they came from.

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/history.h>
#include <fettle/property/observer.h>

#include "watchers.h"

namespace fettle::property {

class WritesLog {
  public:
    void note(Handle instance, Symbol property, Writer writer, std::uint64_t step) {
        ring_.get()[next_] = {instance.index, property.id(), pack(instance, writer, step)};
        next_ = (next_ + 1) % most;
    }
    /// Several by one writer in one step: what scripts write most.
    void note(std::span<const PlainWrite> writes, Writer writer, std::uint64_t step);
    void note_in_full(Handle instance, Symbol property, const Cause& cause) {
        if (full_.size() >= most) full_.clear();
        full_[{instance.index, property}] = {instance.generation, cause};
    }
    Provenance find(Handle instance, Symbol property) const;

  private:
    static constexpr std::size_t most = std::size_t{1} << 18;
    struct Write {
        std::uint32_t index, property;
        std::uint64_t packed;
    };
    // 40 bits of step, 16 of generation (a slot's next owner has been written by nobody yet), 8 of
    // writer.
    static std::uint64_t pack(Handle instance, Writer writer, std::uint64_t step) {
        return step << 24 | std::uint64_t{instance.generation & 0xffffu} << 8 |
               static_cast<std::uint64_t>(writer);
    }
    /// No more than fit before the end of the ring.
    void append(std::span<const PlainWrite> writes, std::uint64_t in_common);

    // Zeroed by the system as it is first touched, so that a game which writes little has little of
    // it. Zero is nobody's index.
    struct Free {
        void operator()(Write* ring) const { std::free(ring); }
    };
    static Write* new_ring() {
        void* const ring = std::calloc(most, sizeof(Write));
        if (ring == nullptr) throw std::bad_alloc();
        return static_cast<Write*>(ring);
    }
    std::unique_ptr<Write, Free> ring_{new_ring()};
    std::size_t next_ = 0;
    std::unordered_map<Cell, std::pair<std::uint32_t, Cause>, CellHash> full_;
};

}  // namespace fettle::property
