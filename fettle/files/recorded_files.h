#pragma once
// The files of a recorded run: their names in the recording, and whether they have changed since.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fettle/app/recording.h>
#include <fettle/property/storage/game_files.h>

namespace fettle::program {

/// Makes the entry of a recording. The name is relative to the game's folder or to Fettle's assets;
/// any other file has its whole path.
app::RunFile recorded(const property::GameFiles::FileState& state,
                      const std::filesystem::path& game);

/// Files in the player's folder that a run reads at its start and writes later.
enum class KeptFile : std::uint8_t { store, preferences };
std::string name_of(KeptFile which);

/// Makes the entry of a recording with the text of that file at the start of the run; and reads the
/// text from a recording.
app::RunFile recorded_text(KeptFile which, const std::string& text);
std::string recorded_text(KeptFile which, const app::Recording& recording);

/// The differences from the recorded files, in words: "ball.json differs". Files that the run
/// itself has overwritten are in the recording, so they are not compared.
std::vector<std::string> changed_since(const app::Recording& recording,
                                       const std::filesystem::path& game);

/// Throws FileError if the file exists and is not a recording: recording would overwrite it.
void require_recording_or_nothing(const std::filesystem::path& file);

/// "run-2.recording" for "run.recording", or the next number that no file has.
std::filesystem::path next_recording(const std::filesystem::path& file);

/// Gives `files` the recorded content of the files that the run has overwritten. Later writes stay
/// in memory; nothing is written to disk.
void use_recorded_content(const app::Recording& recording, const std::filesystem::path& game,
                          property::GameFiles& files);

}  // namespace fettle::program
