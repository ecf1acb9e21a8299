#pragma once
// The modules of a running game: the built-in modules, and those that the command line or the
// game's manifest names.

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/module/plugin.h>

namespace fettle::program {

class GameModules {
  public:
    /// Opens the modules in `modules.json` in the game's folder, then those in `named`. A module
    /// with the name of a built-in module replaces it. Throws FileError, property::FileError,
    /// property::SceneError and module::LoadError.
    GameModules(const std::filesystem::path& game, std::span<const std::string> named);
    ~GameModules();

    /// Registers the classes of all modules, and the service `game.modules` if a module is plugged
    /// in. Throws module::LoadError.
    void attach(property::Tree& tree);
    /// The modules of the command line, as absolute paths of their files.
    const std::vector<std::string>& named() const { return named_; }
    /// The files that determine the modules and their behavior: the manifest, whether it exists or
    /// not, and the files of the modules.
    const std::vector<std::filesystem::path>& files() const { return files_; }
    /// All modules in the order in which they are stepped.
    std::vector<module::Module*> all() const;
    /// Sets the receiver of the modules' output and of the messages about reloads.
    void on_print(std::function<void(std::string_view)> sink);
    /// Sets the receiver of errors of functions of plugged-in modules that return no status.
    void on_error(
        const std::function<void(const std::string& module, const std::string& message)>& sink);
    /// Sets the receiver of notes that the built-in physics module makes about the game. To be
    /// called after `attach`.
    void on_note(const std::function<void(const std::string&)>& sink);
    /// Reloads the modules for which a reload was requested, or that follow their file if it has
    /// changed. To be called between frames.
    void renew();

  private:
    struct Plugged;
    void define_service(property::Tree& tree);
    void require_classes_of_references(const property::Tree& tree) const;
    void reload(Plugged& plugged);

    std::vector<std::unique_ptr<module::Module>> built_in_;
    module::Plugins plugins_;
    std::vector<std::string> named_;
    std::vector<std::filesystem::path> files_;
    std::vector<std::unique_ptr<Plugged>> plugged_;  // by row of their instances
    std::function<void(std::string_view)> print_;
    std::uint64_t frames_ = 0;
};

/// The names and paths in a game's manifest, unchanged; empty without a manifest. Throws
/// property::SceneError and property::FileError.
std::vector<std::string> manifest(const std::filesystem::path& game);

/// The file of a module that the manifest names; a path is relative to the folder of the game.
/// Throws FileError as `module_file` does.
std::filesystem::path listed_module_file(const std::string& name,
                                         const std::filesystem::path& game);

/// The file of a module that the command line names: `name` itself if it is a path, else NAME.so in
/// the game's folder or among the installed modules. Throws FileError that lists the searched
/// places.
std::filesystem::path module_file(const std::string& name, const std::filesystem::path& game);

}  // namespace fettle::program
