#pragma once
// References to all parts of a runtime. A function that Lua calls gets only its lua_State; here it
// finds the parts that it needs. This header includes none of them, so each source includes the
// headers of the parts that it uses, and no others.

#include <lua/lua_api.h>
#include <lua/tree_names.h>

namespace fettle::script {

struct Options;
struct Interpreter;
struct RuntimeLifetime;
struct Limiters;
struct Environment;
struct Sources;
struct Host;
struct Recording;
struct Boxes;
class MovedLists;
struct TypedFormulas;
class MemberTables;
class Declarations;
struct Errors;
class Timers;
class Tweens;
class Connections;
class ScriptClasses;
class Hints;
struct UnplacedInstances;
class Random;
struct HeldSnapshots;
struct Pen;

struct Machine {
    property::Tree& tree;
    const Options& options;
    Interpreter& lua;
    RuntimeLifetime& life;
    Limiters& limiters;
    Environment& globals;
    Sources& sources;
    Host& host;
    Recording& recording;
    Boxes& boxes;
    MovedLists& moved_lists;
    TypedFormulas& typed_formulas;
    MemberTables& members;
    Declarations& declarations;
    Errors& errors;
    Timers& timers;
    Tweens& tweens;
    Connections& connections;
    ScriptClasses& classes;
    Hints& hints;
    UnplacedInstances& unplaced;
    Random& random;
    HeldSnapshots& snapshots;
    Pen& pen;
};

inline Machine& machine_of(lua_State* L) {
    return **static_cast<Machine**>(lua_getextraspace(L));
}

}  // namespace fettle::script
