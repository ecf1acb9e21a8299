#pragma once
// The modules of a running game: those that are part of the program, and those that plug in because
// the command line or the game's manifest names them.

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
    /// Opens what `modules.json` in the game's folder names, then `named`. One that is called as a
    /// built-in module is takes its place. Throws FileError, property::FileError and
    /// module::LoadError.
    GameModules(const std::filesystem::path& game, std::span<const std::string> named);
    ~GameModules();

    /// Registers the classes of all; where any is plugged in, the service `game.modules` too.
    /// Throws module::LoadError.
    void attach(property::Tree& tree);
    /// Those of the command line, each by the whole path of its file.
    const std::vector<std::string>& named() const { return named_; }
    /// What decides which there are and what they do: the manifest's file, be it there or not, and
    /// those of the modules.
    const std::vector<std::filesystem::path>& files() const { return files_; }
    /// In the order they are stepped in.
    std::vector<module::Module*> all() const;
    /// Where what modules print goes, and what is told of those taken in anew.
    void on_print(std::function<void(std::string_view)> sink);
    /// Takes in anew the modules for which that was asked, or whose file has changed while they
    /// follow it. Between frames.
    void renew();

  private:
    struct Plugged;
    void define_service(property::Tree& tree);
    void reload(Plugged& plugged);

    std::vector<std::unique_ptr<module::Module>> built_in_;
    module::Plugins plugins_;
    std::vector<std::string> named_;
    std::vector<std::filesystem::path> files_;
    std::vector<std::unique_ptr<Plugged>> plugged_;  // by row of their instances
    std::function<void(std::string_view)> print_;
    std::uint64_t frames_ = 0;
};

/// The files a game's manifest names, as they stand there; none without a manifest. Throws
/// FileError and property::FileError.
std::vector<std::string> manifest(const std::filesystem::path& game);

/// The file of a module: `name` itself where it is a path; else NAME.so in the game's folder or
/// among the installed modules. Throws FileError that tells where it was looked for.
std::filesystem::path module_file(const std::string& name, const std::filesystem::path& game);

}  // namespace fettle::program
