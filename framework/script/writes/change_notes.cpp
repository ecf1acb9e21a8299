#include <writes/change_notes.h>

#include <string>

#include <fettle/property/path.h>

#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <values/recording.h>

namespace fettle::script {

namespace {

constexpr std::size_t most_notes = 20;

/// What the view, the window and the cameras show is not part of the simulation.
bool is_of_view(const property::Tree& tree, Handle instance) {
    const Handle view = tree.child(tree.root(), "view");
    return instance == view || (view && tree.is_below(instance, view)) ||
           tree.class_of(instance).name() == "Camera";
}

/// True for `game` itself, too: its properties are the variables that state(...) declares.
bool in_game(const property::Tree& tree, Handle instance) {
    return instance == tree.root() || tree.is_below(instance, tree.root());
}

std::string path_of(const property::Tree& tree, Handle instance, std::string_view name) {
    return name.empty() ? tree.path(instance) : tree.path(instance) + property::path_suffix(name);
}

void note_drawn_change(Machine& machine, Handle instance, std::string_view name) {
    const property::Tree& tree = machine.tree;
    Recording& recording = machine.recording;
    const std::string about = tree.class_of(instance).name() + "." + std::string(name);
    if (recording.drawn_changes.size() >= most_notes ||
        !recording.drawn_changes.insert(about).second)
        return;
    machine.host.on_note(position(machine.lua.running) + "a function that draws changes " +
                         path_of(tree, instance, name) +
                         ": how often it is called depends on the screen, and a headless run does "
                         "not call it, so replays and tests differ; change it in step or update");
}

/// A game that goes back to the snapshot finds the changes in it.
void note_late_change(Machine& machine, Handle instance, std::string_view name) {
    const property::Tree& tree = machine.tree;
    const Property* const property = tree.find(instance, name);
    if (property != nullptr && property->transient) return;
    machine.recording.after_snapshot = false;
    machine.recording.late_change_noted = true;
    machine.host.on_note(position(machine.lua.running) + path_of(tree, instance, name) +
                         " changes after snapshot(), which holds the game as it is when this "
                         "function has ended, with the change. To go back to the moment before, "
                         "take the snapshot at the end of the last turn, or call wait(0) after it "
                         "in a coroutine");
}

}  // namespace

void note_change(Machine& machine, Handle instance, std::string_view name) {
    const property::Tree& tree = machine.tree;
    const Recording& recording = machine.recording;
    if (!recording.noting() || !machine.host.on_note || !tree.alive(instance) ||
        !in_game(tree, instance) || is_of_view(tree, instance))
        return;
    if (recording.drawing) note_drawn_change(machine, instance, name);
    if (recording.after_snapshot) note_late_change(machine, instance, name);
}

}  // namespace fettle::script
