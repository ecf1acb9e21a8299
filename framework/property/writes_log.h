#pragma once
// Who wrote last. Every edit leaves sixteen bytes in a ring, which costs a callback of a game next
// to nothing; edits by people and changes of watched cells also keep where they came from.

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/history.h>

#include "watchers.h"

namespace fettle::property {

class WritesLog {
  public:
    void note(Handle instance, Symbol property, Writer writer, std::uint64_t step) {
        const Write write{instance.index, property.id(), pack(instance, writer, step)};
        if (ring_.size() < most)
            ring_.push_back(write);
        else
            ring_[next_] = write;
        next_ = (next_ + 1) % most;
    }
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

    std::vector<Write> ring_;
    std::size_t next_ = 0;
    std::unordered_map<Cell, std::pair<std::uint32_t, Cause>, CellHash> full_;
};

}  // namespace fettle::property
