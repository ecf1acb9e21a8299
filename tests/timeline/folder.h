#pragma once
// A folder that goes with the test.

#include <filesystem>
#include <random>
#include <string>

namespace fettle::app {

class Folder {
  public:
    Folder()
        : path_(std::filesystem::temp_directory_path() /
                ("fettle-timeline-" + std::to_string(std::random_device{}()))) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace fettle::app
