// Selects tweaks by a pattern of paths.

#include <fettle/property/path.h>

#include <tweaks/tweaks_state.h>

namespace fettle::property {

namespace {

std::vector<std::string> names_in(const std::string& path) {
    std::vector<std::string> names;
    for (const Segment& segment : parse_path(path))
        names.push_back(segment.is_index() ? std::to_string(std::get<std::int64_t>(segment.key))
                                           : std::get<std::string>(segment.key));
    return names;
}

}  // namespace

std::string path_of(const JournalRow& row) {
    if (row.kind != JournalRow::Kind::value) return row.instance;
    return path_below(row.instance, row.property);
}

TweakPattern::TweakPattern(std::string_view text)
    : pattern_(text), whole_instances_(text.find('*') == std::string_view::npos) {}

bool TweakPattern::matches(const JournalRow& row) const {
    std::vector<std::string> names = names_in(path_of(row));
    while (!names.empty()) {
        if (pattern_.matches(names)) return true;
        if (!whole_instances_) return false;
        names.pop_back();
    }
    return pattern_.text() == "game";
}

}  // namespace fettle::property
