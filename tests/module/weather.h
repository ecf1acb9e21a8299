#pragma once
// Modules of the tests, and a folder of its own for each test.

#include <filesystem>
#include <string>

#include <fettle/module/plugin.h>
#include <fettle/property/path.h>

namespace fettle::module::testing {

/// The module built in that way.
std::filesystem::path built(const std::string& name);

/// A copy of a module that a test may write over.
class ModuleFile {
  public:
    explicit ModuleFile(const std::string& name);
    ModuleFile(const ModuleFile&) = delete;
    ModuleFile& operator=(const ModuleFile&) = delete;
    ~ModuleFile();
    const std::filesystem::path& path() const { return file_; }
    void become(const std::string& name) const;

  private:
    std::filesystem::path folder_, file_;
};

/// What loading the module into a tree says; "" when it goes well.
std::string refusal(const std::filesystem::path& file);

}  // namespace fettle::module::testing
