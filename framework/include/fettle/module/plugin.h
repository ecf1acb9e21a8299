#pragma once
// Modules in shared objects. docs/guide/hosting.md shows one being written,
// docs/design/modules.md tells the rules of the border.

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

/// A shared object could not be taken in. The message names the file, what was expected and what
/// was found.
class LoadError : public std::runtime_error {
  public:
    explicit LoadError(const std::string& message) : std::runtime_error(message) {}
    LoadError(const std::filesystem::path& file, const std::string& reason)
        : std::runtime_error(file.string() + ": " + reason) {}
};

/// What came of taking in a module anew.
struct Reloaded {
    std::size_t instances = 0;  // that live on
    std::size_t values = 0;     // that were given back to them
    /// What is not as it was, a line each: a property that is gone, a value its owner now refuses.
    std::vector<std::string> notes;
};

/// A module in a shared object. It stays in the process as long as this lives, which must be longer
/// than the tree it is attached to.
///
/// The module is tried before it is let in: opening it, attaching it and its own test happen first
/// in a forked copy of the process, so that a module that crashes does so there and is refused with
/// the reason.
class Plugin : public Module {
  public:
    /// Opens the file and asks the module for its name; nothing is registered yet. Throws
    /// LoadError.
    static std::unique_ptr<Plugin> open(const std::filesystem::path& file);
    ~Plugin() override;
    Plugin(const Plugin&) = delete;
    Plugin& operator=(const Plugin&) = delete;

    const std::filesystem::path& file() const;
    /// As the module gives it; "" when it gives none.
    const std::string& version() const;
    /// Where what the module prints goes; without it, to stdout.
    void on_print(std::function<void(std::string_view)> sink);

    std::string_view name() const override;
    /// Throws LoadError: a class or an instance of that name is there already, the module refuses,
    /// its own test fails, or it crashes.
    void attach(property::Tree& tree) override;
    void step(double dt) override;
    void report(property::Tree& tree) override;
    std::uint64_t hash() const override;
    void refresh(std::uint64_t what) override;
    property::Memory save(property::ByteWriter& to) const override;
    std::function<void()> restore(property::ByteReader& from, const property::Memory&) override;

    /// Takes in the file as it is now, between two frames and not from within a handler: saves the
    /// values of the module's instances by name, ends the old module, opens the new one, and gives
    /// the instances back, the same handles with the same children, watchers and formulas. Values
    /// go by name, never by bytes, so the new module may lay out its memory as it likes. Throws
    /// LoadError and leaves the old module as it was when the new one fails its trial.
    Reloaded reload();

    struct FETTLE_MODULE_PRIVATE State;

  private:
    explicit Plugin(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// The modules of a game: no file and no name twice.
class Plugins {
  public:
    /// Throws LoadError, also when the file, or another with a module of the same name, is loaded
    /// already.
    Plugin& open(const std::filesystem::path& file);
    /// In order of opening.
    const std::vector<std::unique_ptr<Plugin>>& all() const { return plugins_; }
    /// Null when there is none of that name.
    Plugin* find(std::string_view name) const;

  private:
    std::vector<std::unique_ptr<Plugin>> plugins_;
};

}  // namespace fettle::module

FETTLE_MODULE_END
