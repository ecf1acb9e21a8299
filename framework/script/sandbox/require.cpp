// require("enemies.boss") runs enemies/boss.lua in the game's folder once and returns its result.
// It loads only source text, and only from this folder.

#include <algorithm>
#include <filesystem>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/assets.h>

#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <sandbox/sandbox.h>
#include <sources/sources.h>
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
            throw Error(ErrorKind::bad_name, "require: \"" + name + "\" is not a name of a module");
        file += c == '.' ? '/' : c;
    }
    if (file.empty() || file.front() == '/' || file.back() == '/' ||
        file.find("//") != std::string::npos)
        throw Error(ErrorKind::bad_name,
                    "require: \"" + name +
                        "\" is not a name of a module; files outside the game's "
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
    constexpr std::string_view ending = ".lua";
    if (name.size() > ending.size() && name.ends_with(ending)) {
        const std::string module = name.substr(0, name.size() - ending.size());
        if (machine.sources.files.exists(machine.sources.folder / module_file(module)))
            throw Error(
                ErrorKind::unknown_name,
                "require: the name of a module has no ending: write require(\"" + module + "\")");
    }
    throw Error(ErrorKind::unknown_name, "require: no module \"" + name + "\" (" + file + ")" +
                                             property::suggestion(name, modules_of(machine)));
}

// Counts a module as being loaded while its file runs. The list is not a table of Lua: an error of
// the file leaves the stack of Lua as it was in the innermost function, so its end may not use
// that.
class BeingLoaded {
  public:
    BeingLoaded(std::vector<std::string>& names, const std::string& name) : names_(names) {
        names_.push_back(name);
    }
    ~BeingLoaded() { names_.pop_back(); }
    BeingLoaded(const BeingLoaded&) = delete;
    BeingLoaded& operator=(const BeingLoaded&) = delete;

  private:
    std::vector<std::string>& names_;
};

void refuse_cycle(const std::vector<std::string>& loading, const std::string& name) {
    if (std::find(loading.begin(), loading.end(), name) == loading.end()) return;
    throw Error(
        ErrorKind::bad_structure,
        "require: \"" + name + "\" is being loaded already; " +
            (loading.back() == name ? "it requires itself" : "two modules require each other"));
}

int require(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_type(L, 1) != LUA_TSTRING) refuse_type(L, 1, "require: needs the name of a module");
    lua_settop(L, 1);
    push_registry(L, machine.globals.loaded);
    lua_pushvalue(L, 1);
    if (lua_rawget(L, 2) != LUA_TNIL) return 1;
    lua_pop(L, 1);
    const std::string name = string_at(L, 1);
    refuse_cycle(machine.globals.loading, name);
    machine.tree.require_changeable("load the module \"" + name + "\"");
    if (machine.sources.folder.empty())
        throw Error(ErrorKind::rejected, "require: there is no game folder");
    const std::string file = module_file(name);
    const std::string text = machine.sources.files.read(existing(machine, file, name));
    if (machine.sources.load(L, text, file) != LUA_OK) return lua_error(L);
    {
        const BeingLoaded being_loaded(machine.globals.loading, name);
        lua_pushvalue(L, 1);
        lua_call(L, 1, 1);
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
