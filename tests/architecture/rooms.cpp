#include <algorithm>
#include <set>
#include <string_view>

#include "rules.h"

namespace fettle::architecture {
namespace {

/// A room: a folder of physics, and which other rooms it may include.
struct Room {
    std::string_view name;
    std::set<std::string_view> may_know;
};

// From the bottom to the top: a room knows only rooms above it in this table, so no two rooms know
// each other. The public headers and the module of physics lie in no room.
const std::vector<Room>& rooms() {
    static const std::vector<Room> table = {
        {"geometry", {}},
        {"threads", {}},
        {"simd", {}},
        {"broad_phase", {"geometry", "threads", "simd"}},
        {"collision", {"geometry", "simd"}},
        {"constraints", {"geometry", "simd", "collision"}},
        {"partition", {"geometry", "threads", "constraints"}},
        {"joints", {"geometry", "constraints", "partition"}},
        {"wide", {"simd", "broad_phase", "collision", "constraints"}},
        {"state",
         {"geometry", "threads", "broad_phase", "collision", "constraints", "partition", "joints"}},
        {"checks", {"geometry", "collision", "state"}},
        {"sleep", {"geometry", "partition", "state"}},
        {"contacts", {"geometry", "threads", "broad_phase", "collision", "wide", "state", "sleep"}},
        {"edits", {"geometry", "collision", "state", "sleep", "contacts"}},
        {"schedule", {"geometry", "threads", "constraints", "partition", "state"}},
        {"solver",
         {"geometry", "threads", "constraints", "partition", "joints", "wide", "state", "contacts",
          "schedule"}},
        {"step",
         {"geometry", "threads", "broad_phase", "collision", "constraints", "state", "contacts",
          "schedule"}},
        {"world",
         {"geometry", "threads", "broad_phase", "collision", "wide", "state", "sleep", "contacts",
          "edits", "schedule", "solver", "step", "checks"}},
    };
    return table;
}

/// The name of the room that `path` lies in; empty where there are no rooms.
std::string_view room_of(std::string_view path) {
    constexpr std::string_view part = "physics/";
    if (!path.starts_with(part)) return {};
    path.remove_prefix(part.size());
    const std::string_view name = path.substr(0, path.find('/'));
    return name == path || name == "include" || name == "module" ? std::string_view() : name;
}

}  // namespace

Violations forbidden_rooms(const SourceTree& tree) {
    Violations found;
    std::set<std::string_view> above;
    for (const Room& room : rooms()) {
        if (!std::ranges::includes(above, room.may_know))
            found.push_back(std::string(room.name) + " knows a room that does not stand above it");
        above.insert(room.name);
    }
    for (const auto& [path, file] : tree.files()) {
        const std::string_view name = room_of(path);
        if (name.empty()) continue;
        const auto room = std::ranges::find(rooms(), name, &Room::name);
        if (room == rooms().end()) {
            found.push_back(path + ": lies in no room of physics");
            continue;
        }
        for (const Include& include : file.includes()) {
            const std::string target = tree.resolve(file, include);
            const std::string_view other = room_of(target);
            if (!other.empty() && other != name && !room->may_know.contains(other))
                found.push_back(path + ":" + std::to_string(include.line) + ": " +
                                std::string(name) + " may not include " + target);
        }
    }
    return found;
}

}  // namespace fettle::architecture
