// The emitters' part of a snapshot: the particles byte for byte.

#include <cmath>
#include <memory>
#include <vector>

#include <emitters/emitters.h>
#include <fettle/property/restoring.h>

namespace fettle::visuals {

using property::Handle;

namespace {

bool is_finite(const property::Transform& t) {
    return t.x.is_finite() && t.y.is_finite() && t.origin.is_finite();
}

}  // namespace

void Emitters::save(property::ByteWriter& to) const {
    to.put(std::uint64_t{rows_.size()});
    for (const Row& row : rows_) {
        const State& s = row.state;
        to.put(s.self);
        to.put(s.born);
        to.put(s.owed);
        to.put(s.last_dt);
        to.put(s.at);
        to.put(s.wanted);
        for (const bool flag : {s.placed, s.burst, s.busy}) to.put(std::uint8_t{flag});
        to.put(row.particles);
    }
    to.put(free_);
}

std::function<void()> Emitters::restore(property::ByteReader& from) {
    auto rows = std::make_shared<std::vector<Row>>();
    // 8 bytes for each row at least, so that no memory is allocated for a wrong, large count.
    for (std::size_t n = from.count(8); n > 0; --n) {
        Row row;
        State& s = row.state;
        s.self = from.get<Handle>();
        s.born = from.get<std::uint64_t>();
        s.owed = from.get<double>();
        s.last_dt = from.get<double>();
        s.at = from.get<property::Transform>();
        s.wanted = from.get<std::uint32_t>();
        s.placed = from.boolean();
        s.burst = from.boolean();
        s.busy = from.boolean();
        from.require(s.owed >= 0 && s.owed <= 1 && std::isfinite(s.last_dt) && is_finite(s.at),
                     "an emitter");
        row.particles = from.list<Particle>();
        for (const Particle& p : row.particles) from.require(is_valid(p), "a particle");
        rows->push_back(std::move(row));
    }
    auto free = std::make_shared<std::vector<property::Row>>(from.list<property::Row>());
    std::vector<bool> used(rows->size());
    std::size_t count = free->size();
    for (const property::Row row : *free) {
        from.require(row < rows->size() && !used[row] && !(*rows)[row].state.self, "a free row");
        used[row] = true;
    }
    property::each_restored(*tree_, [&](Handle self, const property::Class& of, property::Row row) {
        if (!of.is_a(*class_)) return;
        from.require(row < rows->size() && !used[row] && (*rows)[row].state.self == self,
                     "the row of an emitter");
        used[row] = true;
        ++count;
    });
    from.require(count == rows->size(), "a row without an emitter");
    return [this, rows, free] {
        rows_ = std::move(*rows);
        free_ = std::move(*free);
        ended_.clear();
    };
}

}  // namespace fettle::visuals
