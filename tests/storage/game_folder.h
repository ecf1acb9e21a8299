#pragma once
// A folder for a game, and one for what its user owns, that go with the test.

#include <filesystem>
#include <string>

namespace scene_test {

class GameFolder {
  public:
    GameFolder();
    ~GameFolder();
    GameFolder(const GameFolder&) = delete;
    GameFolder& operator=(const GameFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& user() const { return user_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    std::string text(const std::string& name) const;

  private:
    std::filesystem::path path_, user_;
};

}  // namespace scene_test
