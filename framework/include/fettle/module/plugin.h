#pragma once
// Modules in shared objects. docs/guide/hosting.md shows how to write one; docs/design/modules.md
// has the rules of the C interface.

#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/module/export.h>
#include <fettle/module/module.h>

FETTLE_MODULE_BEGIN

namespace fettle::module {

/// A shared object could not be loaded. The message names the file, what was expected and what was
/// found.
class LoadError : public std::runtime_error {
  public:
    /// With this message.
    explicit LoadError(const std::string& message) : std::runtime_error(message) {}
    /// With a message of the file and the reason.
    LoadError(const std::filesystem::path& file, const std::string& reason)
        : std::runtime_error(file.string() + ": " + reason) {}
};

/// Result of a reload.
struct Reloaded {
    std::size_t instances = 0;  // that still live
    std::size_t values = 0;     // that were set again on these instances
    /// The changes, one line each: a removed property, or a value that the new module refuses.
    std::vector<std::string> notes;
};

/// A module in a shared object. It stays in the process as long as this object lives. If this
/// object ends before the tree that it is attached to, its instances are deleted, and its classes
/// can have no others.
///
/// The module is tested before it is attached: opening, attaching, its own test and a step happen
/// first in another process (trial_program.h), so that a module that crashes does so there and is
/// refused with the reason.
class Plugin : public Module {
  public:
    /// Opens the file and gets the module's name; registers nothing. Throws LoadError.
    static std::unique_ptr<Plugin> open(const std::filesystem::path& file);
    ~Plugin() override;
    Plugin(const Plugin&) = delete;
    Plugin& operator=(const Plugin&) = delete;

    const std::filesystem::path& file() const;  ///< as it was given to `open`
    /// Version from the module; "" if it has none.
    const std::string& version() const;
    /// Sets the receiver of the module's output; without it, the output goes to stdout.
    void on_print(std::function<void(std::string_view)> sink);
    /// Sets the receiver of errors of functions of the module that return no status, such as
    /// "step: no wind"; without it, they are printed, after the name of the module.
    void on_error(std::function<void(const std::string&)> sink);

    std::string_view name() const override;
    /// Throws LoadError if a class or an instance of a name already exists, if the module refuses,
    /// if its own test fails, or if it crashes.
    void attach(property::Tree& tree) override;
    void step(double dt) override;
    void report(property::Tree& tree) override;
    std::uint64_t hash() const override;
    void refresh(std::uint64_t what) override;
    property::Memory save(property::ByteWriter& to) const override;
    std::function<void()> restore(property::ByteReader& from, const property::Memory&) override;

    /// Loads the current file, best between two frames: saves the values
    /// of the module's instances by name, ends the old module, opens the new one, and sets the
    /// values again on the same handles, with the same children, watchers and formulas. Values are
    /// saved by name, never as bytes, so the new module may have another memory layout. If the test
    /// of the new module fails, throws LoadError and keeps the old module. Throws std::logic_error
    /// while a function of the module runs, and if it is attached to no tree or its tree has ended.
    Reloaded reload();

    struct FETTLE_MODULE_PRIVATE State;

  private:
    explicit Plugin(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Tries to open the module in another process, as `Plugin::open` does first, and returns the files
/// of the shared libraries that were in it then: those of the module and of fettle-trial. Nothing
/// is loaded here. Throws LoadError with the reason if the module cannot be opened.
std::vector<std::filesystem::path> needed_libraries(const std::filesystem::path& file);

/// The modules of a game. Each file and each name occurs once.
class Plugins {
  public:
    /// Throws LoadError, also if the file, or another with a module of the same name, is already
    /// loaded.
    Plugin& open(const std::filesystem::path& file);
    /// In order of opening.
    const std::vector<std::unique_ptr<Plugin>>& all() const { return plugins_; }
    /// Null if there is no module of that name.
    Plugin* find(std::string_view name) const;

  private:
    std::vector<std::unique_ptr<Plugin>> plugins_;
};

}  // namespace fettle::module

FETTLE_MODULE_END
