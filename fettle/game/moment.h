#pragma once
// A moment of a game in one file: the game as an archive, with the state to begin from.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/snapshot.h>
#include <fettle/property/storage/tweaks.h>

namespace fettle::program {

struct Moment {
    property::Snapshot state;
    std::int64_t step = 0;
    std::string fettle;               // version that wrote it
    std::vector<std::string> tweaks;  // of the run, in words, one line each
};

/// Where the moment `name` of a game is written: NAME.fettle in the folder `moments` of the
/// player's folder. Throws Error(bad_name) unless the name has 1 to 64 letters, digits, dashes and
/// underscores, and Error(rejected) if there is no such folder.
std::filesystem::path moment_file(const std::filesystem::path& player_folder,
                                  const std::string& name);

/// Writes the game `game` with the moment into `file`. `recording`: the recording of the run so
/// far; "": there is none. Throws FileError.
void write_moment(const std::filesystem::path& file, const std::filesystem::path& game,
                  const Moment& moment, const std::string& recording);

/// The moment in the archive that contains the game `game`; nothing if the game is in no archive,
/// or in one without a moment. Throws FileError if it is damaged or of another version.
std::optional<Moment> moment_of(const std::filesystem::path& game);

/// "world.ball.mass: 2 kg → 5 kg, step 412"
std::vector<std::string> tweak_lines(const std::vector<property::Tweak>& tweaks);

}  // namespace fettle::program
