// A source includes what declares the names that it uses. Several sources are compiled together, so
// GCC does not notice a missing include: another source of the group has it. The builds in which
// each source is compiled alone, with clang and for the fuzzers, run only in `./check --full`.
// Looked at are some names of the standard library, and functions of the project with "_" in their
// names.

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "rules.h"

namespace fettle::architecture {
namespace {

/// Names of the standard library, and their headers.
const std::map<std::string, std::string> headers_of_names = {
    {"array", "array"},
    {"atomic", "atomic"},
    {"deque", "deque"},
    {"function", "functional"},
    {"ifstream", "fstream"},
    {"invalid_argument", "stdexcept"},
    {"istringstream", "sstream"},
    {"logic_error", "stdexcept"},
    {"map", "map"},
    {"memcpy", "cstring"},
    {"mutex", "mutex"},
    {"numeric_limits", "limits"},
    {"ofstream", "fstream"},
    {"optional", "optional"},
    {"ostringstream", "sstream"},
    {"regex", "regex"},
    {"runtime_error", "stdexcept"},
    {"set", "set"},
    {"shared_ptr", "memory"},
    {"snprintf", "cstdio"},
    {"span", "span"},
    {"string_view", "string_view"},
    {"thread", "thread"},
    {"tuple", "tuple"},
    {"unique_ptr", "memory"},
    {"unordered_map", "unordered_map"},
    {"unordered_set", "unordered_set"},
    {"variant", "variant"},
    {"vector", "vector"},
};

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The words and signs of a file, without comments and texts in quotes.
std::vector<std::string> words_of(const SourceFile& file) {
    std::vector<std::string> words;
    for (const std::string& line : file.lines) {
        for (std::size_t i = 0; i < line.size();) {
            const std::size_t begin = i++;
            if (line.compare(begin, 2, "//") == 0) break;
            if (is_letter(line[begin])) {
                while (i < line.size() && is_letter(line[i])) ++i;
            } else if (line[begin] == '"') {
                while (i < line.size() && line[i] != '"') i += line[i] == '\\' ? 2 : 1;
                ++i;
            }
            if (line[begin] != ' ' && line[begin] != '"')
                words.push_back(line.substr(begin, i - begin));
        }
    }
    return words;
}

bool is_function_name(const std::string& word) {
    return word.find('_') != std::string::npos && std::ranges::all_of(word, [](char c) {
               return std::islower(static_cast<unsigned char>(c)) != 0 || c == '_' ||
                      std::isdigit(static_cast<unsigned char>(c)) != 0;
           });
}

/// True for the name of a namespace of the project.
bool is_space(const std::string& word) {
    return std::islower(static_cast<unsigned char>(word[0])) != 0 && word != "std" &&
           word != "filesystem" && word != "fs";
}

bool is_keyword(std::string_view word) {
    static constexpr std::array<std::string_view, 7> keywords = {
        "return", "else", "throw", "case", "do", "co_return", "co_await"};
    return std::ranges::find(keywords, word) != keywords.end();
}

/// The sources of a tree by their words, and what each of them includes.
class Names {
  public:
    explicit Names(const SourceTree& tree) : tree_(tree) {
        for (const auto& [path, file] : tree.files()) {
            if (!file.is_cpp()) continue;
            words_[path] = words_of(file);
            known_[path] = {words_[path].begin(), words_[path].end()};
            by_name_[path.substr(path.rfind('/') + 1)].push_back(path);
            if (file.is_header()) note_functions(path);
        }
        for (const auto& [path, file] : tree.files())
            if (file.is_cpp())
                for (const Include& include : file.includes()) note_include(file, include);
    }

    /// What the source uses without including it.
    Violations missing_in(const std::string& path) const {
        std::set<std::string> files = {path};
        add_includes(path, files);
        Violations found;
        std::set<std::string> seen;
        const std::vector<std::string>& words = words_.at(path);
        for (std::size_t i = 1; i + 3 < words.size(); ++i) {
            if (words[i] == "std" && words[i + 1] == ":" && words[i - 1] != ":") {
                const auto header = headers_of_names.find(words[i + 3]);
                if (header == headers_of_names.end() || !seen.insert(header->first).second)
                    continue;
                if (!is_any_included(files, header->second))
                    found.push_back(path + ": uses std::" + header->first + " without <" +
                                    header->second + ">");
            } else if (words[i + 1] == "(" && is_used(words, i)) {
                const auto declared = functions_.find(words[i]);
                if (declared == functions_.end() || !seen.insert(words[i]).second) continue;
                const bool known = std::ranges::any_of(files, [&](const std::string& file) {
                    return file != path && known_.at(file).contains(words[i]);
                });
                if (!known && !is_declared_in(words, words[i]))
                    found.push_back(path + ": calls " + words[i] + " without " + declared->second);
            }
        }
        return found;
    }

  private:
    /// Notes the functions that a header declares outside of classes: these lines begin at the
    /// margin.
    void note_functions(const std::string& path) {
        for (const std::string& line : tree_.files().at(path).lines) {
            const std::size_t bracket = line.find('(');
            if (bracket == std::string::npos || !is_letter(line[0])) continue;
            std::size_t begin = bracket;
            while (begin > 0 && is_letter(line[begin - 1])) --begin;
            const std::string name = line.substr(begin, bracket - begin);
            if (begin > 0 && is_function_name(name)) functions_.emplace(name, path);
        }
    }

    void note_include(const SourceFile& file, const Include& include) {
        if (const std::string path = tree_.resolve(file, include); !path.empty()) {
            includes_[file.path].insert(path);
            return;
        }
        system_[file.path].insert(include.name);
        // A test may include private headers of its part.
        const auto same = by_name_.find(include.name.substr(include.name.rfind('/') + 1));
        if (same == by_name_.end()) return;
        for (const std::string& path : same->second)
            if (path.ends_with("/" + include.name)) includes_[file.path].insert(path);
    }

    void add_includes(const std::string& path, std::set<std::string>& files) const {
        const auto own = includes_.find(path);
        if (own == includes_.end()) return;
        for (const std::string& each : own->second)
            if (files.insert(each).second) add_includes(each, files);
    }

    bool is_any_included(const std::set<std::string>& files, const std::string& header) const {
        return std::ranges::any_of(files, [&](const std::string& file) {
            const auto own = system_.find(file);
            return own != system_.end() && own->second.contains(header);
        });
    }

    /// True for the name of a function that is neither a member nor declared at this place.
    static bool is_used(const std::vector<std::string>& words, std::size_t i) {
        if (!is_function_name(words[i])) return false;
        const std::string& before = words[i - 1];
        if (before == ":") return i >= 3 && is_space(words[i - 3]);
        if (before == "." || before == ">" || before == "*" || before == "&") return false;
        return !is_letter(before[0]) || is_keyword(before);
    }

    /// True if the source has a declaration or a variable of that name.
    static bool is_declared_in(const std::vector<std::string>& words, const std::string& name) {
        for (std::size_t i = 1; i + 1 < words.size(); ++i) {
            if (words[i] != name) continue;
            const std::string& before = words[i - 1];
            if (words[i + 1] == "=" || before == "define") return true;
            if (before == ">" || before == "*" || before == "&") return true;
            if (before == ":" && i >= 3 && !is_space(words[i - 3])) return true;
            if (is_letter(before[0]) && !is_keyword(before)) return true;
        }
        return false;
    }

    const SourceTree& tree_;
    std::map<std::string, std::vector<std::string>> words_;
    std::map<std::string, std::set<std::string>> known_;
    std::map<std::string, std::vector<std::string>> by_name_;
    std::map<std::string, std::set<std::string>> includes_, system_;
    std::map<std::string, std::string> functions_;  // by name: a header that declares it
};

/// All of these, one a line.
std::string missing_includes(const SourceTree& tree) {
    const Names names(tree);
    std::string found;
    for (const auto& [path, file] : tree.files()) {
        if (!path.ends_with(".cpp")) continue;
        for (const std::string& each : names.missing_in(path)) found += each + "\n";
    }
    return found;
}

}  // namespace

TEST_CASE("a name that a source uses without its header is reported") {
    const std::map<std::string, std::string> headers = {
        {"physics/geometry/cut.h", "#include <vector>\nint first_cut(int x);\n"},
        {"physics/geometry/hull.h", "#include <geometry/cut.h>\n"}};
    const auto missing = [&](const std::string& text) {
        std::map<std::string, std::string> texts = headers;
        texts["physics/world/world.cpp"] = text;
        return missing_includes(SourceTree(texts));
    };
    const std::string use = "int a() {\n    std::vector<int> b;\n    return first_cut(1);\n}\n";
    CHECK(missing(use) ==
          "physics/world/world.cpp: uses std::vector without <vector>\n"
          "physics/world/world.cpp: calls first_cut without physics/geometry/cut.h\n");
    CHECK(missing("int a() {\n    return physics::first_cut(1);\n}\n") != "");
    CHECK(missing("#include <geometry/hull.h>\n" + use) == "");
    CHECK(missing("#include <vector>\nint first_cut(int x);\n" + use) == "");
    CHECK(missing("int a = b.first_cut(1);  // first_cut(1), std::map\n") == "");
}

TEST_CASE("sources include what declares the names that they use") {
    CHECK(missing_includes(SourceTree::read(FETTLE_SOURCE_DIR)) == "");
}

}  // namespace fettle::architecture
