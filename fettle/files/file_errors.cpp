#include <files/file_errors.h>

#include <system_error>

#include <fettle/app/recording.h>
#include <fettle/module/plugin.h>
#include <fettle/property/storage/game_files.h>

#include <ending/exit_status.h>
#include <files/game_path.h>
#include <terminal/terminal.h>

namespace fettle::program {

int with_file_errors(const std::function<int()>& command) {
    try {
        return command();
    } catch (const FileError& error) {
        print_error(error.what());
    } catch (const property::FileError& error) {
        print_error(error.what());
    } catch (const property::SceneError& error) {
        print_error(error.what());  // of game.json
    } catch (const app::RecordingError& error) {
        print_error(error.what());
    } catch (const module::LoadError& error) {
        print_error(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        // A copy names two files, and these errors are those of the second one.
        const bool of_target = error.code() == std::errc::no_space_on_device ||
                               error.code() == std::errc::read_only_file_system;
        const std::filesystem::path& file =
            of_target && !error.path2().empty() ? error.path2() : error.path1();
        print_error(file.string() + ": " + error.code().message());
    }
    return file_error;
}

}  // namespace fettle::program
