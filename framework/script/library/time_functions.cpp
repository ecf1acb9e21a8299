// snapshot(), restore(s), rewind(seconds). All three act at the next barrier between steps, in the
// order of the calls. They affect the tree, but not Lua variables.

#include <memory>
#include <optional>

#include <fettle/property/snapshot.h>
#include <fettle/script/runtime.h>

#include <library/time_functions.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <values/recording.h>
#include <values/values.h>

namespace fettle::script {

using property::Snapshot;

namespace {

// A snapshot contains a whole game, so the number that scripts may hold is limited.
constexpr std::size_t max_snapshots = 64;

// Each restore or rewind costs as much as several steps, so a barrier makes at most this number.
constexpr std::size_t max_travels = 100;

/// Calls `go` at the next barrier, after earlier calls.
void travel(Machine& machine, const char* what, std::function<void()> go) {
    require_no_circle(machine, what);
    if (machine.snapshots.travels >= max_travels)
        throw Error(ErrorKind::rejected, std::string(what) + ": " + std::to_string(max_travels) +
                                             " restores and rewinds wait for the next barrier "
                                             "already");
    const bool by_script = machine.tree.cause().writer == property::Writer::script;
    machine.tree.at_barrier([&machine, alive = machine.lua.alive, go = std::move(go), by_script] {
        if (*alive == nullptr) return;
        std::optional<property::Tree::CauseScope> cause;
        if (by_script) cause.emplace(machine.tree, property::Writer::script);
        --machine.snapshots.travels;
        go();
    });
    ++machine.snapshots.travels;
}

/// Throws if there is no memory for `more` snapshots of the last size.
void require_room(const Machine& machine, std::size_t more) {
    if (machine.snapshots.bytes + more * machine.snapshots.last_size <=
        machine.options.memory_limit)
        return;
    throw Error(ErrorKind::rejected, "snapshot: those that scripts hold already take " +
                                         std::to_string(machine.snapshots.bytes >> 20) + " of " +
                                         std::to_string(machine.options.memory_limit >> 20) +
                                         " MB; let go of some");
}

struct HeldSnapshot {
    Snapshot snapshot;  // empty until the barrier
    std::size_t bytes = 0;
    std::shared_ptr<lua_State*> alive;
    Machine* machine;

    explicit HeldSnapshot(Machine& of) : alive(of.lua.alive), machine(&of) { ++of.snapshots.count; }
    ~HeldSnapshot() {
        if (*alive == nullptr) return;
        --machine->snapshots.count;
        machine->snapshots.bytes -= bytes;
    }
    /// Takes the snapshot, at the barrier.
    void take() {
        if (*alive == nullptr) return;  // an earlier call at this barrier has ended the runtime
        require_room(*machine, 1);
        snapshot = machine->tree.snapshot();
        bytes = machine->snapshots.last_size = snapshot.payload().size();
        machine->snapshots.bytes += bytes;
    }
    HeldSnapshot(const HeldSnapshot&) = delete;
};

struct SnapshotBox {
    Tag tag;
    std::shared_ptr<HeldSnapshot>* held;
};

int release(lua_State* L) {
    auto* box = static_cast<SnapshotBox*>(lua_touserdata(L, 1));
    if (box != nullptr && box->tag == Tag::snapshot) delete std::exchange(box->held, nullptr);
    return 0;
}

int describe(lua_State* L) {
    const auto* box = box_at<SnapshotBox>(L, 1, Tag::snapshot);
    if (box == nullptr || box->held == nullptr) return 0;
    const Snapshot& taken = (*box->held)->snapshot;
    const std::string text =
        taken.empty() ? std::string("snapshot (taken at the next barrier)")
                      : "snapshot of step " + std::to_string(taken.step()) + ", " +
                            std::to_string((taken.payload().size() + 1023) / 1024) + " KiB";
    push_text(L, text);
    return 1;
}

int snapshot(lua_State* L) {
    Machine& machine = machine_of(L);
    if (machine.snapshots.count >= max_snapshots) lua_gc(L, LUA_GCCOLLECT);
    if (machine.snapshots.count >= max_snapshots)
        throw Error(ErrorKind::rejected, "snapshot: " + std::to_string(max_snapshots) +
                                             " are held already; let go of some");
    require_room(machine, 1);
    auto* box = static_cast<SnapshotBox*>(lua_newuserdatauv(L, sizeof(SnapshotBox), 0));
    *box = {Tag::snapshot, nullptr};
    push_registry(L, machine.boxes.snapshot);
    lua_setmetatable(L, -2);
    box->held = new std::shared_ptr<HeldSnapshot>(std::make_shared<HeldSnapshot>(machine));
    machine.tree.at_barrier([held = std::weak_ptr<HeldSnapshot>(*box->held)] {
        if (const auto wanted = held.lock()) wanted->take();
    });
    machine.recording.after_snapshot =
        !machine.recording.active && !machine.recording.late_change_noted;
    return 1;
}

int restore(lua_State* L) {
    Machine& machine = machine_of(L);
    const auto* box = box_at<SnapshotBox>(L, 1, Tag::snapshot);
    if (box == nullptr) refuse_type(L, 1, "restore: needs what snapshot() returned");
    travel(machine, "restore",
           [&tree = machine.tree, held = *box->held] { tree.restore(held->snapshot); });
    return 0;
}

int rewind(lua_State* L) {
    Machine& machine = machine_of(L);
    const double seconds = check_seconds(L, "rewind");
    if (!machine.host.on_rewind)
        throw Error(ErrorKind::rejected, "rewind: this game has no timeline");
    machine.hints.rewinding();
    travel(machine, "rewind", [&machine, seconds] {
        // A copy, because the call may end the runtime.
        if (const auto go = machine.host.on_rewind) go(seconds);
    });
    return 0;
}

}  // namespace

void require_no_circle(Machine& machine, const char* what) {
    constexpr std::size_t most = 3;  // in a row
    HeldSnapshots& all = machine.snapshots;
    if (machine.globals.in_restored == 0) return;
    if (all.asked_in_a_row == 0 || all.asked_at != all.restored) {
        all.asked_in_a_row = all.asked_at + 1 == all.restored ? all.asked_in_a_row + 1 : 1;
        all.asked_at = all.restored;
    }
    if (all.asked_in_a_row <= most) return;
    throw Error(ErrorKind::rejected,
                std::string(what) +
                    ": a handler of the event restored calls it, and it causes this "
                    "event: the game would go back in each step, for ever");
}

void open_time(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_newtable(L);
    add_pure<release>(L, "__gc");
    add_pure<describe>(L, "__tostring");
    name_metatable(L, "snapshot");
    machine.boxes.snapshot = luaL_ref(L, LUA_REGISTRYINDEX);
    add_function<snapshot>(L, "snapshot");
    add_function<restore>(L, "restore");
    add_function<rewind>(L, "rewind");
}

}  // namespace fettle::script
