#pragma once
// The parts of a runtime, each declared in the room where its idea lives. A function that Lua calls
// is given its lua_State and nothing else: it finds the parts it needs here. This header knows none
// of them, so a source includes the header of every part that it uses, and knows no other.

#include <lua/lua_api.h>
#include <lua/tree_names.h>

namespace fettle::script {

struct Options;
struct Interpreter;
struct Life;
class Arena;
class Budget;
class Watchdog;
struct Environment;
struct Sources;
struct Host;
struct Recording;
struct Boxes;
class MemberTables;
struct Errors;
struct CountedMemory;
class Timers;
class Connections;
class ScriptClasses;
class Hints;
struct Unplaced;
class Random;
struct HeldSnapshots;
struct Pen;

struct Machine {
    property::Tree& tree;
    const Options& options;
    Interpreter& lua;
    Life& life;
    Arena& arena;
    Budget& budget;
    Watchdog& watchdog;
    Environment& globals;
    Sources& sources;
    Host& host;
    Recording& recording;
    Boxes& boxes;
    MemberTables& members;
    Errors& errors;
    CountedMemory& counted;
    Timers& timers;
    Connections& connections;
    ScriptClasses& classes;
    Hints& hints;
    Unplaced& unplaced;
    Random& random;
    HeldSnapshots& snapshots;
    Pen& pen;
};

inline Machine& machine_of(lua_State* L) {
    return **static_cast<Machine**>(lua_getextraspace(L));
}

}  // namespace fettle::script
