// Messages that quote what a caller gave.

#include <fettle/property/error.h>

#include "catch.h"

namespace message_text_test {

using namespace fettle::property;

TEST_CASE("a message quotes a long text only in part and keeps what it says about it") {
    const std::string long_name(3000, 'a');
    const std::string shown = std::string(200, 'a') + "…";
    CHECK(message_text("world has no \"" + long_name + "\" (did you mean \"ball\"?)") ==
          "world has no \"" + std::string(199, 'a') + "…\" (did you mean \"ball\"?)");
    CHECK(message_text("world." + long_name + ": no such name") ==
          "world." + std::string(194, 'a') + "…: no such name");
    std::string blanks;
    for (int i = 0; i < 1000; ++i) blanks += "a b";
    CHECK(Error(ErrorKind::bad_name, "\"" + blanks + "\" is no name").what() ==
          "\"" + blanks.substr(0, 199) + "…\" is no name");
    CHECK(message_text(long_name) == shown);
    CHECK(message_text("\"" + long_name).size() < 210);
}

TEST_CASE("a message keeps other texts as they are") {
    std::string sentences;
    for (int i = 0; i < 100; ++i) sentences += "expected \"static\" or \"dynamic\",\n";
    CHECK(message_text(sentences) == sentences);
    CHECK(message_text("").empty());
    CHECK(message_text("\"") == "\"");
    const std::string path = "/home/" + std::string(250, 'x') + "/main.lua";
    CHECK(message_text(path + ": no such file") == path + ": no such file");
    CHECK(message_text(std::string("a\0b", 3)) == "a\\0b");
    // A letter is kept as a whole or left out.
    std::string letters;
    for (int i = 0; i < 400; ++i) letters += "é";
    CHECK(message_text("x" + letters) == "x" + letters.substr(0, 198) + "…");
}

}  // namespace message_text_test
