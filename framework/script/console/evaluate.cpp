// Runs one console command. It is compiled as an expression, or else as statements, and run under a
// budget. Its results and its changes of the tree become lines of text.

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include <fettle/property/edits.h>
#include <fettle/property/observer.h>
#include <fettle/script/runtime.h>

#include <calls/errors.h>
#include <calls/protected.h>
#include <classes/script_classes.h>
#include <console/command_forms.h>
#include <console/echoes.h>
#include <console/evaluate.h>
#include <console/help.h>
#include <console/last_expression.h>
#include <console/long_text.h>
#include <handlers/formulas.h>
#include <handlers/function_source.h>
#include <handlers/observed.h>
#include <library/library.h>
#include <limits/limiters.h>
#include <lua/environment.h>
#include <lua/host.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <other_languages/other_languages.h>
#include <reference/language.h>
#include <sources/sources.h>
#include <text/columns.h>
#include <text/command_words.h>
#include <text/words.h>
#include <values/recording.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

constexpr int max_results = 20;

// Whether the text is a plain path such as `a.b["c"].d`, so that its value is that of the property
// read last. Stores the last name in `last`.
bool is_plain_path(std::string_view text, std::string& last) {
    std::size_t i = 0;
    last.clear();
    while (i < text.size()) {
        const char c = text[i];
        if (is_word(c) && std::isdigit(static_cast<unsigned char>(c)) == 0) {
            const std::size_t start = i;
            while (i < text.size() && is_word(text[i])) ++i;
            last = text.substr(start, i - start);
        } else if (c == '.') {
            ++i;
        } else if (c == '[') {
            const std::size_t end = text.find(']', i);
            if (end == std::string_view::npos) return false;
            i = end + 1;
        } else {
            return false;
        }
    }
    return !last.empty();
}

// The unit of a number, if the command is a path to a property or to a component of it.
std::string unit_of(const Machine& machine, std::string_view command) {
    const Property* read = machine.recording.last_read;
    std::string last;
    if (!read || read->unit.empty() || !is_plain_path(command, last)) return {};
    if (last == read->name) return read->unit;
    const bool component = read->type == Type::vec2 && (last == "x" || last == "y");
    return component ? read->unit : std::string();
}

// The help for a function that is the only result, as of `quit` without parentheses: it is more
// useful than the text "function". Empty if the result is not a function with help.
std::vector<std::string> help_of_function(lua_State* L, Machine& machine,
                                          std::string_view command) {
    if (lua_type(L, 1) != LUA_TFUNCTION) return {};
    return help_for(machine, std::string(command));
}

/// Whether the first result is an instance that nothing shows, as that of `Body {}`.
bool is_detached(lua_State* L, const Machine& machine) {
    const auto* const box = instance_at(L, 1);
    return box != nullptr && machine.tree.alive(box->handle) &&
           box->handle != machine.tree.root() && !machine.tree.parent(box->handle);
}

// Adds lines for the results on the stack from index 1.
void add_results(lua_State* L, Machine& machine, std::string_view command, Evaluation& evaluation) {
    const int count = lua_gettop(L);
    if (count == 0) return;
    if (count == 1) {
        const bool number = lua_type(L, 1) == LUA_TNUMBER;
        if (number || vec_at(L, 1)) {
            const std::string unit = unit_of(machine, command);
            std::string text;
            if (!unit.empty() && machine.recording.last_read)
                text = machine.tree.text(to_value(L, 1), machine.recording.last_read->precision());
            else
                text = short_text(L, 1);
            evaluation.lines.push_back(unit.empty() ? text : text + " " + unit);
        } else if (std::vector<std::string> help = help_of_function(L, machine, command);
                   !help.empty()) {
            for (std::string& line : help) evaluation.lines.push_back(std::move(line));
        } else if (lua_isnil(L, 1) && command == machine.recording.missing) {
            // A callback that the game does not define.
            for (std::string& line : help_for(machine, machine.recording.missing))
                evaluation.lines.push_back(std::move(line));
        } else {
            const std::size_t first = evaluation.lines.size();
            TableLines table{first, true, {}};
            FoldedLines folded;
            for (std::string& line : long_text(L, 1, command, table, folded))
                evaluation.lines.push_back(std::move(line));
            if (!table.cells.empty()) evaluation.tables.push_back(std::move(table));
            folded.line += first;
            if (!folded.lines.empty()) evaluation.folded.push_back(std::move(folded));
            if (is_detached(L, machine))
                evaluation.lines.emplace_back(
                    "it is in no tree: world:add(_) puts it into the world");
        }
    } else {
        std::string line;
        for (int i = 1; i <= count && i <= max_results; ++i)
            line += (i > 1 ? "  " : "") + short_text(L, i);
        if (count > max_results) line += "  … " + std::to_string(count - max_results) + " more";
        evaluation.lines.push_back(std::move(line));
    }
    push_registry(L, machine.globals.last_result);
    lua_pushvalue(L, 1);
    lua_rawseti(L, -2, 1);
    lua_pop(L, 1);
    try {
        evaluation.result = to_value(L, 1);
    } catch (const Error&) {
        // A function or a table with names is not a value of the tree.
    }
}

enum class Compiled { expression, statements, incomplete, wrong };

bool ends_early(lua_State* L) {
    return lua_type(L, -1) == LUA_TSTRING && view_at(L, -1).ends_with("<eof>");
}

// Leaves the compiled function or the error message on the stack.
Compiled compile(lua_State* L, std::string_view command) {
    constexpr std::string_view expression_begin = "return ";
    const std::string expression = std::string(expression_begin) + std::string(command);
    Sources& sources = machine_of(L).sources;
    const std::string chunk = "=" + sources.commands.chunk();
    const char* const chunk_name = chunk.c_str();
    if (try_load_text(L, expression, chunk_name) == LUA_OK) return Compiled::expression;
    lua_pop(L, 1);
    if (try_load_text(L, command, chunk_name) == LUA_OK) return Compiled::statements;
    lua_pop(L, 1);
    if (load_with_last_expression(L, command, chunk_name)) return Compiled::statements;
    (void)load_text(L, command, chunk_name);
    // Lua waits for what is to be done with the unit in x = 5 kg.
    if (ends_early(L) && ends_with_unit(command)) {
        lua_pop(L, 1);
        const auto line = 1 + std::ranges::count(trimmed(command), '\n');
        push_text(L, sources.commands.chunk() + ":" + std::to_string(line) +
                         ": a word after a number" + hint_for_unit());
        return Compiled::wrong;
    }
    if (ends_early(L)) return Compiled::incomplete;
    sources.set_stop(L, command, chunk_name);
    // A text that does not begin as a statement was meant as an expression.
    if (sources.stop.message.empty() || sources.stop.place > 0) return Compiled::wrong;
    lua_pop(L, 1);
    (void)load_text(L, expression, chunk_name);
    if (ends_early(L)) return Compiled::incomplete;
    sources.set_stop(L, expression, chunk_name);
    sources.stop.column -= std::min(expression_begin.size(), sources.stop.column);
    return Compiled::wrong;
}

/// Refuses a formula of a component, as `world.ball.velocity.x is 3`, if the value at the top of
/// the stack has components. The message has the formula of the whole value.
void refuse_component(lua_State* L, std::string_view whole, const std::string& name,
                      const std::string& source) {
    std::string value;
    if (color_at(L, -1) != nullptr) value = "color(...)";
    if (vec_at(L, -1) != nullptr)
        value = name == "y" ? "vec(..., " + source + ")" : "vec(" + source + ", ...)";
    if (value.empty()) return;
    const std::string property(whole);
    throw Error(ErrorKind::bad_path, property + "." + name + ": a formula is for a whole property" +
                                         hint_to_write(property + " is " + value));
}

// Handles `a.b is expr`: sets a formula with this text for the property `b` of `a`. Returns false
// if the command has another form.
bool add_formula(lua_State* L, Machine& machine, std::string_view command) {
    const std::size_t at = command.find(" is ");
    std::string name;
    if (at == std::string_view::npos) return false;
    const std::string_view path = trimmed(command.substr(0, at));
    if (!is_plain_path(path, name) || trimmed(command.substr(at + 4)).empty()) return false;
    // What is selected now: the formula does not follow the selection.
    const std::string source = with_selected(machine, trimmed(command.substr(at + 4)));
    if (!path.ends_with("." + name))
        throw Error(ErrorKind::bad_path,
                    "a formula is the value of a property: write it as instance.property is ...");
    const std::string_view owner = path.substr(0, path.size() - name.size() - 1);
    if (compile(L, owner) != Compiled::expression) lua_error(L);
    lua_call(L, 0, 1);
    refuse_component(L, owner, name, source);
    const Handle instance = check_instance(L, -1, "is");
    const std::string code = "return " + source;
    if (load_text(L, code, formula_chunk) != LUA_OK) {
        if (ends_early(L)) throw Error(ErrorKind::formula, "the formula ends too early");
        (void)load_text(L, code, ("=" + machine.sources.commands.chunk()).c_str());
        lua_error(L);
    }
    if (is_function_text(source)) lua_call(L, 0, 1);
    push_formula(L, {source, ""});
    define_formula(L, machine, lua_gettop(L), instance, name);
    lua_settop(L, 0);
    return true;
}

// Handles `x?`.
bool add_help(lua_State* L, Machine& machine, std::string_view command, Evaluation& evaluation) {
    if (command.size() < 2 || command.back() != '?') return false;
    const std::string subject(trimmed(command.substr(0, command.size() - 1)));
    evaluation.lines = help_for(machine, subject);
    if (!evaluation.lines.empty()) return true;
    if (compile(L, subject) != Compiled::expression) {
        lua_settop(L, 0);
        return false;
    }
    lua_call(L, 0, 1);
    evaluation.lines = help_lines(L, 1);
    lua_settop(L, 0);
    return true;
}

// Handles `who world.gravity`, `plot it.mass, it.angle`: the words after the function are its
// arguments, as texts. Leaves the results on the stack. Returns false if the command has another
// form.
bool call_with_words(lua_State* L, std::string_view command) {
    const std::size_t space = command.find(' ');
    if (space == std::string_view::npos) return false;
    const std::string_view name = command.substr(0, space);
    if (!takes_words(name)) return false;
    const std::string_view rest = trimmed(command.substr(space));
    // A number of arguments only where there may be several: a condition may contain a comma.
    const std::vector<std::string_view> arguments =
        name == "plot" || name == "pin" ? arguments_of(rest) : std::vector{rest};
    lua_settop(L, 0);
    push_registry(L, machine_of(L).globals.table);
    push_text(L, name);
    lua_gettable(L, 1);
    luaL_checkstack(L, static_cast<int>(arguments.size()), "arguments");
    for (const std::string_view argument : arguments) push_text(L, argument);
    lua_call(L, static_cast<int>(arguments.size()), LUA_MULTRET);
    lua_remove(L, 1);
    return true;
}

/// Adds what can be typed in place of a command such as `rewind 5` or `cd world` to the message
/// about it, which is at the top of the stack. It says more than a hint about the place of the
/// error.
void add_command_hint(lua_State* L, std::string_view command) {
    Sources::Stop& stop = machine_of(L).sources.stop;
    if (stop.message.empty() || view_at(L, -1) != stop.message) return;
    const std::string_view name = first_word(command);
    const bool called = command.substr(name.size()).starts_with('(');
    if (called && stop.message.ends_with(')')) return;  // print(1..5)
    std::string hint = hint_for_command(command);
    const GlobalDoc* const doc = global_doc(name);
    const bool after_name = stop.place == command.find_first_not_of(' ', name.size());
    if (hint.empty() && after_name && !stop.message.ends_with(')') && doc != nullptr &&
        std::string_view(doc->signature).find('(') != std::string_view::npos) {
        const std::string call = call_with_arguments(command);
        hint = hint_to_write(call.empty() ? std::string(name) + "(...)" : call);
    }
    if (hint.empty()) return;
    if (stop.message.ends_with(')'))
        stop.message.resize(std::min(stop.message.rfind(" (write "), stop.message.size()));
    stop.message += hint;
    lua_pop(L, 1);
    push_text(L, stop.message);
}

/// Takes the printed lines.
void take_lines(Machine& machine, Evaluation& evaluation) {
    Recording& recording = machine.recording;
    evaluation.lines = std::exchange(recording.lines, {});
    evaluation.printed = std::exchange(recording.texts, {});
    evaluation.folded = std::exchange(recording.folded, {});
    if (const std::size_t more = std::exchange(recording.dropped_lines, 0); more > 0)
        evaluation.lines.push_back("… " + std::to_string(more) +
                                   (more == 1 ? " more line" : " more lines"));
}

/// Whether the text is a command that can be run alone. Commands that are no Lua, such as `undo`,
/// set `is_special`.
bool is_command(lua_State* L, std::string_view text, bool& is_special) {
    const int top = lua_gettop(L);
    const Compiled compiled = is_bare_command(text) ? Compiled::wrong : compile(L, text);
    lua_settop(L, top);
    if (compiled == Compiled::expression || compiled == Compiled::statements) return true;
    std::string last;
    const std::size_t is = text.find(" is ");
    is_special = is_bare_command(text) || text.ends_with('?') || takes_words(first_word(text)) ||
                 (is != std::string_view::npos && is_plain_path(trimmed(text.substr(0, is)), last));
    return is_special;
}

/// The commands of a line such as `undo; redo`, none of which is a part of a block; none for
/// another line. A local variable would end with its command. `special`: one at least must be no
/// Lua.
std::vector<std::string> several_commands(lua_State* L, std::string_view command, bool special) {
    std::vector<std::string> all = separate_commands(command);
    if (all.size() < 2) return {};
    Sources& sources = machine_of(L).sources;
    const Sources::Stop stop = sources.stop;
    bool any_special = !special, each_alone = true;
    for (const std::string& each : all) {
        bool is_special = false;
        each_alone = each_alone && first_word(each) != "local" && is_command(L, each, is_special);
        any_special = any_special || is_special;
    }
    sources.stop = stop;
    return each_alone && any_special ? all : std::vector<std::string>();
}

void run(lua_State* L, Machine& machine, std::string_view command, Evaluation& evaluation,
         std::vector<std::string>& several) {
    if (command == "?") command = "help";
    several = several_commands(L, command, true);
    if (!several.empty()) return;
    if (list_by_word(L, command, evaluation.lines)) return;
    if (add_help(L, machine, command, evaluation)) return;
    if (is_bare_command(command)) {
        lua_getglobal(L, std::string(command).c_str());
        lua_call(L, 0, 0);
        take_lines(machine, evaluation);
        return;
    }
    switch (compile(L, command)) {
        case Compiled::incomplete:
            evaluation.incomplete = true;
            return;
        case Compiled::wrong:
            several = several_commands(L, command, false);
            if (!several.empty()) return;
            if (add_formula(L, machine, command)) return;
            if (call_with_words(L, command)) break;
            add_command_hint(L, command);
            lua_error(L);
            return;
        default:
            lua_call(L, 0, LUA_MULTRET);
            break;
    }
    machine.limiters.budget.check(L);  // a command that was stopped must not print results
    take_lines(machine, evaluation);
    const std::vector<std::string> all = separate_commands(command);
    add_results(L, machine, all.empty() ? command : std::string_view(all.back()), evaluation);
}

/// Records the instances that a command creates. If the command is stopped because it used too much
/// memory, they are deleted again: a game may not be able to run with them.
class CreatedInstances : public property::Observer {
  public:
    explicit CreatedInstances(Machine& machine) : machine_(machine) { machine.tree.observe(*this); }
    ~CreatedInstances() override {
        if (!machine_.life.tree.expired()) machine_.tree.unobserve(*this);
    }
    CreatedInstances(const CreatedInstances&) = delete;
    void created(Handle instance) override { all_.push_back(instance); }
    /// Returns the number of deleted instances.
    std::size_t destroy() {
        const std::vector<Handle> all = std::move(all_);
        std::size_t count = 0;
        for (const Handle instance : all) {
            if (!machine_.tree.alive(instance)) continue;
            machine_.tree.each_below(instance, [&](Handle) { ++count; });
            machine_.tree.destroy(instance);
        }
        return count;
    }

  private:
    Machine& machine_;
    std::vector<Handle> all_;
};

// Opens an edit and turns recording on for one command. The destructor ends both, even after an
// error.
class Session {
  public:
    Session(Machine& machine, std::string_view command)
        : machine_(machine), edits_(machine.tree.changeable()) {
        // A formula that is typed into a field of the inspector is run as a command, too.
        const property::Writer writer = machine.tree.cause().writer == property::Writer::inspector
                                            ? property::Writer::inspector
                                            : property::Writer::console;
        if (edits_) {
            const property::Tree::CauseScope scope(machine.tree, writer);
            machine.tree.begin_edit(cut(one_line(command), 80));
        }
        machine.recording = {};
        machine.recording.active = true;
        machine.recording.writer = writer;
    }
    ~Session() {
        machine_.recording.writer = property::Writer::script;
        machine_.recording.active = false;
        if (edits_) machine_.tree.end_edit();
    }
    Session(const Session&) = delete;

  private:
    Machine& machine_;
    const bool edits_;  // inside a formula or a question nothing may be changed
};

Limits limits(const Machine& machine) {
    const auto memory = machine.host.command_memory;  // a copy, because the call may replace it
    return {.instructions = machine.options.console_budget,
            .memory = memory ? memory() : machine.options.console_memory,
            .raised_by = machine.host.memory_property};
}

/// Runs the commands one after the other, until one has an error. Each is a step of undo.
Evaluation evaluated_in_turn(Machine& machine, const std::vector<std::string>& commands) {
    Evaluation all;
    for (const std::string& command : commands) {
        Evaluation next = evaluate(machine, command);
        append(all, std::move(next));
        if (!all.ok) break;
    }
    return all;
}

}  // namespace

Evaluation evaluate(Machine& machine, std::string_view command) {
    Evaluation evaluation;
    command = trimmed(command);
    if (command.empty()) {
        evaluation.ok = true;
        return evaluation;
    }
    if (command.front() == '=') command.remove_prefix(1);
    machine.sources.commands.store(command, machine.sources.texts);
    const std::size_t without_undo = property::edits_without_undo(machine.tree);
    std::vector<std::string> several;
    {
        const Session session(machine, command);
        CreatedInstances made(machine);
        const Budget::Scope budget(machine.limiters.budget, limits(machine));
        const bool ok = protected_run(
            machine, "console",
            [&](lua_State* L) { run(L, machine, command, evaluation, several); }, false);
        if (!ok) {
            evaluation.error = std::move(machine.errors.caught);
            if (evaluation.error) machine.sources.commands.name_plainly(*evaluation.error);
            machine.errors.caught.reset();
            if (machine.life.in_tree && machine.limiters.budget.memory_exceeded())
                if (const std::size_t count = made.destroy(); count > 0)
                    evaluation.error->message +=
                        "; these " + std::to_string(count) + " instances are deleted again";
            // The output before the error is shown, too.
            take_lines(machine, evaluation);
        }
        evaluation.ok = ok && !evaluation.incomplete;
        if (!evaluation.incomplete) add_echoes(machine, evaluation);
    }
    if (!several.empty() && evaluation.ok) return evaluated_in_turn(machine, several);
    if (machine.life.has_tree())
        if (std::string lost = lost_undo(machine, without_undo); !lost.empty())
            evaluation.lines.push_back(std::move(lost));
    if (evaluation.ok) machine.classes.deliver_ready();
    return evaluation;
}

}  // namespace fettle::script
