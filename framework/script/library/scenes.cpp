// The global `scene`: files of instances.
//   scene.load(file [, parent [, name]])   returns the loaded instance; detached without a parent
//   scene.save(file, instance)
// Files are in the game's folder. Files that are not there are read from Fettle's own assets.

#include <filesystem>

#include <fettle/property/storage/assets.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <library/library.h>
#include <library/scene_files.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <sandbox/sandbox.h>
#include <sources/sources.h>
#include <values/short_text.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view endings[] = {".json"};

property::Assets assets_of(const Machine& machine) {
    return {machine.sources.files, machine.sources.folder, machine.options.assets};
}

int load(lua_State* L) {
    const std::string file = check_text(L, 1, "scene.load: needs a file name");
    const Handle parent = lua_isnoneornil(L, 2) ? Handle{} : check_instance(L, 2, "scene.load");
    const std::string name =
        lua_isnoneornil(L, 3) ? "" : check_text(L, 3, "scene.load: needs a name");
    push_instance(L, load_scene_file(machine_of(L), "scene.load", file, parent, name));
    return 1;
}

int save(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string file = check_text(L, 1, "scene.save: needs a file name");
    const Handle node = check_instance(L, 2, "scene.save");
    if (machine.sources.folder.empty())
        throw Error(ErrorKind::rejected, "scene.save: there is no game folder");
    note_replay(machine, "scene.save");
    std::vector<std::string> warnings;
    machine.sources.files.write_scene(assets_of(machine).path_of("scene.save", file),
                                      property::scene_text(machine.tree, node, &warnings));
    for (const std::string& warning : warnings) print_line(machine, "warning: " + warning);
    return 0;
}

/// Pushes game.scene if it has what the key at index 2 names. Paths of the tree are printed without
/// `game`, so `scene.hero` means game.scene.hero.
bool push_scene_with(lua_State* L) {
    const property::Tree& tree = machine_of(L).tree;
    const Handle made = tree.child(tree.root(), "scene");
    if (!made || lua_type(L, 2) != LUA_TSTRING) return false;
    const std::string_view key = lua_tostring(L, 2);
    if (!tree.child(made, key) && tree.find(made, key) == nullptr) return false;
    push_instance(L, made);
    return true;
}

int member(lua_State* L) {
    if (push_scene_with(L)) {
        lua_pushvalue(L, 2);
        lua_gettable(L, -2);
        return 1;
    }
    throw Error(ErrorKind::unknown_name,
                "scene." + key_in_message(L, 2) +
                    ": scene has load and save; what go_to_scene has made is game.scene");
}

int set_member(lua_State* L) {
    const bool of_scene = push_scene_with(L);
    lua_pushvalue(L, 2);
    lua_pushvalue(L, 3);
    if (of_scene)
        lua_settable(L, -3);
    else
        lua_rawset(L, 1);
    return 0;
}

}  // namespace

Handle load_scene_file(Machine& machine, const char* what, const std::string& file, Handle parent,
                       const std::string& name) {
    const fs::path named = assets_of(machine).find(what, file, endings);
    const std::string text = machine.sources.files.read(named);
    // A canonical path, because a later run with tweaks of this run may start in another folder.
    const fs::path path = fs::weakly_canonical(named);
    std::vector<std::string> warnings;
    std::vector<property::SceneInstance> instances;
    // During a reload, the instance gets its place later.
    const bool waits = parent && machine.declarations.reloading();
    const Handle loaded =
        property::load_scene_text(machine.tree, text, path.string(), waits ? Handle{} : parent,
                                  waits ? "" : name, &warnings, &instances);
    machine.declarations.made_with_values(loaded);
    if (waits) {
        machine.declarations.scenes.push_back({path, std::move(instances), !name.empty()});
        place(machine, loaded, parent, name.empty() ? machine.tree.name(loaded) : name);
        return loaded;
    }
    if (property::Tweaks* tweaks = machine.options.tweaks) {
        tweaks->scene_loaded(path, instances, !name.empty());
        tweaks->placed(loaded);
    }
    for (const std::string& warning : warnings) print_line(machine, "warning: " + warning);
    return loaded;
}

std::string scene_file_named(Machine& machine, const std::string& name) {
    for (const std::string& file : {"scenes/" + name + ".json", name + ".json", name}) {
        if (!file.ends_with(".json") || file == "game.json") continue;
        try {
            return assets_of(machine).find("go_to_scene", file, endings).empty() ? "" : file;
        } catch (const Error&) {
            continue;  // there is no such file
        }
    }
    return {};
}

std::vector<std::string> scene_file_names(Machine& machine) {
    std::vector<std::string> names;
    for (std::string name : assets_of(machine).names(endings)) {
        if (name == "game.json" || name == "modules.json" || name.ends_with(".tweaks.json"))
            continue;
        if (name.starts_with("scenes/")) name.erase(0, 7);
        names.push_back(name.substr(0, name.size() - endings[0].size()));
    }
    return names;
}

void open_scenes(lua_State* L) {
    lua_newtable(L);
    add_function<load>(L, "load");
    add_function<save>(L, "save");
    lua_newtable(L);
    add_pure<member>(L, "__index");
    add_function<set_member>(L, "__newindex");
    name_metatable(L, "scene");
    lua_setmetatable(L, -2);
    lua_setfield(L, -2, "scene");
}

}  // namespace fettle::script
