#include "weather.h"

#include <cstdlib>
#include <stdexcept>

namespace fettle::module::testing {

namespace fs = std::filesystem;

fs::path built(const std::string& name) {
    return fs::path(FETTLE_TEST_MODULES) / (name + ".so");
}

ModuleFile::ModuleFile(const std::string& name) {
    std::string folder = (fs::temp_directory_path() / "fettle module XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no folder for a test");
    folder_ = folder;
    file_ = folder_ / "weather.so";
    become(name);
}

ModuleFile::~ModuleFile() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void ModuleFile::become(const std::string& name) const {
    fs::copy_file(built(name), file_, fs::copy_options::overwrite_existing);
}

std::string refusal(const fs::path& file) {
    Plugins plugins;
    property::Tree tree;
    try {
        plugins.open(file).attach(tree);
        return "";
    } catch (const LoadError& error) {
        return error.what();
    }
}

}  // namespace fettle::module::testing
