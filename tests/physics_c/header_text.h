#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// The headers of the physics library and of its interface in C, read as text. The tests run in the
// folder of the project.

namespace header_text {

inline std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

inline std::string of_physics(const std::string& file) {
    return std::regex_replace(text_of("physics/include/fettle/physics/" + file),
                              std::regex("//[^\n]*"), "");
}

/// Names of all headers of the physics library.
inline std::vector<std::string> files_of_physics() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator("physics/include/fettle/physics"))
        files.push_back(entry.path().filename().string());
    std::sort(files.begin(), files.end());
    return files;
}

/// All headers in C, in the order of fettle_physics.h, without comments and lines with #.
inline const std::string& in_c() {
    static const std::string all = [] {
        std::string declarations;
        const std::string umbrella = text_of("bindings/c/include/fettle_physics.h");
        const std::regex include("#include <(fettle/physics_c/\\w+\\.h)>");
        for (std::sregex_iterator it(umbrella.begin(), umbrella.end(), include), end; it != end;
             ++it)
            declarations += text_of("bindings/c/include/" + (*it)[1].str());
        std::string code;
        for (size_t at = 0; at < declarations.size();) {
            const size_t comment = declarations.find("/*", at);
            code += declarations.substr(at, comment - at);
            if (comment == std::string::npos) break;
            at = declarations.find("*/", comment) + 2;
        }
        return std::regex_replace(code, std::regex("(^|\n)#[^\n]*"), "\n");
    }();
    return all;
}

/// Names of the functions that the headers in C declare.
inline std::set<std::string> functions_in_c() {
    std::set<std::string> found;
    const std::regex function(
        "\n(?:fettle_code|bool|uint32_t|int32_t|const char\\*) (fettle_\\w+)\\(");
    for (std::sregex_iterator it(in_c().begin(), in_c().end(), function), end; it != end; ++it)
        found.insert((*it)[1].str());
    return found;
}

}  // namespace header_text
