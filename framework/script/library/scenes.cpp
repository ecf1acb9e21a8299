// The global `scene`: files of instances.
//   scene.load(file [, parent [, name]])   returns the loaded instance; detached without a parent
//   scene.save(file, instance)
// Files are in the game's folder. Files that are not there are read from Fettle's own assets.

#include <filesystem>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <library/sandbox.h>
#include <lua/guard.h>
#include <lua/machine.h>
#include <lua/sources.h>
#include <values/values.h>

namespace fettle::script {

namespace fs = std::filesystem;

namespace {

std::string file_name(lua_State* L, int index, const char* what) {
    const std::string name = check_text(L, index, std::string(what) + ": needs a file name");
    const fs::path path(name);
    bool leaves = path.is_absolute() || name.empty() || name.find('\0') != std::string::npos;
    for (const fs::path& part : path) leaves = leaves || part == "..";
    if (leaves)
        throw Error(ErrorKind::rejected, std::string(what) + ": \"" + name.substr(0, 80) +
                                             "\" is no file below the game's folder");
    return name;
}

int load(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string file = file_name(L, 1, "scene.load");
    const Handle parent = lua_isnoneornil(L, 2) ? Handle{} : check_instance(L, 2, "scene.load");
    const std::string name =
        lua_isnoneornil(L, 3) ? "" : check_text(L, 3, "scene.load: needs a name");
    const auto found = [&](const fs::path& folder) {
        return !folder.empty() && machine.sources.files.exists(folder / file);
    };
    const bool own = found(machine.sources.folder);
    if (!own && !found(machine.options.assets)) {
        std::vector<std::string> names = files_below(machine.sources.folder, ".json");
        for (std::string& each : files_below(machine.options.assets, ".json"))
            names.push_back(std::move(each));
        throw Error(ErrorKind::unknown_name, "scene.load: there is no file \"" + file + "\"" +
                                                 property::suggestion(file, names));
    }
    const fs::path named = (own ? machine.sources.folder : machine.options.assets) / file;
    const std::string text = machine.sources.files.read(named);
    // A canonical path, because a later run with tweaks of this run may start in another folder.
    const fs::path path = fs::weakly_canonical(named);
    std::vector<std::string> warnings;
    std::vector<property::SceneInstance> instances;
    const Handle loaded = property::load_scene_text(machine.tree, text, path.string(), parent, name,
                                                    &warnings, &instances);
    if (property::Tweaks* tweaks = machine.options.tweaks) {
        tweaks->scene_loaded(path, instances, !name.empty());
        tweaks->placed(loaded);
    }
    for (const std::string& warning : warnings) print_line(machine, "warning: " + warning);
    push_instance(L, loaded);
    return 1;
}

int save(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::string file = file_name(L, 1, "scene.save");
    const Handle node = check_instance(L, 2, "scene.save");
    if (machine.sources.folder.empty())
        throw Error(ErrorKind::rejected, "scene.save: there is no game folder");
    note_replay(machine, "scene.save");
    std::vector<std::string> warnings;
    machine.sources.files.write_scene(machine.sources.folder / file,
                                      property::scene_text(machine.tree, node, &warnings));
    for (const std::string& warning : warnings) print_line(machine, "warning: " + warning);
    return 0;
}

}  // namespace

void open_scenes(lua_State* L) {
    lua_newtable(L);
    add_function<load>(L, "load");
    add_function<save>(L, "save");
    lua_setfield(L, -2, "scene");
}

}  // namespace fettle::script
