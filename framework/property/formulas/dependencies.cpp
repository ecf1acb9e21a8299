// Dependencies of a formula: every cell that its last run read.

#include <algorithm>
#include <utility>

#include "formulas.h"

namespace fettle::property {

/// Adds the formula to the dependents of a cell that it reads.
void Formulas::depend(Entry& e, std::uint32_t dependency) {
    Dependency& d = e.dependencies[dependency];
    std::vector<Dependent>& list = dependents_[d.cell].list;
    if (list.empty()) read_of_[d.cell.index].insert(d.cell.property);
    d.place = static_cast<std::uint32_t>(list.size());
    list.push_back({&e, dependency});
}

/// Removes a dependent. The last dependent takes its place, so the cost does not depend on the
/// length of the list.
void Formulas::remove_dependent(const Dependency& gone) {
    std::vector<Dependent>& list = dependents_.at(gone.cell).list;
    const Dependent last = list.back();
    list.pop_back();
    if (gone.place < list.size()) {
        list[gone.place] = last;
        last.formula->dependencies[last.dependency].place = gone.place;
    }
    if (!list.empty()) return;
    dependents_.erase(gone.cell);
    auto& names = read_of_.at(gone.cell.index);
    names.erase(gone.cell.property);
    if (names.empty()) read_of_.erase(gone.cell.index);
}

/// Replaces the dependencies of the formula. `places`: the index of each cell among them.
void Formulas::enter_dependencies(Entry& e, std::vector<Dependency> found, const Places& places) {
    std::vector<Dependency> before = std::exchange(e.dependencies, std::move(found));
    std::vector<Dependency>& now = e.dependencies;
    const auto same = [](const Dependency& a, const Dependency& b) { return a.cell == b.cell; };
    if (std::equal(before.begin(), before.end(), now.begin(), now.end(), same)) {
        for (std::size_t i = 0; i < now.size(); ++i) now[i].place = before[i].place;
        return;
    }
    std::vector<bool> kept(now.size(), false);
    for (const Dependency& d : before) {
        const auto found_again = places.find(d.cell);
        if (found_again == places.end()) {
            remove_dependent(d);
            continue;
        }
        const auto dependency = static_cast<std::uint32_t>(found_again->second);
        kept[dependency] = true;
        now[dependency].place = d.place;
        dependents_.at(d.cell).list[d.place].dependency = dependency;
    }
    for (std::uint32_t i = 0; i < now.size(); ++i)
        if (!kept[i]) depend(e, i);
}

void Formulas::set_dependencies(Entry& e, const std::vector<Read>& found) {
    // A second read of a cell adds nothing. A read of the value counts more than a look-up of the
    // name.
    Places places;
    std::vector<Dependency> distinct;
    for (const Read& read : found) {
        const auto [place, first] = places.try_emplace(read.cell, distinct.size());
        if (first)
            distinct.push_back({read});
        else if (distinct[place->second].property == nullptr)
            distinct[place->second] = {read};
    }
    enter_dependencies(e, std::move(distinct), places);
    bool is_volatile = false;
    for (std::uint32_t i = 0; i < e.dependencies.size(); ++i) {
        Dependency& d = e.dependencies[i];
        if (const Entry* source = entry(d.cell)) {
            d.formula = true;
            d.version = source->version;
            is_volatile = is_volatile || source->volatile_sources;
        }
        if (Node* node = changes_.instances.nodes.find(d.instance)) {
            node->has_dependents = true;
            if (d.property != nullptr && (d.property->simulated || d.property->read_only)) {
                d.observed = is_volatile = true;
                d.seen = tree_.peek(d.instance, *d.property);
            }
        }
    }
    if (is_volatile && !e.removed) {
        make_volatile(e);
    } else if (e.volatile_sources && !is_volatile && !e.removed) {
        e.volatile_sources = false;
        --volatile_;
    }
}

}  // namespace fettle::property
