#include <game/packed_modules.h>

#include <string>
#include <utility>

#include <fettle/module/plugin.h>
#include <fettle/property/storage/game_files.h>

#include <files/game_path.h>
#include <game/game_modules.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

bool is_installed(const fs::path& module) {
    return fs::weakly_canonical(module.parent_path()) == installed_modules();
}

[[noreturn]] void refuse(const std::string& module, const std::string& why) {
    throw FileError("modules.json: \"" + module + "\": " + why);
}

}  // namespace

void require_installed_modules(const fs::path& game) {
    for (const std::string& name : manifest(game))
        if (!is_installed(listed_module_file(name, game)))
            refuse(name,
                   "an archive cannot bring native modules along, only name those that are "
                   "installed with Fettle; use --linux or --deb");
}

std::vector<fs::path> bring_modules(const fs::path& game, ArchiveFiles& files) {
    property::GameFiles reader;
    std::vector<fs::path> libraries;
    for (const std::string& name : manifest(game)) {
        const fs::path file = listed_module_file(name, game);
        if (is_installed(file)) {
            // A module is looked for beside the game first.
            files[file.filename().string()] = reader.read(file);
        } else if (!files.contains(file.lexically_relative(folder_of(game).lexically_normal())
                                       .generic_string())) {
            refuse(name, "its file must be in the game's folder, as a part of the game");
        }
        try {
            for (fs::path& library : module::needed_libraries(file))
                libraries.push_back(std::move(library));
        } catch (const module::LoadError& error) {
            refuse(name, std::string("it cannot be loaded: ") + error.what());
        }
    }
    return libraries;
}

}  // namespace fettle::program
