#pragma once
// Temporary folders for a game and for the files of its user, removed at the end of the test.

#include <filesystem>
#include <string>

#include "temporary_folder.h"

namespace scene_test {

class GameFolder {
  public:
    GameFolder();
    ~GameFolder();
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& user() const { return user_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    std::string text(const std::string& name) const;

  private:
    TemporaryFolder folder_;
    std::filesystem::path path_, user_;
};

}  // namespace scene_test
