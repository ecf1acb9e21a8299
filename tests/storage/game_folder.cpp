#include "game_folder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace scene_test {

namespace fs = std::filesystem;

GameFolder::GameFolder() {
    path_ = fs::canonical(folder_.path) / "game";
    user_ = fs::canonical(folder_.path) / "user";
    fs::create_directories(path_);
    fs::create_directories(user_);
    setenv("XDG_DATA_HOME", user_.c_str(), 1);
    write("main.lua", "");
    // Tests switch to another user to test permissions.
    for (const fs::path& folder : {path_.parent_path(), path_, user_})
        fs::permissions(folder, fs::perms::all);
}

GameFolder::~GameFolder() {
    unsetenv("XDG_DATA_HOME");
    std::error_code ignored;
    fs::permissions(path_, fs::perms::all, ignored);
}

fs::path GameFolder::write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
}

std::string GameFolder::text(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace scene_test
