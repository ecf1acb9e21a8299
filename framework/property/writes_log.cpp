#include "writes_log.h"

#include <algorithm>

namespace fettle::property {

void WritesLog::append(std::span<const PlainWrite> writes, std::uint64_t in_common) {
    Write* to = ring_.get() + next_;
    for (const PlainWrite& write : writes)
        *to++ = {write.instance.index, write.property->symbol.id(),
                 in_common | std::uint64_t{write.instance.generation & 0xffffu} << 8};
    next_ = (next_ + writes.size()) % most;
}

void WritesLog::note(std::span<const PlainWrite> writes, Writer writer, std::uint64_t step) {
    const std::uint64_t in_common = pack({}, writer, step);
    while (!writes.empty()) {
        const std::size_t fit = std::min(writes.size(), most - next_);
        append(writes.first(fit), in_common);
        writes = writes.subspan(fit);
    }
}

Provenance WritesLog::find(Handle instance, Symbol property) const {
    Provenance out;
    for (std::size_t back = 1; back <= most; ++back) {
        const Write& write = ring_.get()[(next_ + most - back) % most];
        if (write.index == 0) break;  // no more yet
        if (write.index != instance.index || write.property != property.id()) continue;
        if ((write.packed >> 8 & 0xffffu) != (instance.generation & 0xffffu)) break;
        out.known = true;
        out.cause.writer = static_cast<Writer>(write.packed & 0xffu);
        out.cause.step = write.packed >> 24;
        break;
    }
    const auto full = full_.find({instance.index, property});
    if (full == full_.end() || full->second.first != instance.generation) return out;
    if (out.known && full->second.second.step < out.cause.step) return out;
    return {.known = true, .cause = full->second.second};
}

}  // namespace fettle::property
