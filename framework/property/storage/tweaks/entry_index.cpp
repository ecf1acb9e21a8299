// Finding tweaks by the instances that they are about and that they name.

#include <algorithm>

#include <tweaks/tweaks_state.h>

namespace fettle::property {

bool Tweaks::State::may_name(const Entry& entry) {
    const auto has_text = [](const std::string& json) {
        return json.find('"') != std::string::npos;
    };
    if (entry.row.kind == Kind::value)
        return has_text(entry.was.value) || has_text(entry.now.value);
    return entry.row.kind == Kind::created ? entry.values.may_name() : has_text(entry.scene);
}

void Tweaks::State::index(Entry& entry) {
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
