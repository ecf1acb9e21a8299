// Recordings of a run: a run in a window is recorded in memory from its first step, so that the
// console's `record` can write a file of what has already happened.

#include <fettle/property/error.h>
#include <fettle/property/storage/game_files.h>

#include <command_line/for_shell.h>
#include <files/archive.h>
#include <files/game_path.h>
#include <files/recorded_files.h>
#include <session/console_layer.h>
#include <session/exports.h>
#include <session/session.h>

namespace fettle::program {

/// Whether a recording is kept: it was requested, or the console may still request it.
bool Session::keeps_recording() const {
    if (!options_.record.empty()) return true;
    return !options_.headless && !options_.sandbox && replayed_ == nullptr && !isolated() &&
           archive_of(options_.game).empty() && has_console();
}

void Session::make_recorder() {
    if (!keeps_recording()) return;
    const property::Vec2 size = services_->view.screen;
    std::vector<std::string> test;
    if (options_.test) test = {options_.test->file, options_.test->name};
    recorder_ = std::make_unique<app::Recorder>(
        app::RunStart{.game = std::filesystem::absolute(options_.game),
                      .modules = modules_.named(),
                      .seed = seed(),
                      .width = size.x,
                      .height = size.y,
                      .evals = options_.evals,
                      .at = options_.at,
                      .tweaks = tweaks_->earlier_in_words(),
                      .test = test});
    // A test has thousands of steps, and its recording is replayed only if the test fails. The
    // hashes of every step would take a third of its time.
    if (!options_.record.empty()) recorder_->write_to(options_.record, options_.test ? 20 : 1);
    recorder_->file(recorded_text(KeptFile::store, store_->initial()));
    recorder_->file(recorded_text(KeptFile::preferences, preferences_->initial()));
    files_.on_first_access([this](const property::GameFiles::FileState& state) {
        recorder_->file(recorded(state, options_.game));
    });
    runtime_->on_command([this](std::string_view command) {
        if (console_) recorder_->selected(console_->selection());
        recorder_->command(command);
    });
}

/// Called for the command `record` and for the button of the time bar.
std::string Session::record(bool on) {
    if (replayed_ != nullptr) return "record: a replay writes no files";
    const auto refuse = [](const std::string& why) {
        throw property::Error(property::ErrorKind::rejected, "record: " + why);
    };
    if (tree_.cause().writer != property::Writer::console)
        refuse("only a command of the console records a run");
    if (!recorder_)
        refuse(
            "only a run of a game in a window, neither in a sandbox nor in an archive, can be "
            "recorded while it runs; for one without a window there is fettle run --record");
    const std::filesystem::path writing = recorder_->writes_to();
    if (!on) {
        if (writing.empty()) return "the run is not being recorded";
        recorder_->close();
        if (const std::string& problem = recorder_->problem(); !problem.empty()) refuse(problem);
        // The file may have been removed while it was written.
        std::error_code error;
        if (recorder_->complete() && !std::filesystem::exists(writing, error)) {
            try {
                recorder_->write_to(writing);
                recorder_->close();
            } catch (const std::exception& problem) {
                refuse(problem.what());
            }
        }
        return "recorded up to step " + std::to_string(services_->clock.step) +
               "; fettle run --replay " + for_shell(writing.string()) + " plays it again";
    }
    if (!writing.empty()) return "the run is being recorded already, in " + writing.string();
    if (!recorder_->complete())
        refuse(recorder_->incomplete() + "; restart() begins the game again");
    try {
        const auto file = free_name(property::player_folder(options_.game, settings_.id),
                                    "recordings", "run", "recording");
        recorder_->write_to(file);
        return "recording in " + file.string() +
               ", from the first step of the run; record(false) ends it";
    } catch (const std::exception& error) {
        refuse(error.what());
    }
    return {};
}

/// Ends the recording, because a replay reads the files as they were at the start of the run.
void Session::end_recording(const std::string& changed) {
    if (!recorder_ || !recorder_->complete()) return;
    const std::filesystem::path file = recorder_->writes_to();
    recorder_->end(changed + " has changed since the run began");
    if (!file.empty())
        note(file.string() + ": the recording ends here: " + changed + " has changed");
}

/// A file that cannot be written further is closed, so that the console shows it.
void Session::check_recording() {
    if (!recorder_ || !options_.record.empty() || recorder_->problem().empty() ||
        recorder_->writes_to().empty())
        return;
    recorder_->close();
    note(recorder_->problem());
}

std::string Session::recording_problem() const {
    return recorder_ ? recorder_->problem() : std::string();
}

bool Session::viewing_past() const {
    const app::Clock& clock = services_->clock;
    // The error belongs to the branch in which it happened, which is another one now.
    const bool elsewhere = loop_->halted() && loop_->timeline().has_branch(run_.failed_branch);
    return elsewhere || clock.step < clock.newest;
}

}  // namespace fettle::program
