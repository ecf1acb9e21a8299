#include "settings.h"

#include <fettle/app/recording.h>
#include <fettle/module/plugin.h>
#include <fettle/property/storage/game_files.h>

#include "exit_status.h"
#include "game_path.h"
#include "terminal.h"

namespace fettle::program {

property::GameSettings read_settings(const std::filesystem::path& game) {
    property::GameFiles files;
    files.stay_below(folder_of(game));
    return property::read_game_settings(files, game, FETTLE_VERSION);
}

int with_file_errors(const std::function<int()>& command) {
    try {
        return command();
    } catch (const FileError& error) {
        tell(error.what());
    } catch (const property::FileError& error) {
        tell(error.what());
    } catch (const property::SceneError& error) {
        tell(error.what());  // of game.json
    } catch (const app::RecordingError& error) {
        tell(error.what());
    } catch (const module::LoadError& error) {
        tell(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        tell(error.path1().string() + ": " + error.code().message());
    }
    return file_error;
}

}  // namespace fettle::program
