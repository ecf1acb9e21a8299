#include <files/file_errors.h>

#include <fettle/app/recording.h>
#include <fettle/module/plugin.h>
#include <fettle/property/storage/game_files.h>

#include <command_line/exit_status.h>
#include <command_line/terminal.h>
#include <files/game_path.h>

namespace fettle::program {

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
