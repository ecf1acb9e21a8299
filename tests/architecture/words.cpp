// One spelling of each word in comments, messages and documents: that of American English.

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "catch.h"

namespace fs = std::filesystem;

namespace {

/// In two parts, so that this file passes its own test.
const std::array<std::string, 4> other_spellings = {
    std::string("met") + "re", std::string("cent") + "re", std::string("neighb") + "our",
    std::string("behavi") + "our"};

const std::set<std::string> texts = {".h",  ".c",   ".cpp", ".lua", ".md",   ".py",  ".js",
                                     ".ts", ".mjs", ".sh",  ".txt", ".json", ".html"};

/// The first of these spellings in a text; "" if there is none.
std::string other_spelling_in(std::string text) {
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    for (const std::string& word : other_spellings)
        if (text.find(word) != std::string::npos) return word;
    return "";
}

}  // namespace

TEST_CASE("a spelling that the project does not use is found in any case and in any word") {
    CHECK(other_spelling_in("Two Kilo" + other_spellings[0] + "s") == other_spellings[0]);
    CHECK(other_spelling_in("two meters, a center, a neighbor") == "");
}

TEST_CASE("each word has one spelling in the whole project") {
    std::string found;
    std::size_t files = 0;
    for (const char* folder : {"assets", "bench", "bindings", "console", "docs", "examples",
                               "fettle", "framework", "physics", "scripts", "tests", "vector"}) {
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(fs::path(FETTLE_SOURCE_DIR) / folder)) {
            const fs::path& path = entry.path();
            if (!entry.is_regular_file() || !texts.contains(path.extension().string())) continue;
            if (path.string().find(".fettle/") != std::string::npos) continue;  // edits of a user
            std::ifstream file(path, std::ios::binary);
            const std::string word =
                other_spelling_in(std::string(std::istreambuf_iterator<char>(file), {}));
            if (!word.empty()) found += path.string() + ": " + word + "\n";
            ++files;
        }
    }
    CHECK(files > 1000);
    CHECK(found == "");
}
