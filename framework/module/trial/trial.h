#pragma once
// Tries a module out in another process, so that a crash does no harm to the program.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tree_description.h"

namespace fettle::module {

/// How far a module is tried out: it is opened; or it is also attached, tested and stepped; or it
/// takes the place of an older one in a tree, and is tested and stepped.
enum class TrialKind : std::uint8_t { open, attach, reload };

/// All data that the other process needs.
struct Trial {
    TrialKind kind = TrialKind::open;
    std::filesystem::path file;  ///< of the module, for messages
    std::filesystem::path copy;  ///< the file that is loaded
    std::string name;            ///< of the module that is reloaded
    TreeDescription tree{};      ///< unless it is only opened
};

/// Tries the module out in the program of `trial_program_places`. Returns "" on success. Otherwise
/// returns what went wrong: the module's reason, "crashed (Segmentation fault) in its own test",
/// "ended the process with status 0 while it was opened", or that it took longer than ten seconds.
/// Throws LoadError if there is no such program. `libraries`, if given, gets the files of the
/// shared libraries that the process had at its end, the program's own included.
std::string run_trial(const Trial& trial, std::vector<std::filesystem::path>* libraries = nullptr);

std::vector<std::byte> to_bytes(const Trial& trial);
/// Throws property::Error, also if another version of the library has written the bytes.
Trial trial_from(std::span<const std::byte> bytes);

/// The file descriptor over which a trial is read and its result is written.
inline constexpr int trial_stream = 3;
/// The limit for a trial in seconds.
inline constexpr int trial_seconds = 10;
/// The last line of a trial that has succeeded. Status 0 alone is not a proof, since a module may
/// call `exit(0)`. Before it there is a line for each phase, "@in its own test", and one for each
/// shared library, "+/usr/lib/libz.so.1"; a failure ends with "!" and a message.
inline constexpr std::string_view success_line = "=\n";

}  // namespace fettle::module
