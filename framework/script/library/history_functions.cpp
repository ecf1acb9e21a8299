// Functions for the history of edits and the causes of values:
//   undo()  redo()  history()  edit(name, function)  who(path)  why(path)

#include <fettle/property/earlier_writer.h>
#include <fettle/property/edits.h>
#include <fettle/property/path.h>

#include <handlers/observed.h>
#include <library/library.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <motion/tweens.h>
#include <sandbox/sandbox.h>
#include <text/columns.h>
#include <text/folded_rows.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

using property::Explanation;
using property::Place;

namespace {

/// The property that gives the history more memory; "" if this game has none.
std::string memory_hint(const Machine& machine) {
    const property::Tree& tree = machine.tree;
    const Handle time = tree.child(tree.root(), "time");
    const property::Property* const memory = time ? tree.find(time, "rewind_memory") : nullptr;
    if (memory == nullptr) return {};
    return "with a larger time.rewind_memory (" +
           tree.text(tree.peek(time, *memory), memory->precision()) + " " + memory->unit +
           " now), the next edit of this size can be undone";
}

void report(Machine& machine, const char* what, const property::UndoResult& result) {
    if (!result.done) return print_line(machine, std::string("nothing to ") + what);
    std::vector<std::string> lines = {std::string(what) + ": " + result.name};
    for (const property::UndoChange& change : result.changes)
        lines.push_back("  " + change.path + ": " +
                        (change.from.empty() ? "" : cut(change.from, 60) + " → ") +
                        cut(change.to, 60));
    FoldedLines folded;
    fold_rows(lines,
              {.before = 1,
               .shown = shown_changes,
               .total = result.changes.size() + result.more_changes,
               .what = "changes"},
              folded);
    print_folded(machine, std::move(lines), std::move(folded));
    for (const std::string& note : result.notes) print_line(machine, "  " + note);
    if (const std::string hint = result.too_large ? memory_hint(machine) : ""; !hint.empty())
        print_line(machine, "  " + hint);
}

/// Tweens of an instance that was deleted have ended, and are not part of the history.
void report_ended_tweens(Machine& machine, const std::vector<Handle>& deleted_targets) {
    for (const Handle each : deleted_targets)
        if (machine.tree.alive(each))
            print_line(machine, "  tweens of " + machine.tree.path(each) +
                                    " ended when it was deleted; they are not brought back");
}

/// Calls `reverse` as often as the argument says: once without one.
int repeat(lua_State* L, const char* what, property::UndoResult (property::Tree::*reverse)()) {
    Machine& machine = machine_of(L);
    lua_Integer count = 1;
    if (!lua_isnoneornil(L, 1)) {
        int is_integer = 0;
        count = lua_tointegerx(L, 1, &is_integer);
        if (is_integer == 0 || count < 1)
            throw Error(ErrorKind::wrong_type,
                        std::string(what) + ": needs a number of edits, such as 3");
    }
    bool done = true;
    for (lua_Integer i = 0; i < count && done; ++i) {
        const std::vector<Handle> deleted_targets = machine.tweens.deleted_targets();
        const property::UndoResult result = (machine.tree.*reverse)();
        done = result.done;
        if (done || i == 0) report(machine, what, result);
        report_ended_tweens(machine, deleted_targets);
    }
    return 0;
}

int undo(lua_State* L) {
    return repeat(L, "undo", &property::Tree::undo);
}

int redo(lua_State* L) {
    return repeat(L, "redo", &property::Tree::redo);
}

int history(lua_State* L) {
    Machine& machine = machine_of(L);
    const auto entries = machine.tree.history();
    for (const property::HistoryEntry& entry : entries)
        print_line(machine, (entry.undone ? "  (undone) " : "  ") + entry.name + "   " +
                                entry.cause.text() +
                                (entry.too_large ? "   (too large to be undone)" : ""));
    if (entries.empty()) print_line(machine, "nothing was edited");
    return 0;
}

int edit(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING || lua_type(L, 2) != LUA_TFUNCTION)
        throw Error(ErrorKind::wrong_type, "edit: needs a name and a function");
    Machine& machine = machine_of(L);
    const std::size_t before = property::edits_without_undo(machine.tree);
    std::string name = string_at(L, 1);
    property::check_name_length(name);
    machine.tree.begin_edit(std::move(name));
    {
        struct End {
            property::Tree& tree;
            ~End() { tree.end_edit(); }
        } end{machine.tree};
        lua_settop(L, 2);
        lua_call(L, 0, 0);
    }
    if (std::string lost = lost_undo(machine, before); !lost.empty())
        print_line(machine, std::move(lost));
    return 0;
}

Place place_at(lua_State* L, const char* what) {
    Machine& machine = machine_of(L);
    const std::string path = with_selected(
        machine, check_text(L, 1, std::string(what) + ": needs a path like \"world.ball.mass\""));
    Place place = property::resolve(machine.tree, path);
    // A part that the value does not have, such as the x of a number, is refused.
    if (!place.part.empty())
        (void)property::part_of(machine.tree.peek(place.instance, *place.property), place.part,
                                path);
    return place;
}

std::string writer_text(const property::Tree& tree, const Place& place) {
    const std::string text = last_writer_text(tree, place.instance, *place.property);
    return text.empty() ? "no recent write is known" : text;
}

/// The last writer of each property of the instance that has a known one.
void print_writers(Machine& machine, Handle instance) {
    const property::Tree& tree = machine.tree;
    bool any = false;
    for (const property::Property* property : tree.properties(instance)) {
        const Place place{instance, property, {}};
        if (!tree.last_writer(instance, *property).known) continue;
        print_line(machine, tree.path(instance, *property) + ": " + writer_text(tree, place));
        any = true;
    }
    if (!any) print_line(machine, tree.path(instance) + ": no recent write is known");
}

int who(lua_State* L) {
    Machine& machine = machine_of(L);
    const Place place = place_at(L, "who");
    if (place.property == nullptr) {
        print_writers(machine, place.instance);
        return 0;
    }
    print_line(machine, machine.tree.path(place.instance, *place.property) + ": " +
                            writer_text(machine.tree, place));
    return 0;
}

void explain(Machine& machine, const Explanation& why, const std::string& indent) {
    std::string line = indent + why.path + (why.value.empty() ? "" : " = " + why.value);
    if (!why.source.empty()) line += "   is " + one_line(why.source);
    if (!why.problem.empty()) line += "   in error: " + why.problem;
    if (why.repeated) line += "   (see above)";
    print_line(machine, line);
    for (const Explanation& source : why.from) explain(machine, source, indent + "  ");
}

int why(lua_State* L) {
    Machine& machine = machine_of(L);
    const Place place = place_at(L, "why");
    if (place.property == nullptr)
        throw Error(ErrorKind::wrong_type, "why: " + machine.tree.path(place.instance) +
                                               " is an instance; name one of its properties");
    const Explanation explanation = machine.tree.why(place.instance, *place.property);
    explain(machine, explanation, "");
    if (!explanation.source.empty()) return 0;
    // What a module has explained needs no line that names the simulation, which does not even move
    // a static body.
    const property::Provenance writer = machine.tree.last_writer(place.instance, *place.property);
    const bool says_more = writer.known && writer.cause.writer != property::Writer::simulation;
    if (explanation.from.empty() || says_more) who(L);
    return 0;
}

}  // namespace

std::string lost_undo(const Machine& machine, std::size_t before) {
    if (property::edits_without_undo(machine.tree) == before) return {};
    const std::string hint = memory_hint(machine);
    return std::string(property::no_undo_message) + (hint.empty() ? "" : "; " + hint);
}

void open_history(lua_State* L) {
    add_function<undo>(L, "undo");
    add_function<redo>(L, "redo");
    add_function<history>(L, "history");
    add_function<edit>(L, "edit");
    add_function<who>(L, "who");
    add_function<why>(L, "why");
}

}  // namespace fettle::script
