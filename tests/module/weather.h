#pragma once
// Test modules, and a temporary folder for each test.

#include <filesystem>
#include <string>

#include <fettle/module/plugin.h>
#include <fettle/property/path.h>

#include "temporary_folder.h"

namespace fettle::module::testing {

/// Path of the module that is built with this name.
std::filesystem::path built(const std::string& name);

/// A copy of a module that a test may overwrite.
class ModuleFile {
  public:
    explicit ModuleFile(const std::string& name);
    const std::filesystem::path& path() const { return file_; }
    void become(const std::string& name) const;

  private:
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path / "weather.so";
};

/// The error of loading the module into a tree; "" if it is loaded.
std::string refusal(const std::filesystem::path& file);

}  // namespace fettle::module::testing
