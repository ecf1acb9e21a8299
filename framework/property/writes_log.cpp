#include "writes_log.h"

namespace fettle::property {

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
