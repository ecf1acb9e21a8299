// Functions for saved games:
//   save_game(slot)  load_game(slot)  saves()  delete_save(slot)

#include <fettle/property/storage/game_saves.h>
#include <fettle/script/runtime.h>

#include <library/library.h>
#include <library/time_functions.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <sandbox/sandbox.h>
#include <values/values.h>

namespace fettle::script {

using property::GameSaves;
using property::SaveInfo;

namespace {

GameSaves& saves_of(Machine& machine, const char* what) {
    if (machine.options.saves != nullptr) return *machine.options.saves;
    throw Error(ErrorKind::rejected, std::string(what) + ": this game has no place for saves");
}

std::string slot_at(lua_State* L, const char* what) {
    return check_text(L, 1, std::string(what) + ": needs the name of a slot like \"first\"");
}

int save_game(lua_State* L) {
    Machine& machine = machine_of(L);
    saves_of(machine, "save_game").save(slot_at(L, "save_game"));
    return 0;
}

int load_game(lua_State* L) {
    Machine& machine = machine_of(L);
    require_no_circle(machine, "load_game");
    saves_of(machine, "load_game").load(slot_at(L, "load_game"));
    return 0;
}

int delete_save(lua_State* L) {
    Machine& machine = machine_of(L);
    GameSaves& saves = saves_of(machine, "delete_save");
    const std::string slot = slot_at(L, "delete_save");
    if (note_replay(machine, "delete_save"))
        saves.discard(slot);
    else
        saves.remove(slot);
    return 0;
}

// A list of tables with slot, step, time (as os.time), picture (an image; nil without one) and
// problem (nil if the save can be loaded).
int saves(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::vector<SaveInfo> all = saves_of(machine, "saves").list();
    lua_createtable(L, static_cast<int>(all.size()), 0);
    lua_Integer place = 0;
    for (const SaveInfo& save : all) {
        lua_createtable(L, 0, 5);
        put(L, "slot", save.slot);
        put(L, "step", static_cast<lua_Integer>(save.step));
        put(L, "time", static_cast<lua_Integer>(save.time));
        if (save.thumbnail) put(L, "picture", "save:" + save.slot);
        if (!save.problem.empty()) put(L, "problem", save.problem);
        lua_rawseti(L, -2, ++place);
    }
    return 1;
}

}  // namespace

bool note_replay(Machine& machine, const std::string& what) {
    if (machine.options.replay.empty()) return false;
    print_line(machine,
               what + ": nothing is written, since this is a replay of " + machine.options.replay);
    return true;
}

void open_saves(lua_State* L) {
    add_function<save_game>(L, "save_game");
    add_function<load_game>(L, "load_game");
    add_pure<saves>(L, "saves");
    add_function<delete_save>(L, "delete_save");
}

}  // namespace fettle::script
