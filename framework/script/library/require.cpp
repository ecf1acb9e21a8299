// require("enemies.boss") runs enemies/boss.lua in the game's folder once and returns its result.
// It loads only source text, and only from this folder.

#include <algorithm>
#include <filesystem>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/assets.h>

#include <library/sandbox.h>
#include <lua/environment.h>
#include <lua/guard.h>
#include <lua/machine.h>
#include <lua/sources.h>
#include <lua/stack.h>
#include <values/values.h>

namespace fettle::script {

namespace fs = std::filesystem;

namespace {

// The file of a module, relative to the folder.
std::string module_file(const std::string& name) {
    std::string file;
    for (const char c : name) {
        const bool word = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
        if (!word && c != '.' && c != '/')
            throw Error(ErrorKind::bad_name, "require: \"" + name + "\" is no name of a module");
        file += c == '.' ? '/' : c;
    }
    if (file.empty() || file.front() == '/' || file.back() == '/' ||
        file.find("//") != std::string::npos)
        throw Error(ErrorKind::bad_name, "require: \"" + name +
                                             "\" is no name of a module; files outside the game's "
                                             "folder cannot be loaded");
    return file + ".lua";
}

std::vector<std::string> modules_of(const Machine& machine) {
    constexpr std::string_view endings[] = {".lua"};
    std::vector<std::string> names =
        property::Assets(machine.sources.files, machine.sources.folder).names(endings);
    for (std::string& name : names) {
        name.resize(name.size() - 4);
        std::replace(name.begin(), name.end(), '/', '.');
    }
    return names;
}

fs::path existing(Machine& machine, const std::string& file, const std::string& name) {
    fs::path path = machine.sources.folder / file;
    if (machine.sources.files.exists(path)) return path;
    throw Error(ErrorKind::unknown_name, "require: no module \"" + name + "\" (" + file + ")" +
                                             property::suggestion(name, modules_of(machine)));
}

int require(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_type(L, 1) != LUA_TSTRING) refuse_type(L, 1, "require: needs the name of a module");
    lua_settop(L, 1);
    push_registry(L, machine.globals.loaded);
    lua_pushvalue(L, 1);
    if (lua_rawget(L, 2) != LUA_TNIL) {
        if (lua_islightuserdata(L, -1))
            throw Error(ErrorKind::bad_structure,
                        std::string("require: \"") + string_at(L, 1) +
                            "\" is being loaded already; two modules require each other");
        return 1;
    }
    lua_pop(L, 1);
    const std::string name = string_at(L, 1);
    machine.tree.require_changeable("load the module \"" + name + "\"");
    if (machine.sources.folder.empty())
        throw Error(ErrorKind::rejected, "require: there is no game folder");
    const std::string file = module_file(name);
    const std::string text = machine.sources.files.read(existing(machine, file, name));
    if (machine.sources.load(L, text, file) != LUA_OK) return lua_error(L);
    lua_pushvalue(L, 1);
    lua_pushlightuserdata(L, &machine);  // marks a module that is being loaded
    lua_rawset(L, 2);
    try {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 1);
    } catch (...) {
        // Remove the mark, so that a corrected file can be required again.
        lua_pushvalue(L, 1);
        lua_pushnil(L);
        lua_rawset(L, 2);
        throw;
    }
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
    lua_pushvalue(L, 1);
    lua_pushvalue(L, -2);
    lua_rawset(L, 2);
    return 1;
}

}  // namespace

void open_require(lua_State* L) {
    add_pure<require>(L, "require");
}

}  // namespace fettle::script
