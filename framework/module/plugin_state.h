#pragma once
// The private state of a plug-in, and the phases of its trial.

#include <memory>
#include <string>
#include <vector>

#include <fettle/module/plugin.h>

#include "bridge/class_bridge.h"
#include "bridge/host_table.h"
#include "shared_object.h"

namespace fettle::module {

/// An opened module: its file in memory, and the structure that its entry point filled in.
struct OpenModule {
    SharedObject object;
    fettle_module native{};
};

struct Plugin::State {
    std::filesystem::path file;
    FileIdentity identity;
    std::string name, version;
    HostTable host;
    OpenModule open;
    std::unique_ptr<ModuleCopy> opened_copy;  // of `open`, for its trial when it is attached
    std::vector<std::unique_ptr<BridgedClass>> classes;
    std::weak_ptr<const property::Tree*> tree_life;  // of `host.tree`

    /// Opens a copy of the file and calls its entry point. Throws LoadError.
    OpenModule open_file(const std::filesystem::path& copy);
    /// From now on the module acts on the tree and may register classes.
    void prepare(property::Tree& tree);
    /// Lets the module register its classes in `host.tree`. Throws property::Error, or
    /// std::invalid_argument with the module's reason.
    void attach_native();
    /// Calls the module's own test, if it has one.
    void check_native();
    /// Makes one step as the game does, to test that it returns.
    void step_once();
    void step(double dt);
    void report();
    std::uint64_t hash();
    void close_native();
    /// Ends a module that a failure left half attached. Its instances stay, with the defaults as
    /// values. A later reload may bring the module back.
    void abandon();
    /// Ends the classes, so that the tree does not use this object any more, and forgets the tree.
    void leave_tree();
    /// Throws std::runtime_error after `abandon`.
    void require_loaded() const;
    /// Whether the module saves its own rows in snapshots.
    bool saves() const { return open.native.save != nullptr && open.native.restore != nullptr; }
};

/// The phases of a trial, for messages.
inline constexpr const char* while_opened = "while it was opened";
inline constexpr const char* while_attached = "while it registered its classes";
inline constexpr const char* in_its_test = "in its own test";
inline constexpr const char* in_a_step = "in a step";

}  // namespace fettle::module
