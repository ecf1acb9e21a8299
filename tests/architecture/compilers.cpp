#include <algorithm>
#include <regex>

#include "rules.h"

namespace fettle::architecture {

Violations words_of_one_compiler(const SourceTree& tree) {
    static const std::regex word(R"(__attribute__|__builtin_|_Pragma|\[\[gnu::)");
    static const std::regex condition(R"(^\s*#\s*(if|ifdef)\b.*__GNUC__.*)");
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!file.is_public_header()) continue;
        const bool asks = std::ranges::any_of(
            file.lines, [](const std::string& line) { return std::regex_match(line, condition); });
        for (std::size_t i = 0; !asks && i < file.lines.size(); ++i) {
            if (std::regex_search(file.lines[i], word))
                found.push_back(path + ":" + std::to_string(i + 1) +
                                ": only GCC and clang know this, and nothing asks for __GNUC__");
        }
    }
    return found;
}

Violations names_of_one_catch(const SourceTree& tree) {
    static const std::regex name(R"(Catch::(Detail::Approx|(Matchers::)?Contains\b))");
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!path.starts_with("tests/") || path == "tests/include/catch.h") continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            if (std::regex_search(file.lines[i], name))
                found.push_back(path + ":" + std::to_string(i + 1) +
                                ": only one of Catch2 2 and 3 has this; catch.h has it for both");
    }
    return found;
}

Violations trigonometry_of_the_system(const SourceTree& tree) {
    static const std::regex name(R"(std::(sin|cos|tan|asin|acos|atan2?|exp|log|pow|hypot)\()");
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!path.starts_with("physics/") || path.starts_with("physics/module/") ||
            path == "physics/handles/draw.cpp")
            continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            if (std::regex_search(file.lines[i], name))
                found.push_back(path + ":" + std::to_string(i + 1) +
                                ": its results differ between systems; see trigonometry.h");
    }
    return found;
}

}  // namespace fettle::architecture
