#pragma once
// All parts of a runtime.

#include <fettle/script/runtime.h>

#include <calls/errors.h>
#include <classes/script_classes.h>
#include <classes/unplaced_instances.h>
#include <handlers/connections.h>
#include <handlers/timers.h>
#include <library/pen.h>
#include <library/time_functions.h>
#include <limits/limiters.h>
#include <lua/environment.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <motion/tweens.h>
#include <objects/hints.h>
#include <runtime/runtime_part.h>
#include <sandbox/random.h>
#include <sources/sources.h>
#include <values/members.h>
#include <values/moved_lists.h>
#include <values/recording.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/replaced_formulas.h>

namespace fettle::script {

/// Other code accesses these parts only through `Machine`.
struct Parts {
    Parts(property::Tree& tree, Options runtime_options);
    ~Parts();
    Parts(const Parts&) = delete;

    /// Removes the scripts' watchers, handlers and parts from the tree, if the tree still exists.
    void leave();
    /// The same, and closes Lua.
    void end();

    Machine machine;
    Options options;
    Interpreter lua;
    RuntimeLifetime life;
    Limiters limiters;
    Environment globals;
    Sources sources;
    Host host;
    Recording recording;
    Boxes boxes;
    MovedLists moved_lists;
    TypedFormulas typed_formulas;
    MemberTables members;
    Declarations declarations;
    Errors errors;
    Timers timers{machine};
    Tweens tweens{machine};
    Connections connections{machine};
    ScriptClasses classes{machine};
    Hints hints{machine};
    UnplacedInstances unplaced;
    Random random;
    HeldSnapshots snapshots;
    Pen pen;
    RuntimePart saved{machine};
};

}  // namespace fettle::script
