#pragma once
// Modules of the tests, and a folder of its own for each test.

#include <filesystem>
#include <string>

#include <fettle/module/plugin.h>
#include <fettle/property/path.h>

#include "temporary_folder.h"

namespace fettle::module::testing {

/// The module built in that way.
std::filesystem::path built(const std::string& name);

/// A copy of a module that a test may write over.
class ModuleFile {
  public:
    explicit ModuleFile(const std::string& name);
    const std::filesystem::path& path() const { return file_; }
    void become(const std::string& name) const;

  private:
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path / "weather.so";
};

/// What loading the module into a tree says; "" when it goes well.
std::string refusal(const std::filesystem::path& file);

}  // namespace fettle::module::testing
