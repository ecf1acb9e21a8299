// What a public header only declares is exported too if it is between the marks of the header,
// together with all functions of its class. `./check` builds no shared libraries; only
// `./check --full` looks at what they export.

#include <regex>
#include <set>
#include <string>

#include "catch.h"
#include "rules.h"

namespace fettle::architecture {
namespace {

/// Names of the classes that a header defines, those that other code defines, and those that a
/// public header marks as private.
struct Classes {
    std::set<std::string> in_public, in_private, marked;
};

bool is_of_library(const std::string& path) {
    for (const char* folder : {"bindings/", "console/", "framework/", "physics/"})
        if (path.starts_with(folder)) return true;
    return false;
}

Classes classes_of(const SourceTree& tree) {
    static const std::regex definition(
        R"(^ *(class|struct) (FETTLE_\w+ )?(\w+::)*(\w+)( final)?( :.*)?( \{.*)?$)");
    static const std::regex mark(R"(^ *(class|struct) FETTLE_\w+_PRIVATE (\w+)\b.*)");
    Classes classes;
    for (const auto& [path, file] : tree.files()) {
        if (!is_of_library(path) || !file.is_cpp()) continue;
        for (const std::string& line : file.lines) {
            if (line.find("class ") == std::string::npos &&
                line.find("struct ") == std::string::npos)
                continue;
            std::smatch word;
            if (std::regex_match(line, word, definition))
                (file.is_public_header() ? classes.in_public : classes.in_private).insert(word[4]);
            if (std::regex_match(line, word, mark)) classes.marked.insert(word[2]);
        }
    }
    return classes;
}

}  // namespace

Violations exported_by_accident(const SourceTree& tree) {
    static const std::regex declaration(R"(^ *(friend )?(class|struct) (\w+);.*)");
    static const std::regex lambda(R"(^ *std::function<.*> \w+( = |\{)\[.*)");
    const Classes classes = classes_of(tree);
    Violations found;
    for (const auto& [path, file] : tree.files()) {
        if (!is_of_library(path) || !file.is_public_header()) continue;
        bool exported = false;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            if (line.starts_with("FETTLE_")) exported = line.ends_with("_BEGIN");
            const std::string where = path + ":" + std::to_string(i + 1) + ": ";
            std::smatch word;
            if (exported && std::regex_match(line, lambda))
                found.push_back(where + "the type of this lambda is exported; a function is not");
            if (!exported || !std::regex_match(line, word, declaration)) continue;
            const bool is_friend = word[1].matched;
            const std::string name = word[3];
            if (classes.in_private.contains(name) && !classes.in_public.contains(name) &&
                !(is_friend && classes.marked.contains(name)))
                found.push_back(where + name + " is exported, but no public header defines it: " +
                                "mark it with FETTLE_<PART>_PRIVATE");
        }
    }
    return found;
}

}  // namespace fettle::architecture

using namespace fettle::architecture;

TEST_CASE("a class of the library that a public header exports by its declaration is reported") {
    const auto verdict = [](const std::string& code, const std::string& definition) {
        return exported_by_accident(SourceTree({{"framework/include/fettle/app/window.h",
                                                 "FETTLE_APP_BEGIN\n" + code + "FETTLE_APP_END\n"},
                                                {"framework/app/window/screen.h", definition}}));
    };
    const std::string screen = "class Screen {\n};\n";
    CHECK(verdict("class Screen;\n", screen).size() == 1);
    CHECK(
        verdict("class Window {\n    struct State;\n};\n", "struct Window::State {\n};\n").size() ==
        1);
    CHECK(verdict("class Window {\n    friend class Screen;\n};\n", screen).size() == 1);
    CHECK(
        verdict("class FETTLE_APP_PRIVATE Screen;\nclass Window {\n    friend class Screen;\n};\n",
                screen)
            .empty());
    CHECK(verdict("class Screen;\nclass Screen {\n};\n", "").empty());
    CHECK(verdict("class Tree;\n", "class Tree;\n").empty());
    CHECK(verdict("", "class Screen;\n" + screen).empty());
}

TEST_CASE("a lambda that a public header exports is reported") {
    const auto verdict = [](const std::string& code) {
        return exported_by_accident(SourceTree({{"framework/include/fettle/app/window.h", code}}));
    };
    CHECK(verdict("FETTLE_APP_BEGIN\n    std::function<void()> draw = [] {};\n").size() == 1);
    CHECK(verdict("FETTLE_APP_BEGIN\n    std::function<void()> draw{[] {}};\n").size() == 1);
    CHECK(verdict("FETTLE_APP_BEGIN\n    std::function<void()> draw = nothing;\n").empty());
    CHECK(verdict("    std::function<void()> draw = [] {};\n").empty());
}

TEST_CASE("public headers export only what they define") {
    std::string all;
    for (const std::string& violation : exported_by_accident(SourceTree::read(FETTLE_SOURCE_DIR)))
        all += violation + "\n";
    CHECK(all == "");
}
