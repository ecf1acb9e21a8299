#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <fettle/property/drawing.h>
#include <fettle/property/storage/game_saves.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <calls/errors.h>
#include <calls/protected.h>
#include <classes/script_classes.h>
#include <classes/unplaced_instances.h>
#include <console/complete.h>
#include <console/evaluate.h>
#include <handlers/connections.h>
#include <handlers/observed.h>
#include <handlers/timers.h>
#include <library/host_functions.h>
#include <library/pen.h>
#include <library/scene_changes.h>
#include <limits/limiters.h>
#include <lua/environment.h>
#include <lua/host.h>
#include <lua/library_chunks.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <lua/stack.h>
#include <motion/tweens.h>
#include <objects/hints.h>
#include <reload/reload.h>
#include <runtime/parts.h>
#include <sources/sources.h>
#include <values/recording.h>
#include <values/values.h>

namespace fettle::script {

struct Runtime::State : Parts {
    using Parts::Parts;
    std::shared_ptr<const void> lifetime = std::make_shared<char>();  // of the Runtime object
    std::vector<std::pair<std::string, std::string>> libraries;       // names and chunks
    std::filesystem::path game_file;                                  // main.lua; "": no game
    TopLevel top_level{machine};
};

namespace {

void require_tree(const Machine& machine) {
    if (machine.life.tree.expired())
        throw Error(
            ErrorKind::deleted,
            "the tree of this runtime was destroyed, so the runtime cannot be used any more");
}

void require_seconds(const char* what, double seconds) {
    if (!(seconds >= 0) || std::isinf(seconds))
        throw Error(ErrorKind::out_of_range, std::string(what) + " = " +
                                                 property::number_text(seconds) +
                                                 ": expected a time in seconds, at least 0");
}

Options checked(const property::Tree& tree, Options options) {
    if (options.tweaks != nullptr && !options.tweaks->are_of(tree))
        throw Error(ErrorKind::rejected, "Options::tweaks: those of another tree");
    if (options.saves != nullptr && !options.saves->are_of(tree))
        throw Error(ErrorKind::rejected, "Options::saves: those of another tree");
    require_seconds("Options::call_seconds", options.call_seconds);
    constexpr std::size_t minimum = std::size_t{1} << 20;
    if (options.memory_limit < minimum)
        throw Error(ErrorKind::out_of_range,
                    "Options::memory_limit = " + std::to_string(options.memory_limit) +
                        " bytes: Lua with its library needs " + std::to_string(minimum) +
                        " at least");
    constexpr std::size_t smallest_command = std::size_t{1} << 16;
    if (options.console_memory < smallest_command)
        throw Error(ErrorKind::out_of_range,
                    "Options::console_memory = " + std::to_string(options.console_memory) +
                        " bytes: a command needs " + std::to_string(smallest_command) +
                        " at least");
    return options;
}

}  // namespace

Runtime::Runtime(property::Tree& tree, Options options)
    : state_(std::make_unique<State>(tree, checked(tree, std::move(options)))) {
    state_->host.on_error = [](const ScriptError& error) {
        std::fprintf(stderr, "%s\n%s", error.message.c_str(), error.traceback.c_str());
    };
    state_->host.on_print = [](std::string_view text) {
        std::fwrite(text.data(), 1, text.size(), stdout);
        std::fputc('\n', stdout);
    };
    state_->host.on_note = [](std::string_view text) {
        std::fprintf(stderr, "note: %.*s\n", static_cast<int>(text.size()), text.data());
    };
}

Runtime::~Runtime() {
    state_->lifetime.reset();
    if (state_->life.uses > 0) {
        state_->leave();
        RuntimeLifetime& life = state_->life;
        life.orphan = std::shared_ptr<State>(std::move(state_));
    }
}

std::weak_ptr<const void> Runtime::lifetime() const {
    return state_->lifetime;
}

/// Returns the machine for a function that runs scripts. Throws if the tree was destroyed.
Machine& Runtime::live() const {
    require_tree(state_->machine);
    return state_->machine;
}

// --- The game

namespace {

// Removes all callbacks of an earlier game; the tree stays as it is.
void reset_game(Machine& machine) {
    machine.timers.clear();
    machine.connections.clear();
    machine.classes.forget_functions();
    machine.hints.forget();
    machine.errors.caught.reset();
    machine.errors.reported_gone.clear();
    machine.boxes.checked_writes = Boxes::most_checked_writes;
    lua_State* L = machine.lua.main;
    for (const int reference : {machine.globals.loaded, machine.globals.declared}) {
        lua_newtable(L);
        lua_rawseti(L, LUA_REGISTRYINDEX, reference);
    }
    // Globals of the game are removed; those of the language stay.
    lua_rawgeti(L, LUA_REGISTRYINDEX, machine.globals.table);
    for (const std::string& name : machine.globals.assigned) {
        push_text(L, name);
        lua_pushnil(L);
        lua_rawset(L, -3);
    }
    lua_pop(L, 1);
    machine.globals.assigned.clear();
    machine.globals.stated.clear();
    const property::Tree& tree = machine.tree;
    machine.globals.first_children.clear();
    for (const Handle child : tree.children(tree.root()))
        machine.globals.first_children.emplace_back(tree.name(child), child);
}

bool run_chunk(Machine& machine, const std::string& text, const std::string& name,
               const char* context, bool report = true) {
    return protected_run(
        machine, context,
        [&](lua_State* L) {
            if (machine.sources.load(L, text, name) != LUA_OK) lua_error(L);
            lua_call(L, 0, 0);
        },
        report);
}

bool call_global(Machine& machine, std::string_view name, std::span<const Value> arguments) {
    return protected_run(machine, std::string(name), [&](lua_State* L) {
        push_registry(L, machine.globals.table);
        push_text(L, name);
        if (lua_rawget(L, -2) != LUA_TFUNCTION) return;
        luaL_checkstack(L, static_cast<int>(arguments.size()), "arguments");
        for (const Value& value : arguments) push_value(L, value);
        lua_call(L, static_cast<int>(arguments.size()), 0);
    });
}

/// Calls `ready` of waiting instances before and after the callback.
bool call_ready(Machine& machine, std::string_view name, std::span<const Value> arguments) {
    const bool ready = machine.classes.deliver_ready();
    const bool ok = call_global(machine, name, arguments);
    return machine.classes.deliver_ready() && ready && ok;
}

}  // namespace

bool Runtime::load(const std::filesystem::path& game) {
    namespace fs = std::filesystem;
    Machine& machine = live();
    if (machine.life.uses > 0)
        throw Error(ErrorKind::bad_structure,
                    "no game can be loaded while a script of this runtime runs: do it "
                    "when that call has returned");
    const RuntimeLifetime::Use use(machine.life);
    std::error_code error;
    const fs::path file = fs::is_directory(game, error) ? game / "main.lua" : game;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const std::string text = [&] {
        try {
            machine.sources.files.stay_below(folder, machine.options.assets);
            return machine.sources.files.read(file);
        } catch (const fs::filesystem_error& problem) {
            throw property::FileError(game, "cannot be read: " + problem.code().message());
        }
    }();
    reset_game(machine);
    machine.sources.folder = folder;
    state_->game_file = file;
    for (const auto& [name, chunk] : state_->libraries)
        run_chunk(machine, chunk, library_chunk(name), "library");
    bool ok = state_->top_level.load(
        [&] { return run_chunk(machine, text, file.filename().string(), "load"); });
    if (ok) ok = machine.classes.deliver_ready() && call_ready(machine, "start", {});
    if (ok) machine.hints.game_loaded();
    return ok;
}

Reloaded Runtime::reload(const std::vector<std::string>& files) {
    Machine& machine = live();
    if (state_->game_file.empty() || machine.life.uses > 0)
        throw Error(ErrorKind::bad_structure,
                    "a game can be loaded again only when one is loaded and no script runs");
    const RuntimeLifetime::Use use(machine.life);
    const std::string text = machine.sources.files.read(state_->game_file);
    const std::string name = state_->game_file.filename().string();
    machine.hints.forget();
    Reloaded result = state_->top_level.reload([&] {
        for (const auto& [library, chunk] : state_->libraries)
            run_chunk(machine, chunk, library_chunk(library), "library");
        return run_chunk(machine, text, name, "reload", false);
    });
    if (!result.done) return result;
    property::List names(files.begin(), files.end());
    call_ready(machine, "reloaded", std::array{Value(std::move(names))});
    machine.hints.game_loaded();
    return result;
}

bool Runtime::run(std::string_view chunk, const std::string& name) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    Limits limits{.memory = machine.options.memory_limit, .subject = "a chunk"};
    if (const auto of_call = machine.limiters.budget.of_call()) {
        limits.instructions = of_call->instructions;
        limits.seconds = of_call->seconds;
    }
    const Budget::Scope budget(machine.limiters.budget, limits);
    const bool ok = run_chunk(machine, std::string(chunk), name, "chunk");
    return machine.classes.deliver_ready() && ok;
}

void Runtime::add_library(const std::string& name, std::string_view chunk) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    state_->libraries.emplace_back(name, chunk);
    run_chunk(machine, std::string(chunk), library_chunk(name), "library");
}

double Runtime::random() {
    return live().random.unit();
}

bool Runtime::call(std::string_view callback, std::span<const Value> arguments) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    return call_ready(machine, callback, arguments);
}

namespace {

/// One call of a function that draws: what it pushes and sets ends with it.
class PenScope {
  public:
    PenScope(Pen& pen, property::Painter& painter) : pen_(pen), painter_(painter) {
        painter_.push({});
        pen_.base = painter_.pushed();
    }
    ~PenScope() {
        while (painter_.pushed() >= pen_.base) painter_.pop();
        pen_.base = 0;
    }
    PenScope(const PenScope&) = delete;

  private:
    Pen& pen_;
    property::Painter& painter_;
};

/// Calls the functions `draw` of scripts' classes, each instance at its place in the order.
class ClassDrawer : public property::Drawer {
  public:
    explicit ClassDrawer(Machine& machine) : machine_(machine) {}
    bool draws(const property::Class& of) override {
        return machine_.classes.has_function(of, "draw");
    }
    void draw(Handle instance, property::Painter& painter) override {
        // After a call that took too long, the rest of this picture is left out.
        if (machine_.limiters.watchdog.stopped()) return;
        const PenScope scope(machine_.pen, painter);
        ok_ &= machine_.classes.draw(instance, machine_.pen.reference);
    }
    bool ok() const { return ok_; }

  private:
    Machine& machine_;
    bool ok_ = true;
};

bool call_with_pen(Machine& machine, const char* callback) {
    const PenScope scope(machine.pen, *machine.pen.painter);
    return protected_run(machine, callback, [&](lua_State* L) {
        push_registry(L, machine.globals.table);
        lua_pushstring(L, callback);
        if (lua_rawget(L, -2) != LUA_TFUNCTION) return;
        push_registry(L, machine.pen.reference);
        lua_call(L, 1, 0);
    });
}

}  // namespace

bool Runtime::draw(property::Painter& painter) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    struct Holding {
        Machine& machine;
        ~Holding() {
            machine.pen.painter = nullptr;
            machine.recording.drawing = false;
        }
    } const holding{machine};
    machine.pen.painter = &painter;
    machine.recording.drawing = true;
    bool ok = call_with_pen(machine, "draw_behind");
    ClassDrawer classes(machine);
    machine.tree.draw(machine.tree.root(), painter, property::Drawing::alpha(), &classes);
    ok &= classes.ok();
    ok &= call_with_pen(machine, "draw");
    return ok;
}

bool Runtime::has_defined(const property::Class& of) const {
    return live().classes.scripted(of);
}

bool Runtime::draws() const {
    Machine& machine = live();
    if (defines("draw") || defines("draw_behind")) return true;
    const std::vector<const property::Class*> all = machine.tree.classes();
    return std::any_of(all.begin(), all.end(), [&](const property::Class* of) {
        return machine.classes.has_function(*of, "draw");
    });
}

void Runtime::advance(double seconds) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    advance_transition(machine, seconds);
    machine.tweens.advance_real(seconds);
    machine.timers.advance_real(seconds);
}

bool Runtime::step(double now, double dt) {
    Machine& machine = live();
    require_seconds("Runtime::step: now", now);
    require_seconds("Runtime::step: dt", dt);
    const RuntimeLifetime::Use use(machine.life);
    state_->top_level.note_return(machine.tree.step());
    machine.timers.now = now;
    collect_unplaced(machine);
    bool ok = machine.classes.deliver_ready();
    ok &= machine.tweens.run(dt);
    ok &= machine.timers.run();
    ok &= call_global(machine, "step", std::array{Value(dt)});
    ok &= machine.classes.deliver_ready();  // of what timers and step() have made: before its step
    ok &= machine.classes.step(dt);
    ok &= machine.classes.step_states(dt);
    ok &= machine.classes.deliver_ready();
    return ok;
}

// --- Console

Evaluation Runtime::evaluate(std::string_view command) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    // A copy, because the callback may call `on_command` and so destroy the original.
    if (const auto sink = machine.host.on_command) sink(command);
    require_tree(machine);
    return script::evaluate(machine, command);
}

std::vector<Completion> Runtime::complete(std::string_view input, std::size_t cursor,
                                          std::size_t most) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    return script::complete(machine, input, cursor, most);
}

bool Runtime::running() const {
    return state_->life.uses > 0;
}

void Runtime::serve_console(ConsoleFunctions functions) {
    *state_->host.console = std::move(functions);
}

Observed Runtime::observe(std::string_view expression) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    return script::observe(machine, expression);
}

void Runtime::set_selected(Handle instance) {
    state_->globals.it = instance;
}

Handle Runtime::selected() const {
    return state_->globals.it;
}

void Runtime::add_function(const std::string& name, HostFunction function) {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    add_host_function(machine, name, std::move(function));
}

// --- Callbacks of the host

void Runtime::limit_calls(double seconds, std::function<bool(const LongCall&)> go_on) {
    require_seconds("limit_calls: seconds", seconds);
    if (!go_on) return state_->limiters.watchdog.limit(seconds, {});
    // A running call may outlive this Runtime, but not its State, which contains the machine.
    const auto ask = [&machine = state_->machine, go_on = std::move(go_on)](lua_State* L,
                                                                            double s) {
        return go_on({.where = describe_place(machine, L), .seconds = s});
    };
    state_->limiters.watchdog.limit(seconds, ask);
}

void Runtime::on_command_memory(std::function<std::size_t()> bytes, std::string property) {
    state_->host.command_memory = std::move(bytes);
    state_->host.memory_property = std::move(property);
}

void Runtime::on_error(std::function<void(const ScriptError&)> sink) {
    state_->host.on_error = std::move(sink);
}

void Runtime::on_print(std::function<void(std::string_view)> sink) {
    state_->host.on_print = std::move(sink);
}

void Runtime::on_note(std::function<void(std::string_view)> sink) {
    state_->host.on_note = std::move(sink);
}

void Runtime::on_rewind(std::function<void(double)> rewind) {
    state_->host.on_rewind = std::move(rewind);
}

void Runtime::on_command(std::function<void(std::string_view)> sink) {
    state_->host.on_command = std::move(sink);
}

void Runtime::interrupt() noexcept {
    state_->limiters.budget.interrupt();
}

void Runtime::go_on() {
    state_->limiters.budget.go_on();
}

bool Runtime::interrupted() const {
    return state_->limiters.budget.interrupted();
}

std::optional<int> Runtime::quit_status() const {
    return state_->host.quit_status;
}

bool Runtime::defines(std::string_view callback) const {
    Machine& machine = live();
    const RuntimeLifetime::Use use(machine.life);
    const std::string name(callback);
    bool found = false;
    protected_run(
        machine, "defines",
        [&](lua_State* M) {
            push_registry(M, machine.globals.table);
            push_text(M, name);
            found = lua_rawget(M, -2) == LUA_TFUNCTION;
        },
        false);
    return found;
}

std::size_t Runtime::memory() const {
    return state_->limiters.arena.bytes();
}

}  // namespace fettle::script
