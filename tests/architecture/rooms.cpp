#include <algorithm>
#include <set>
#include <string_view>

#include "rules.h"

namespace fettle::architecture {
namespace {

/// A room: a folder of a part, and the other rooms of that part that it may include.
struct Room {
    std::string_view name;
    std::set<std::string_view> may_know;
};

/// A part that is divided into rooms. A room includes only rooms above it in this table, so no two
/// rooms include each other.
struct DividedPart {
    std::string_view name;
    std::string_view folder;            // ends in a slash
    std::set<std::string_view> beside;  // folders in it that are not rooms
    std::vector<Room> rooms;

    const Room* room_named(std::string_view wanted) const {
        const auto found = std::ranges::find(rooms, wanted, &Room::name);
        return found == rooms.end() ? nullptr : &*found;
    }
    /// The name of the room that contains `path`; empty if no room does.
    std::string_view room_of(std::string_view path) const {
        if (!path.starts_with(folder)) return {};
        path.remove_prefix(folder.size());
        const std::string_view first = path.substr(0, path.find('/'));
        return first == path || beside.contains(first) ? std::string_view() : first;
    }
};

const std::vector<DividedPart>& divided_parts() {
    static const std::vector<DividedPart> table = {
        // The public headers and the module of physics are not in a room.
        {"physics",
         "physics/",
         {"include", "module"},
         {
             {"geometry", {}},
             {"threads", {}},
             {"simd", {}},
             {"broad_phase", {"geometry", "threads", "simd"}},
             {"collision", {"geometry", "simd"}},
             {"forms", {"geometry", "collision"}},
             {"distance", {"geometry", "collision"}},
             {"constraints", {"geometry", "simd", "collision"}},
             {"partition", {"geometry", "threads", "constraints"}},
             {"wide", {"simd", "broad_phase", "collision", "constraints"}},
             {"state",
              {"geometry", "threads", "broad_phase", "collision", "constraints", "partition"}},
             {"checks", {"geometry", "state"}},
             {"sleep", {"geometry", "partition", "state"}},
             {"contacts",
              {"geometry", "threads", "broad_phase", "collision", "wide", "state", "sleep"}},
             {"edits", {"geometry", "collision", "forms", "state", "sleep", "contacts"}},
             {"schedule", {"geometry", "threads", "constraints", "partition", "state"}},
             {"solver",
              {"geometry", "threads", "constraints", "partition", "wide", "state", "contacts",
               "schedule"}},
             {"step",
              {"geometry", "threads", "broad_phase", "collision", "distance", "constraints",
               "state", "sleep", "contacts", "schedule"}},
             {"world",
              {"geometry", "threads", "broad_phase", "collision", "wide", "state", "sleep",
               "contacts", "edits", "schedule", "solver", "step", "checks"}},
             {"handles", {"geometry", "state", "contacts", "step", "checks", "world"}},
             {"queries",
              {"geometry", "forms", "distance", "contacts", "state", "checks", "world", "handles"}},
             {"mover",
              {"geometry", "collision", "distance", "contacts", "state", "checks", "step", "world",
               "queries"}},
             {"saving", {"collision", "state", "checks", "world"}},
             {"recording", {"state", "world", "saving"}},
             {"joints", {"constraints", "state", "checks", "solver", "world"}},
             {"standalone", {"geometry", "collision", "forms", "distance", "checks"}},
         }},
        {"physics_c",
         "bindings/c/",
         {"include"},
         {
             {"calls", {}},
             {"geometry", {"calls"}},
             {"objects", {"calls"}},
             {"joints", {"calls"}},
             {"world", {"calls"}},
         }},
        // The public `PhysicsModule`, which uses all rooms, is not in a room.
        {"physics_module",
         "physics/module/",
         {"plugin"},
         {
             {"hosting", {}},
             {"bindings", {"hosting"}},
             {"drawing", {"hosting", "bindings"}},
             {"events", {"hosting", "bindings"}},
             {"bodies", {"hosting", "bindings", "drawing", "events"}},
             {"shapes", {"hosting", "bindings", "drawing", "events"}},
             {"joints", {"hosting", "bindings"}},
             {"fields", {"hosting", "bindings"}},
             {"movers", {"hosting", "bindings", "drawing", "events"}},
             {"worlds", {"hosting", "bindings", "drawing", "events"}},
             {"saving", {"hosting"}},
         }},
        {"property",
         "framework/property/",
         {"storage"},
         {
             {"values", {}},
             {"classes", {"values"}},
             {"instances", {"values", "classes"}},
             {"guards", {"instances"}},
             {"writes", {"instances"}},
             {"change", {"values", "classes", "instances", "guards", "writes"}},
             {"formulas", {"values", "instances", "guards", "change"}},
             {"structure", {"values", "instances", "guards", "change", "formulas"}},
             {"history", {"values", "instances", "change", "structure"}},
             {"tree",
              {"values", "classes", "instances", "guards", "change", "formulas", "structure",
               "history"}},
             {"access", {"values", "classes", "tree"}},
             {"drawing", {"tree"}},
             {"questions", {"classes", "change", "tree"}},
             {"snapshot", {"classes", "instances", "change", "formulas", "structure", "tree"}},
         }},
        {"storage",
         "framework/property/storage/",
         {},
         {
             {"json", {}},
             {"files", {"json"}},
             {"settings", {"json", "files"}},
             {"store", {"json", "files"}},
             {"database", {"files"}},
             {"values", {"json"}},
             {"scenes", {"json", "files", "values"}},
             {"saves", {"files", "database"}},
             {"tweaks_file", {"json", "values", "scenes"}},
             {"tweaks", {"json", "files", "database", "values", "scenes", "tweaks_file"}},
             {"keep", {"values", "scenes", "tweaks_file", "tweaks"}},
         }},
        {"script",
         "framework/script/",
         {},
         {
             {"text", {}},
             {"other_languages", {"text"}},
             {"reference", {"text"}},
             {"lua", {}},
             {"limits", {"lua"}},
             {"sources", {"text", "other_languages", "lua", "limits"}},
             {"values", {"text", "other_languages", "reference", "lua", "limits", "sources"}},
             {"writes", {"text", "reference", "lua", "limits", "values"}},
             {"types", {"text", "lua", "values", "writes"}},
             {"calls", {"text", "other_languages", "lua", "limits", "sources", "values"}},
             {"sandbox",
              {"text", "other_languages", "lua", "limits", "sources", "values", "calls"}},
             {"handlers",
              {"text", "other_languages", "lua", "limits", "sources", "values", "writes", "calls"}},
             {"motion", {"lua", "values", "writes", "calls"}},
             {"classes",
              {"text", "other_languages", "reference", "lua", "limits", "values", "writes", "calls",
               "handlers"}},
             {"objects",
              {"text", "other_languages", "reference", "lua", "limits", "sources", "values",
               "writes", "handlers", "motion", "classes"}},
             {"library",
              {"text", "other_languages", "reference", "lua", "limits", "sources", "values",
               "writes", "calls", "sandbox", "handlers", "motion", "classes", "objects"}},
             {"reload",
              {"lua", "sources", "values", "writes", "calls", "sandbox", "handlers", "motion",
               "classes"}},
             {"console",
              {"text", "other_languages", "reference", "lua", "limits", "sources", "values",
               "calls", "sandbox", "handlers", "classes", "objects", "library"}},
             {"runtime",
              {"lua", "limits", "sources", "values", "writes", "calls", "sandbox", "handlers",
               "motion", "classes", "objects", "library", "reload", "console"}},
         }},
        {"visuals",
         "framework/visuals/",
         {},
         {
             {"images", {}},
             {"letters", {}},
             {"properties", {}},
             {"sprites", {"images", "properties"}},
             {"texts", {"letters", "properties"}},
             {"lines", {"properties"}},
             {"layers", {"properties"}},
             {"tilemaps", {"images", "properties"}},
             {"emitters", {"images", "properties"}},
         }},
        {"app",
         "framework/app/",
         {},
         {
             {"sfml", {}},
             {"outlines", {"sfml"}},
             {"draw", {"sfml", "outlines"}},
             {"window", {"sfml", "draw"}},
             {"input", {}},
             {"time", {}},
             {"sound", {"sfml"}},
             {"loop", {"time"}},
         }},
        {"interface",
         "framework/interface/",
         {},
         {
             {"themes", {}},
             {"widgets", {"themes"}},
             {"layout", {"themes", "widgets"}},
             {"binding", {"widgets"}},
             {"interaction", {"widgets", "layout", "binding"}},
             {"drawing", {"themes", "widgets", "layout", "binding", "interaction"}},
         }},
        {"console",
         "console/",
         {"include"},
         {
             {"text", {}},
             {"observed", {"text"}},
             {"branches", {"text", "observed"}},
             {"settings", {"observed"}},
             {"prompt", {"text"}},
             {"look", {"text"}},
             {"editing", {"text", "look"}},
             {"inspector", {"observed", "look", "editing"}},
             {"in_game", {"text", "observed", "branches", "look"}},
             {"views", {"text", "observed", "branches", "prompt", "look"}},
             {"panel",
              {"text", "observed", "branches", "settings", "prompt", "look", "inspector", "in_game",
               "views"}},
         }},
        // main.cpp, which names all commands, is not in a room.
        {"fettle",
         "fettle/",
         {},
         {
             {"terminal", {}},
             {"ending", {"terminal"}},
             {"command_line", {"terminal", "ending"}},
             {"files", {"terminal", "ending"}},
             {"attach", {"terminal", "ending", "command_line", "files"}},
             {"game", {"files"}},
             {"session", {"terminal", "ending", "command_line", "files", "attach", "game"}},
             {"testing", {"terminal", "ending", "files", "game", "session"}},
             {"packing", {"files", "game", "session"}},
             {"commands",
              {"terminal", "ending", "command_line", "files", "attach", "game", "session",
               "testing", "packing"}},
         }},
    };
    return table;
}

void check_order(const DividedPart& part, Violations& found) {
    std::set<std::string_view> above;
    for (const Room& room : part.rooms) {
        if (!std::ranges::includes(above, room.may_know))
            found.push_back(std::string(room.name) + " knows a room that does not stand above it");
        above.insert(room.name);
    }
}

void check_file(const SourceTree& tree, const SourceFile& file, const DividedPart& part,
                Violations& found) {
    const std::string_view name = part.room_of(file.path);
    if (name.empty()) return;
    const Room* room = part.room_named(name);
    if (room == nullptr) {
        found.push_back(file.path + ": lies in no room of " + std::string(part.name));
        return;
    }
    for (const Include& include : file.includes()) {
        const std::string target = tree.resolve(file, include);
        const std::string_view other = part.room_of(target);
        if (!other.empty() && other != name && !room->may_know.contains(other))
            found.push_back(file.path + ":" + std::to_string(include.line) + ": " +
                            std::string(name) + " may not include " + target);
    }
}

}  // namespace

Violations forbidden_rooms(const SourceTree& tree) {
    Violations found;
    for (const DividedPart& part : divided_parts()) {
        check_order(part, found);
        for (const auto& [path, file] : tree.files()) check_file(tree, file, part, found);
    }
    return found;
}

std::vector<std::string> folders_of_rooms() {
    std::vector<std::string> folders;
    for (const DividedPart& part : divided_parts())
        for (const Room& room : part.rooms)
            folders.push_back(std::string(part.folder) + std::string(room.name));
    return folders;
}

}  // namespace fettle::architecture
