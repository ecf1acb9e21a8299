// Clang 14, the one of Debian 12, compiles no std::ranges::subrange of GCC's standard library. The
// fuzzers are built with it, and `./check` without --full would not notice.

#include <regex>
#include <string>

#include "catch.h"
#include "source_tree.h"

using namespace fettle::architecture;

namespace {

/// Lines that use a function which returns such a range, as "path:line" each.
std::string subranges_in(const SourceTree& tree) {
    static const std::regex use(
        R"(^[^/]*std::(views::|ranges::(subrange|views::|(unique|remove|remove_if|partition|)"
        R"(stable_partition|rotate|search|search_n|find_end|equal_range)\()).*)");
    std::string found;
    for (const auto& [path, file] : tree.files())
        for (std::size_t i = 0; file.is_cpp() && i < file.lines.size(); ++i)
            if (file.lines[i].find("std::") != std::string::npos &&
                std::regex_match(file.lines[i], use))
                found += path + ":" + std::to_string(i + 1) + "\n";
    return found;
}

}  // namespace

TEST_CASE("a range of the standard library that clang cannot compile is reported") {
    const SourceTree tree({{"console/a.cpp", "sort(all);\nauto end = std::ranges::unique(all);\n"},
                           {"console/b.cpp", "// std::ranges::search() is not there\n"},
                           {"console/c.cpp", "std::ranges::sort(all);\n"}});
    CHECK(subranges_in(tree) == "console/a.cpp:2\n");
}

TEST_CASE("the sources use no range that clang cannot compile") {
    CHECK(subranges_in(SourceTree::read(FETTLE_SOURCE_DIR)) == "");
}
