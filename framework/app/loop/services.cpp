#include <fettle/app/services.h>

#include <functional>
#include <string>

#include <fettle/property/ended_class.h>
#include <fettle/property/error.h>

#include <loop/cameras.h>
#include <loop/effects.h>

namespace fettle::app {

namespace {

/// The classes of the services, the first one first, and their instances below the root. A test
/// compares them with the tree.
constexpr const char* class_names[] = {
    "Time",    "Timings",     "View",  "Show",  "GameWindow", "Audio",  "Buses",
    "Bus",     "SoundSource", "Sound", "Music", "Synth",      "Voice",  "Input",
    "Actions", "Action",      "Keys",  "Mouse", "Gamepad",    "Camera", "Uniforms"};
constexpr const char* instance_names[] = {"time", "view", "audio", "input"};

/// Throws if a name that the services need is already used in the tree. If a constructor failed
/// later, instances would stay whose values have no memory.
void require_room(const property::Tree& tree) {
    const auto refuse = [](const std::string& what) {
        throw property::Error(property::ErrorKind::bad_name,
                              "the services cannot be added: " + what + " already");
    };
    for (const char* name : class_names)
        if (tree.find_class(name) != nullptr)
            refuse("the tree has a class \"" + std::string(name) + "\"");
    const property::Handle root = tree.root();
    for (const char* name : instance_names)
        if (tree.child(root, name) || tree.find(root, name) != nullptr)
            refuse("the root has a \"" + std::string(name) + "\"");
}

}  // namespace

// Input uses the view.
Services::Services(property::Tree& tree, property::Assets* game_assets)
    : audio(define(tree), view, clock, game_assets),
      input(tree, view),
      assets(game_assets),
      tree_(tree),
      tree_life_(tree.lifetime()),
      cameras_(std::make_unique<Cameras>(tree, view)),
      effects_(std::make_unique<Effects>(tree, view, game_assets)) {
    tree.add_part(clock_part_);
}

// Deletes the instances, because the tree would otherwise still read their values, for example to
// notify watchers that an instance was deleted.
Services::~Services() {
    if (tree_life_.expired()) return;
    tree_.remove_part(clock_part_);
    std::function<std::string()> where = [] { return std::string("the end of app::Services"); };
    // No edit: undo could not bring them back.
    const property::Tree::CauseScope scope(tree_, property::Writer::load, &where);
    // If an instance cannot be deleted, the exception leaves this destructor, and the program ends
    // with its message.
    for (const char* name : class_names) property::end_class(tree_, tree_.class_named(name));
}

void Services::on_effect_problem(std::function<void(const std::string&)> report) {
    effects_->on_problem(std::move(report));
}

void Services::renew_effect(const std::string& name) {
    effects_->renew(name);
}

property::Tree& Services::define(property::Tree& tree) {
    require_room(tree);
    define_clock(tree, clock);
    define_view(tree, view);
    return tree;
}

}  // namespace fettle::app
