// Moments of a game: written by the console's `share`, opened when a game begins from one.

#include <fettle/property/error.h>
#include <fettle/property/restoring.h>
#include <fettle/property/snapshot_remarks.h>

#include <files/archive.h>
#include <files/game_path.h>
#include <game/moment.h>
#include <session/console_layer.h>
#include <session/session.h>

namespace fettle::program {

std::string Session::share(const std::string& name) {
    const auto refuse = [](const std::string& why) {
        throw property::Error(property::ErrorKind::rejected, "share: " + why);
    };
    if (replayed_ != nullptr) return "share: a replay writes no files";
    if (tree_.cause().writer != property::Writer::console)
        refuse("only a command of the console writes a moment");
    if (options_.sandbox || isolated()) refuse("this run writes no files");
    if (!options_.modules.empty()) refuse("a moment cannot bring native modules along");
    const std::filesystem::path file =
        moment_file(property::player_folder(options_.game, settings_.id), name);
    const Moment moment{.state = tree_.snapshot(),
                        .step = services_->clock.step,
                        .fettle = FETTLE_VERSION,
                        .tweaks = tweak_lines(tweaks_->list())};
    try {
        write_moment(file, options_.game, moment, recorder_ ? recorder_->text() : std::string());
    } catch (const FileError& error) {
        refuse(error.what());
    }
    return "step " + std::to_string(moment.step) + " is in " + file.string() +
           "; fettle run opens it there";
}

/// As with a saved game, the state replaces everything that the game made when it began.
void Session::open_moment() {
    const std::optional<Moment> moment = moment_of(options_.game);
    if (!moment) return;
    const std::string file = archive_of(options_.game).string();
    try {
        tree_.restore(moment->state);
    } catch (const property::Error& error) {
        throw FileError(file + ": its moment cannot be opened: " + error.what());
    }
    for (const std::string& remark : property::restore_remarks(tree_)) note(file + ": " + remark);
    note("this is step " + std::to_string(moment->step) + " of a shared moment" +
         (moment->tweaks.empty() ? std::string() : ", with these edits:"));
    for (const std::string& tweak : moment->tweaks) note("  " + tweak);
    // In a window, the game is paused, so that the player can look at the moment first.
    if (options_.headless) return;
    const property::Tree::CauseScope cause(tree_, property::Writer::module);
    tree_.set(tree_.child(tree_.root(), "time"), "paused", true);
    if (console_) console_->show_pause();
}

}  // namespace fettle::program
