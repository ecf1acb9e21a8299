#pragma once
// A folder for a game, and one for what its user owns, that go with the test.

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
