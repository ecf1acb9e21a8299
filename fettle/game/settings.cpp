#include <game/settings.h>

#include <fettle/property/storage/game_files.h>

#include <game/game_path.h>

namespace fettle::program {

property::GameSettings read_settings(const std::filesystem::path& game) {
    property::GameFiles files;
    files.stay_below(folder_of(game));
    return property::read_game_settings(files, game, FETTLE_VERSION);
}

}  // namespace fettle::program
