#pragma once

#include <memory>
#include <string>
#include <vector>

#include <fettle/module/plugin.h>

#include "class_bridge.h"
#include "host_table.h"
#include "shared_object.h"

namespace fettle::module {

/// A module as it was opened: the file in memory and what its entry point filled in.
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
    std::vector<std::unique_ptr<BridgedClass>> classes;

    /// Opens a copy of `file` and calls its entry point. Throws LoadError.
    OpenModule open_file(const ModuleCopy& copy);
    /// The module registers its classes in `host.tree`. Throws property::Error, or
    /// std::invalid_argument with the module's own reason.
    void attach_native();
    /// The module's own test, if it has one.
    void check_native();
    /// A step as the game will make it, to see whether the module comes back from it.
    void step_once();
    void close_native();
    /// Whether it says itself what its rows are, for snapshots.
    bool saves() const { return open.native.save != nullptr && open.native.restore != nullptr; }
};

/// The phases of a trial, for the message.
inline constexpr const char* while_opened = "while it was opened";
inline constexpr const char* while_attached = "while it registered its classes";
inline constexpr const char* in_its_test = "in its own test";
inline constexpr const char* in_a_step = "in a step";

}  // namespace fettle::module
