// Adding tweaks, and finding them by the instances that they are about and that they name.

#include <algorithm>
#include <utility>

#include <tweaks/tweaks_state.h>

namespace fettle::property {

Tweaks::State::Entry& Tweaks::State::entry(Kind kind, const std::string& instance,
                                           const std::string& property, Handle handle,
                                           bool* begins) {
    Entry*& found = by_key[key_of(kind, instance, property)];
    // An entry that a deletion has made void belongs to the deleted instance, not to the next one
    // of that path.
    const bool other = found == nullptr || (found->deletion != nullptr && found->handle != handle);
    if (begins != nullptr) *begins = other || found->away;
    if (other) {
        found = &add_entry(kind, instance, handle);
    } else if (std::exchange(found->away, false)) {
        const std::int64_t number = found->row.number;
        static_cast<EntryState&>(*found) = {};
        found->row.number = number;
        found->row.kind = kind;
        found->row.instance = instance;
    }
    found->row.property = property;
    found->handle = handle;
    return *found;
}

/// Adds an entry that cannot be found by its path, because several instances may have had that
/// path.
Tweaks::State::Entry& Tweaks::State::add_entry(Kind kind, const std::string& instance,
                                               Handle handle) {
    Entry& its = *entries.emplace_back(std::make_unique<Entry>());
    its.row.kind = kind;
    its.row.number = ++last_number;
    its.row.instance = instance;
    its.handle = handle;
    index(its);
    return its;
}

bool Tweaks::State::may_name(const Entry& entry) {
    const auto has_text = [](const std::string& json) {
        return json.find('"') != std::string::npos;
    };
    if (entry.row.kind == Kind::value)
        return has_text(entry.was.value) || has_text(entry.now.value);
    return entry.row.kind == Kind::created ? entry.values.may_name() : has_text(entry.scene);
}

void Tweaks::State::index(Entry& entry) {
    entry.saved = nullptr;
    moments.last = nullptr;
    if (may_name(entry))
        naming.insert(&entry);
    else
        naming.erase(&entry);
    if (entry.row.kind == Kind::restored) return;  // its path follows from all moves
    const bool moves = entry.row.kind == Kind::moved || entry.row.kind == Kind::deleted;
    const std::string& path = moves ? entry.row.now : entry.row.instance;
    if (path == entry.found_at) return;
    if (!entry.found_at.empty()) {
        auto [at, end] = by_path.equal_range(entry.found_at);
        while (at != end && at->second != &entry) ++at;
        if (at != end) by_path.erase(at);
    }
    if (!path.empty()) by_path.emplace(path, &entry);
    entry.found_at = path;
}

std::vector<Tweaks::State::Entry*> Tweaks::State::at_or_below(const std::string& path) const {
    std::vector<Entry*> found;
    for (auto at = by_path.lower_bound(path); at != by_path.end() && at->first.starts_with(path);
         ++at)
        if (is_at_or_below(at->first, path)) found.push_back(at->second);
    return in_order(std::move(found));
}

std::vector<Tweaks::State::Entry*> Tweaks::State::in_order(std::vector<Entry*> all) const {
    std::ranges::sort(all, {}, [](const Entry* each) { return each->row.number; });
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace fettle::property
