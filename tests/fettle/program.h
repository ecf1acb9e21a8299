#pragma once
// The program as a command, run on games in a folder of their own.

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace program_test {

struct Outcome {
    int status = -1;
    std::string out, err;
};

/// A folder for games that goes with the test. What the games' user owns goes into it, too.
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

/// Runs `fettle ARGUMENTS` without a display. `before`: a command of the shell to begin with.
Outcome fettle(const Folder& folder, const std::vector<std::string>& arguments,
               const std::string& before = {});

bool contains(const std::string& text, const std::string& part);

}  // namespace program_test
