#include <files/settings.h>

#include <fettle/property/storage/game_files.h>

#include <files/archive.h>
#include <files/game_path.h>

namespace fettle::program {

property::GameSettings read_settings(const std::filesystem::path& game) {
    property::GameFiles files;
    files.stay_below(folder_of(game));
    if (const auto archive = archive_of(game); !archive.empty())
        for (auto& [name, content] : read_archive(archive, "game.json"))
            files.put(archive / name, std::move(content));
    return property::read_game_settings(files, game, FETTLE_VERSION);
}

}  // namespace fettle::program
