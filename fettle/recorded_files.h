#pragma once
// The files of a recorded run: what a recording calls them, and whether they are still the same.

#include <filesystem>
#include <string>
#include <vector>

#include <fettle/app/recording.h>
#include <fettle/property/storage/game_files.h>

namespace fettle::program {

/// As a recording holds it: relative to the game's folder, or to what belongs to Fettle.
app::RunFile recorded(const property::GameFiles::Finding& finding,
                      const std::filesystem::path& game);

/// In words, what is no longer as it was: "ball.json differs". What the run itself has overwritten
/// since is in the recording, so it is no difference.
std::vector<std::string> changed_since(const app::Recording& recording,
                                       const std::filesystem::path& game);

/// Throws FileError when another file than a recording is there: it would be lost.
void require_recording_or_nothing(const std::filesystem::path& file);

/// The files of the run as they were when it was recorded; nothing is written.
void go_back_to(const app::Recording& recording, const std::filesystem::path& game,
                property::GameFiles& files);

}  // namespace fettle::program
