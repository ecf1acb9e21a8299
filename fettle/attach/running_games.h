#pragma once
// Where terminals find the games that listen: for each of them a socket and a file in a folder that
// only this user can enter.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace fettle::program {

struct RunningGame {
    std::filesystem::path file;    // contains the members below; only this user may read it
    std::filesystem::path socket;  // beside it
    std::string token{};           // a terminal must send it first
    std::filesystem::path game{};  // absolute
    pid_t process = 0;
};

/// `fettle` in `$XDG_RUNTIME_DIR`; without that, `fettle-UID` in the folder for temporary files. It
/// is made if it is missing. Throws FileError if it cannot be used, or if others can enter it.
std::filesystem::path runtime_folder();

/// Names for a game that begins to listen, with a new token. Nothing is written.
RunningGame named_for(const std::filesystem::path& game);
/// Writes the file. Throws FileError.
void announce(const RunningGame& running);
/// Removes both files.
void withdraw(const RunningGame& running);

/// The games that listen now. The files of games that ended without removing them are removed.
std::vector<RunningGame> running_games();
/// The game with this process number, name or path; "": the only game. Throws FileError if there is
/// no such game, or more than one.
RunningGame running_game(const std::string& wanted);

/// A connected socket; -1 with errno if no program listens there.
int connected_to(const std::filesystem::path& socket);

}  // namespace fettle::program
