#include "comma_locale.h"
#include "stage.h"

namespace locale_test {

// Scripts in a program whose locale has a comma.

using namespace stage;

TEST_CASE("scripts write numbers with a point in every locale of the program") {
    const CommaLocale comma;
    if (!comma.there()) return;
    Stage s;
    const std::string numbers =
        "1.5 .. '|' .. ('%.2f %g'):format(0.5, 2.5) .. '|' .. tostring(3.5) .. '|' .. "
        "table.concat({ 4.5 }) .. '|' .. tostring(tonumber('5.5'))";
    const std::string expected = "1.5|0.50 2.5|3.5|4.5|5.5";
    CHECK(s.prints("print(" + numbers + ")") == expected);
    CHECK(s.prints("coroutine.wrap(function() print(" + numbers + ") end)()") == expected);
    CHECK(s.runtime->evaluate(numbers).lines == std::vector<std::string>{"\"" + expected + "\""});
    s.run("game.number = 1.5 game.text = formula(function() return 'x' .. game.number end)");
    CHECK(s.prints("print(game.text)") == "x1.5");
    CHECK(s.fails("error('a' .. 1.5)").ends_with("a1.5"));
    // Also after errors, the program has its own locale again.
    CHECK(std::localeconv()->decimal_point == std::string(","));
}

}  // namespace locale_test
