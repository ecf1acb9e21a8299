#include "source_tree.h"

#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace fettle::architecture {
namespace {

constexpr std::array code_folders = {"vector", "framework", "physics", "bindings", "console",
                                     "fettle", "tests",     "bench",   "scripts",  "examples"};

bool has_suffix(const std::string& path, std::string_view suffix) {
    return path.ends_with(suffix);
}

bool is_read(const std::string& path) {
    return has_suffix(path, ".h") || has_suffix(path, ".cpp") || has_suffix(path, ".c") ||
           has_suffix(path, ".lua") || has_suffix(path, "CMakeLists.txt");
}

}  // namespace

bool SourceFile::is_header() const {
    return has_suffix(path, ".h");
}

bool SourceFile::is_cpp() const {
    return is_header() || has_suffix(path, ".cpp");
}

bool SourceFile::is_cmake() const {
    return has_suffix(path, "CMakeLists.txt");
}

bool SourceFile::is_public_header() const {
    // Each interface in C is also one header that is included without a folder.
    return is_header() && (path.find("/include/fettle/") != std::string::npos ||
                           path.ends_with("/include/fettle_physics.h") ||
                           path.ends_with("/include/fettle_host.h"));
}

std::vector<Include> SourceFile::includes() const {
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Include> found;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].find("include") == std::string::npos) continue;
        std::smatch match;
        if (std::regex_match(lines[i], match, pattern)) {
            found.push_back({match[2].str(), match[1].str() == "\"", static_cast<int>(i) + 1});
        }
    }
    return found;
}

SourceTree::SourceTree(const std::map<std::string, std::string>& texts) {
    for (const auto& [path, text] : texts) add(path, text);
}

SourceTree SourceTree::read(const std::filesystem::path& root) {
    SourceTree tree;
    for (const char* folder : code_folders) {
        if (!std::filesystem::is_directory(root / folder)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            const std::string path = entry.path().lexically_relative(root).generic_string();
            if (!entry.is_regular_file() || !is_read(path)) continue;
            std::ifstream stream(entry.path(), std::ios::binary);
            if (!stream) throw std::runtime_error("cannot read " + entry.path().string());
            tree.add(path, {std::istreambuf_iterator<char>(stream), {}});
        }
    }
    return tree;
}

void SourceTree::add(const std::string& path, const std::string& text) {
    SourceFile file{path, {}};
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    files_.emplace(path, std::move(file));
}

std::string SourceTree::resolve(const SourceFile& from, const Include& include) const {
    namespace fs = std::filesystem;
    std::vector<fs::path> roots;
    // The included file is in the folder of the including file or in a folder above, because the
    // folder of a part is on its include path.
    const fs::path beside = fs::path(from.path).parent_path();
    for (fs::path folder = beside; !folder.empty(); folder = folder.parent_path()) {
        roots.push_back(folder);
    }
    roots.insert(roots.end(),
                 {"vector/include", "framework/include", "physics/include", "bindings/c/include",
                  "bindings/host/include", "console/include", "tests/include"});
    for (const fs::path& root : roots) {
        const std::string path = (root / include.name).lexically_normal().generic_string();
        if (contains(path)) return path;
    }
    return {};
}

}  // namespace fettle::architecture
