#include <values/drawn_changes.h>

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

}  // namespace

void note_drawn_change(Machine& machine, Handle instance, std::string_view name) {
    const property::Tree& tree = machine.tree;
    Recording& recording = machine.recording;
    if (!recording.drawing || !machine.host.on_note || !tree.alive(instance) ||
        !tree.is_below(instance, tree.root()) || is_of_view(tree, instance))
        return;
    const std::string about = tree.class_of(instance).name() + "." + std::string(name);
    if (recording.drawn_changes.size() >= most_notes ||
        !recording.drawn_changes.insert(about).second)
        return;
    std::string path = tree.path(instance);
    if (!name.empty()) path += property::path_suffix(name);
    machine.host.on_note(position(machine.lua.running) + "a function that draws changes " + path +
                         ": how often it is called depends on the screen, and a headless run does "
                         "not call it, so replays and tests differ; change it in step or update");
}

}  // namespace fettle::script
