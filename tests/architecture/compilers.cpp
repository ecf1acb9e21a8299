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

}  // namespace fettle::architecture
