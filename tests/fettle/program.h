#pragma once
// The program `fettle` as a command, run on games in temporary folders.

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace program_test {

struct Outcome {
    int status = -1;
    std::string out, err;
};

/// A folder for games that is removed at the end of the test. The state folder of the user is
/// inside.
class Folder {
  public:
    Folder();
    std::filesystem::path operator/(const std::string& name) const { return folder_.path / name; }
    std::string write(const std::string& name, const std::string& text) const;
    std::string text(const std::string& name) const;

  private:
    TemporaryFolder folder_;
};

std::string quoted(const std::string& text);

/// Runs `fettle ARGUMENTS` without a display. `before`: a shell command that runs first. `input`:
/// the file that is its standard input.
Outcome fettle(const Folder& folder, const std::vector<std::string>& arguments,
               const std::string& before = {}, const std::string& input = "/dev/null");

/// Runs this script as a game for `steps` steps. `more`: further arguments.
Outcome run_script(const Folder& folder, const std::string& script, int steps,
                   const std::vector<std::string>& more = {});

bool contains(const std::string& text, const std::string& part);
/// Errors and warnings of a run, without the notes about what does nothing in the game.
std::string without_notes(const std::string& err);

}  // namespace program_test
