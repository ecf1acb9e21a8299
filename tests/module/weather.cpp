#include "weather.h"

namespace fettle::module::testing {

namespace fs = std::filesystem;

fs::path built(const std::string& name) {
    return fs::path(FETTLE_TEST_MODULES) / (name + ".so");
}

ModuleFile::ModuleFile(const std::string& name) {
    become(name);
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
