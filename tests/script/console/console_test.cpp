// Console commands: output, echo and completion.

#include <set>

#include <fettle/script/cells.h>

#include "stage.h"

namespace console_test {

using stage::Stage;

TEST_CASE("a bare expression prints its value with the unit of its property") {
    Stage s;
    s.run("world.ball = Body { mass = 2, friction = 0.1 }");
    CHECK(s.console("world.ball.mass") == "2 kg");
    CHECK(s.console("world.ball.friction") == "0.1");
    CHECK(s.console("world.gravity") == "vec(0, -10) m/s²");
    CHECK(s.console("world.gravity.y") == "-10 m/s²");
    CHECK(s.console("world.ball.mass * 3") == "6");
    CHECK(s.console("1 + 1") == "2");
    CHECK(s.console("1, 'two', nil") == "1  \"two\"  nil");
    CHECK(s.console("\"text\"") == "\"text\"");
    CHECK(s.console("{3, 4, x = 5}") == "{3, 4, x = 5}");
    CHECK(s.console("=world.ball.mass") == "2 kg");
    CHECK(s.console("nil") == "nil");
    CHECK(s.console("local x = 3") == "");
    CHECK(s.console("  ") == "");
    const auto e = s.runtime->evaluate("world.ball.mass");
    CHECK(e.ok);
    CHECK(e.result == stage::Value(2.0));
    CHECK(s.console("_ + 1") == "3");
}

TEST_CASE("an assignment prints old and new value once") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    CHECK(s.console("world.ball.mass = 5") == "world.ball.mass: 2 → 5 kg");
    CHECK(s.console("world.ball.mass = 6 world.ball.mass = 7 world.ball.friction = 0.1") ==
          "world.ball.mass: 5 → 7 kg|world.ball.friction: 0.6 → 0.1");
    CHECK(s.console("world.ball.mass = 7") == "world.ball.mass: 7 kg (unchanged)");
    CHECK(s.console("world.ball.position.x = 3") == "world.ball.position: vec(0, 0) → vec(3, 0) m");
    CHECK(s.console("world.ball.lives = 3") == "world.ball.lives: nil → 3");
    CHECK(s.console("world.ball.lives = nil") == "world.ball.lives: 3 → nil");
    CHECK(s.console("world.other = Body { Circle {} }") == "world.other: new Body");
    CHECK(s.console("world.other = nil") == "world.other: deleted");
    CHECK(s.console("x = 3") == "");
    CHECK(s.console("x") == "3");
    CHECK(s.prints("print(x)") == "3");
    s.run("for i = 1, 50 do world:add(Body {}) end");
    CHECK_THAT(s.console("world:all('Body'):set('mass', 9) return"),
               contains("… 31 more (51 changes)"));
    std::string cause;
    s.tree->watch(s.tree->child(s.world, "ball"), "mass",
                  [&](const fettle::property::Change& change) { cause = change.cause.text(); });
    s.console("world.ball.mass = 1");
    s.tree->barrier();
    CHECK_THAT(cause, contains("console"));
    s.run("\nworld.ball.mass = 2");
    s.tree->barrier();
    CHECK(cause == "main.lua:2, step 0");
}

TEST_CASE("an instance prints as a table with units and a set as rows") {
    Stage s;
    s.run("world.ball = Body { mass = 2, Circle {} }");
    const std::string one = s.console("world.ball");
    CHECK_THAT(one, contains("world.ball · Body|"));
    CHECK_THAT(one, contains("mass"));
    CHECK_THAT(one, contains("2 kg"));
    CHECK_THAT(one, contains(".circle  Circle"));
    CHECK(one.find("angle") == std::string::npos);
    CHECK(one.find("  friction") < one.find("  mass"));
    s.run("for i = 1, 100 do world:add(Body { mass = i }) end");
    const std::string all = s.console("world:all('Body')");
    CHECK_THAT(all, contains("path"));
    CHECK_THAT(all, contains("mass [kg]"));
    CHECK_THAT(all, contains("… 71 more (101 instances)"));
    CHECK_THAT(s.console("query('world.body_1*.mass')"), contains("world.body_"));
    CHECK_THAT(s.console("{world.ball, world.body_1}"), contains("class"));
    CHECK_THAT(s.console("game"), contains("game · "));
    CHECK(s.console("world:all('Circle'):set('radius', 1) and nil") != "");
}

TEST_CASE("query accepts conditions without quotes and a class and reports a misspelt name") {
    Stage s;
    s.run("Ball = class('Ball', Body) {} world.ball = Ball { mass = 2, Circle {} }");
    CHECK_THAT(s.console("query mass > 1"), contains("world.ball"));
    CHECK_THAT(s.console("#_"), contains("1"));
    CHECK_THAT(s.console("query radius < 1"), contains("radius [m]"));
    CHECK_THAT(s.console("query radius < 1 and friction > 0"), contains("friction"));
    CHECK_THAT(s.console("query world.*.mass"), contains("world.ball.mass"));
    CHECK_THAT(s.console("query('Body')"), contains("world.ball"));
    CHECK_THAT(s.console("query('world.bal')"),
               contains("no instances: nothing has \"bal\" (did you mean \"ball\"?)"));
    CHECK_THAT(s.console("query('world.*.masss')"), contains("(did you mean \"mass\"?)"));
    CHECK_THAT(s.console("query('Bod')"), contains("(did you mean \"Body\"?)"));
    // Something of this name exists, but not there.
    CHECK(s.console("query('world.ball.ball')") == "no instances");
    CHECK(s.prints("print(#query('world.bal'))") == "0");
    s.run("game.Ball = Object {}");
    CHECK_THAT(s.console("query('Ball')"), contains("Ball"));
    CHECK(s.prints("print(query('Ball')[1].class)") == "Object");
}

TEST_CASE("a long name or value does not move the values of the other properties") {
    Stage s;
    s.run(
        "world.thing = Object {} world.thing.short = 1 world.thing.z = 2 "
        "world.thing['a_name_that_is_far_longer_than_all_of_the_other_ones'] = 3");
    const std::string shown = s.console("world.thing");
    CAPTURE(shown);
    CHECK_THAT(shown, contains("|  short   1|") && contains("|  z       2"));
    CHECK_THAT(shown, contains("a_name_that_is_far_longer_than_all_of_the_other_ones  3|"));
}

TEST_CASE("the console says what the name of a new property may mean") {
    Stage s;
    s.run("world.ball = Body { Circle {} } world.ball.hp = 3 world.plain = Object { health = 1 }");
    CHECK(s.console("world.ball.mas = 4") == "world.ball.mas: nil → 4 (did you mean \"mass\"?)");
    // Each time, not only the first one.
    CHECK(s.console("world.ball.mas = nil world.ball.mas = 5 world.ball.mas = nil") != "");
    CHECK(s.console("world.ball.mas = 4") == "world.ball.mas: nil → 4 (did you mean \"mass\"?)");
    CHECK_THAT(s.console("world.ball.mas = 5"), contains("4 → 5") && !contains("mean"));
    CHECK(s.console("world.ball.pos = vec(1, 2)") ==
          "world.ball.pos: nil → vec(1, 2) (did you mean position?)");
    CHECK(s.console("world.ball.radius = 2") ==
          "world.ball.radius: nil → 2; its Circle has radius");
    CHECK(s.console("world.ball.mas = nil world.ball.mas = nil") != "");
    CHECK_THAT(s.console("world.ball.mas is 1 + 1"), contains("2 (did you mean \"mass\"?)"));
    CHECK(s.console("world.plain.health2 = 3") == "world.plain.health2: nil → 3");
    CHECK_THAT(s.console("world.plain.helth = 2"), contains("(did you mean \"health\"?)"));
    CHECK_THAT(s.console("world.bal = 2"), contains("(did you mean \"ball\"?)"));
    // Names that are meant as they are.
    CHECK(s.console("world.ball.lives = 3") == "world.ball.lives: nil → 3");
    CHECK(s.console("world.ball.hq = 3") == "world.ball.hq: nil → 3");
}

TEST_CASE("the entries that a list leaves out are folded into the line with their number") {
    Stage s;
    s.run("for i = 1, 107 do world['b' .. i] = Body {} end");
    const stage::Evaluation typed = s.runtime->evaluate("world:children()");
    REQUIRE(typed.folded.size() == 1);
    CHECK(typed.lines.size() == 32);
    CHECK(typed.folded[0].line == 31);
    CHECK(typed.lines[31] == "… 77 more (107 instances)");
    CHECK(typed.folded[0].lines.size() == 77);
    CHECK(typed.folded[0].cells.size() == 77);
    CHECK(typed.tables[0].cells.size() == 31);
    CHECK(typed.folded[0].lines.back().starts_with("world.b107"));
    const stage::Evaluation found = s.runtime->evaluate("find Body and mass > 0");
    REQUIRE(found.folded.size() == 1);
    CHECK(found.lines[found.folded[0].line] == "… 57 more (107 found)");
    CHECK(found.folded[0].lines.size() == 57);
    const stage::Evaluation world = s.runtime->evaluate("print('x') return world");
    REQUIRE(world.folded.size() == 1);
    CHECK(world.lines[world.folded[0].line] == "… 77 more (107 children)");
    const stage::Evaluation many = s.runtime->evaluate(
        "local t = {} for i = 1, 2000 do t[i] = 'a long text of entry ' .. i end return t");
    REQUIRE(many.folded.size() == 1);
    CHECK(many.folded[0].lines.size() == 1001);
    CHECK(many.folded[0].lines.back() == "… 970 more");

    // A table with any number of keys is sorted before it is cut.
    const stage::Evaluation keys = s.runtime->evaluate(
        "(function() local t = {} for i = 20000, 1, -1 do t['k' .. i] = i end return t end)()");
    CHECK(keys.lines[0] == "  k1     1");
    CHECK(keys.lines[29] == "  k30    30");
    CHECK(keys.lines[30] == "… 19970 more (20000 entries)");
}

TEST_CASE("folded rows have the columns of the rows above them") {
    Stage s;
    s.run("for i = 1, 107 do world['b' .. i] = Body {} end world.b107.name = 'long_name_107'");
    const stage::Evaluation found = s.runtime->evaluate("find Body and mass > 0");
    REQUIRE(found.folded.size() == 1);
    const std::size_t column = found.lines[0].rfind("Body");
    for (const std::string& line : found.folded[0].lines) CHECK(line.rfind("Body") == column);
}

TEST_CASE("a table of instances says where its cells begin and wide letters move no column") {
    Stage s;
    s.run("world.a = Body { mass = 2 } world['日本語'] = Body {} world['a b'] = Body {}");
    const stage::Evaluation typed = s.runtime->evaluate("print('first') return world:children()");
    REQUIRE(typed.tables.size() == 1);
    CHECK(typed.tables[0].first == 1);
    std::set<std::size_t> columns;
    for (std::size_t row = 0; row < typed.tables[0].cells.size(); ++row) {
        const std::string& line = typed.lines[1 + row];
        const std::size_t begin = typed.tables[0].cells[row].at(1);
        INFO(line);
        CHECK(line.substr(begin - 2, 2) == "  ");
        CHECK(line[begin] != ' ');
        columns.insert(fettle::script::cell_count(std::string_view(line).substr(0, begin)));
    }
    CHECK(columns.size() == 1);
}

TEST_CASE("an error in an expression is at its token and not at its beginning") {
    Stage s;
    const stage::Evaluation typed = s.runtime->evaluate("1 + 2 ) 3");
    REQUIRE(typed.error);
    CHECK_THAT(typed.error->message, contains("near ')'"));
    CHECK(typed.error->column == 7);
}

TEST_CASE("the name of an instance that is below others has its path as a hint") {
    Stage s;
    s.run("world.stage = Object {} world.stage.ball = Body {}");
    CHECK_THAT(s.console("ball.mass = 3"),
               contains("ball: no such name (did you mean \"world.stage.ball\"?)"));
    CHECK_THAT(s.console("ball.mass is 3"), contains("(did you mean \"world.stage.ball\"?)"));
}

TEST_CASE("help of a member's name explains it in the classes that have it") {
    Stage s;
    CHECK_THAT(s.console("help('apply_impulse')"), contains("no such name"));
    s.run("Ball = class('Ball', Object) { lives = 3, doc = { lives = 'Left.' } }");
    CHECK_THAT(s.console("help('lives')"), contains("Ball.lives") && contains("Left."));
    CHECK_THAT(s.console("help lives"), contains("Ball.lives"));
}

TEST_CASE("the console waits for the rest of an incomplete chunk") {
    Stage s;
    CHECK(s.console("for i = 1, 3 do") == "incomplete");
    CHECK(s.console("world.ball = Body {") == "incomplete");
    CHECK(s.console("x = [[a") == "incomplete");
    CHECK(s.console("f(") == "incomplete");
    CHECK(s.console("1 +") == "incomplete");
    CHECK(s.console("for i = 1, 3 do\nprint(i)\nend") == "1|2|3");
    CHECK_THAT(s.console("for for"), contains("error: console:1:"));
}

TEST_CASE("errors in the console show line and caret and the nearest name") {
    Stage s;
    s.run("world.ball = Body {}");
    auto e = s.runtime->evaluate("local x = 1\nprint(world.ball.mas)");
    REQUIRE(e.error);
    CHECK(e.error->message == "console:2: world.ball.mas: no such name (did you mean \"mass\"?)");
    CHECK(e.error->line == 2);
    CHECK(e.error->file == "console");
    CHECK(e.error->context == "console");
    const auto lines = fettle::script::error_lines(*e.error);
    REQUIRE(lines.size() == 3);
    CHECK(lines[1] == "  print(world.ball.mas)");
    CHECK(lines[2] == "                   ^");
    e = s.runtime->evaluate("x = = 2");
    REQUIRE(e.error);
    CHECK(e.error->column == 5);
    e = s.runtime->evaluate("nil + 1");
    REQUIRE(e.error);
    CHECK_THAT(e.error->message, contains("arithmetic on a nil value"));
    CHECK_THAT(s.console("a.b is 3 + 4"), contains("a: no such name"));
    // Output and changes before the error are still printed.
    CHECK(s.runtime->evaluate("print('before') error('x')").lines.size() == 1);
}

TEST_CASE("a function that is typed without brackets prints its help") {
    Stage s;
    CHECK_THAT(s.console("after"), contains("after(") && contains("simulation time"));
    CHECK_THAT(s.console("world.delete"), contains("Deletes it"));
    CHECK_THAT(s.console("help"), contains("random"));
    CHECK(s.console("help") == s.console("help()"));
    CHECK(s.console("?") == s.console("help()"));
    s.run("function own_function() end");
    CHECK_THAT(s.console("own_function"), contains("function"));
}

TEST_CASE("documentation is printed with a question mark or help") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.console("world.ball.mass?"), contains("How hard it is to move."));
    CHECK_THAT(s.console("world.ball.mass?"), contains("kg"));
    CHECK_THAT(s.console("world.ball?"), contains("A thing that moves."));
    CHECK_THAT(s.console("Body?"), contains("properties"));
    CHECK_THAT(s.console("Body?"), contains("contact_begin"));
    CHECK_THAT(s.console("Body.friction?"), contains("default 0.6"));
    CHECK_THAT(s.console("help(world)"), contains("raycast(from, to)"));
    CHECK_THAT(s.console("help(world.raycast)"), contains("The first body a ray meets."));
    CHECK_THAT(s.console("help(world.ball.delete)"), contains("Deletes it"));
    CHECK_THAT(s.console("help(after)"), contains("simulation time"));
    CHECK_THAT(s.console("help('world.ball.mass')"), contains("How hard"));
    CHECK_THAT(s.console("help()"), contains("random"));
    CHECK_THAT(s.console("help(3)"), contains("integer"));
    CHECK_THAT(s.console("find('fric')"), contains("Body.friction"));
    CHECK_THAT(s.console("find('rough')"), contains("Body.friction"));
    CHECK_THAT(s.console("find('zzz')"), contains("nothing has"));
    // The nearest name of a class, of an instance, of a function.
    CHECK(s.console("find Bdoy") == "nothing has \"Bdoy\" (did you mean \"Body\"?)");
    CHECK(s.console("find bal_l") == "nothing has \"bal_l\" (did you mean \"ball\"?)");
    CHECK(s.console("find rewimd") == "nothing has \"rewimd\" (did you mean \"rewind\"?)");
}

TEST_CASE("documentation in the console has no marks of code") {
    Stage s;
    s.run(
        "Ball = class('Ball', Object) { lives = 3, name_of = '`a`', "
        "doc = { 'Has `lives`.', lives = 'See `name_of` and ` alone.' } } game.ball = Ball {}");
    for (const char* const command :
         {"Ball?", "help(Ball)", "ball?", "ball.lives?", "Ball.lives?", "find lives"}) {
        CAPTURE(command);
        CHECK_THAT(s.console(command), contains("See name_of and ` alone."));
    }
    CHECK_THAT(s.console("find 'Has lives'"), contains("Ball"));
    for (const char* const command : {"help()", "help(world)", "vec?", "after?", "find timers"}) {
        CAPTURE(command);
        CHECK(s.console(command).find('`') == std::string::npos);
    }
    const auto found = s.runtime->complete("ball.live", 9);
    REQUIRE_FALSE(found.empty());
    CHECK(found[0].doc == "See name_of and ` alone.");
    CHECK(s.console("ball.name_of") == "\"`a`\"");  // values stay as they are
}

TEST_CASE("it is the selected instance") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.console("it"), contains("nothing is selected"));
    s.runtime->set_selected(s.tree->child(s.world, "ball"));
    CHECK(s.console("it.mass = 3") == "world.ball.mass: 1 → 3 kg");
    CHECK(s.console("it.mass") == "3 kg");
    CHECK_THAT(s.console("it.mass?"), contains("How hard"));
}

namespace {

std::vector<std::string> labels(Stage& s, const std::string& input) {
    std::vector<std::string> result;
    for (const auto& c : s.runtime->complete(input, input.size())) result.push_back(c.label);
    return result;
}

bool has(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

// The input with the first candidate inserted.
std::string completed(Stage& s, const std::string& input) {
    const auto list = s.runtime->complete(input, input.size());
    if (list.empty()) return "";
    return input.substr(0, list[0].replace_from) + list[0].text;
}

}  // namespace

TEST_CASE("numbers in names count as numbers in lists and tables") {
    Stage s;
    s.run(
        "for _, n in ipairs { 10, 2, 1 } do world['brick_' .. n] = Body {} end "
        "world.brick_1.p10 = 1 world.brick_1.p9 = 1");
    const auto in_order = [](const std::string& text, const std::string& a, const std::string& b,
                             const std::string& c) {
        INFO(text);
        CHECK(text.find(a) < text.find(b));
        CHECK(text.find(b) < text.find(c));
        CHECK(text.find(c) != std::string::npos);
    };
    in_order(s.console("world:all('Body')"), "world.brick_1 ", "world.brick_2 ", "world.brick_10");
    in_order(s.console("find('brick')"), "world.brick_1 ", "world.brick_2 ", "world.brick_10");
    in_order(s.console("world.brick_1"), " mass ", " p9 ", " p10 ");
    in_order(s.console("{ a10 = 1, a9 = 1, a1 = 1 }"), "a1 =", "a9 =", "a10 =");
    in_order(s.console("query('world.brick_*.mass')"), "brick_1.", "brick_2.", "brick_10.");
    const std::vector<std::string> all = labels(s, "world.");
    const auto place = [&](const char* name) { return std::ranges::find(all, name) - all.begin(); };
    CHECK(place("brick_1") < place("brick_2"));
    CHECK(place("brick_2") < place("brick_10"));
    CHECK(place("brick_10") < std::ssize(all));
}

TEST_CASE("completion includes paths and keys and methods and enumerators") {
    Stage s;
    s.run(
        "world.ball = Body { mass = 2 }; world[\"my ball\"] = Body {}; lives = 3; "
        "world['球と箱'] = Body {} "
        "Ball = class('Ball', Body) {} function Ball:hurt() end world.b2 = Ball {}");
    CHECK(completed(s, "wor") == "world");
    CHECK(completed(s, "print(world.ba") == "print(world.ball");
    CHECK(completed(s, "world.ball.mas") == "world.ball.mass");
    CHECK(completed(s, "world.ball.frction") == "world.ball.friction");
    CHECK(completed(s, "world.ball.xyz") == "");
    CHECK(completed(s, "world.ball.frct") == "world.ball.friction");
    CHECK(completed(s, "world.ball:nu") == "world.ball:nudge");
    CHECK(completed(s, "world.b2:hu") == "world.b2:hurt");
    CHECK(completed(s, "world.my") == "world[\"my ball\"]");
    CHECK(completed(s, "world[\"my ball\"].mas") == "world[\"my ball\"].mass");
    CHECK(completed(s, "world[\"my") == "world[\"my ball\"]");
    CHECK(completed(s, "world['ba") == "world.ball");
    CHECK(has(labels(s, "print(world[\""), "my ball"));
    CHECK(labels(s, "nothing[\"").empty());
    CHECK(completed(s, "world.球") == "world[\"球と箱\"]");
    CHECK(completed(s, "world.ball.type = \"ki") == "world.ball.type = \"kinematic");
    CHECK(has(labels(s, "world.ball.type = "), "static"));
    CHECK(completed(s, "world.ball.awake = f") == "world.ball.awake = false");
    CHECK(completed(s, "Body { mas") == "Body { mass");
    CHECK(completed(s, "Body { mass = 2, fric") == "Body { mass = 2, friction");
    CHECK(completed(s, "Body { type = \"st") == "Body { type = \"static");
    CHECK(completed(s, "color(\"tomat") == "color(\"tomato");
    CHECK(completed(s, "world.ball:on(\"cont") == "world.ball:on(\"contact_begin");
    CHECK(completed(s, "world:find(\"Bo") == "world:find(\"Body");
    CHECK(completed(s, "world.gravity.") == "world.gravity.x");
    CHECK(has(labels(s, "liv"), "lives"));
    CHECK(has(labels(s, "string."), "format"));
    CHECK(has(labels(s, "world.gravity:"), "length"));
    CHECK(labels(s, "world.nothing.").empty());
    CHECK(labels(s, "1 .. ").size() > 10);
    for (const auto& candidate : s.runtime->complete("world.ball.mas", 14))
        if (candidate.label == "mass") {
            CHECK(candidate.detail == "2 kg · number · kg · 0 to inf · default 1");
            CHECK(candidate.doc == "How hard it is to move.");
        }
    for (const auto& candidate : s.runtime->complete("world.ball.z", 12))
        if (candidate.label == "z") CHECK_THAT(candidate.detail, contains("· -1e9 to 1e9 · "));
    s.run("for i = 1, 20000 do world:add(Circle {}) end");
    CHECK(completed(s, "world.ball.mas") == "world.ball.mass");
    CHECK(completed(s, "world.gravi") == "world.gravity");
    CHECK(labels(s, "world.").size() == 200);
    // Completion runs no function of a script.
    s.run(
        "trap = setmetatable({}, { __index = function() error('ran') end }); "
        "trap2 = setmetatable({}, { __index = function() while true do end end })");
    CHECK(labels(s, "trap.x.").empty());
    CHECK(labels(s, "trap2.x.").empty());
    for (const char* odd : {"", ".", ":", "[", "\"", "a.b.c.d.", "((((", "world[", "world[1].", "]",
                            "world.ball.type == \"", "\xff\xfe.", "{{{", "Body{", "= = ="})
        s.runtime->complete(odd, std::string(odd).size() + 5);
}

TEST_CASE("completion compares a bounded number of names and describes those that it lists") {
    Stage s;
    s.run("for i = 1, 5000 do world:add(Body { name = 'b' .. i }) end; many = {}");
    const auto near = labels(s, "world.b20");
    CHECK(has(near, "b20"));
    CHECK(has(near, "b209"));
    // Beyond the limit a child is found by its whole name, or by that without two digits.
    CHECK(has(labels(s, "world.b450"), "b4501"));
    CHECK(has(labels(s, "world.b45"), "b4501"));
    CHECK_FALSE(has(labels(s, "world.b4"), "b4501"));
    CHECK(labels(s, "world.b4500").at(0) == "b4500");
    CHECK(completed(s, "world.b4500.mas") == "world.b4500.mass");
    CHECK(labels(s, "world.b4500.").size() > 10);
    s.run("for i = 1, 5000 do many['k' .. i] = i end");
    CHECK(labels(s, "many.k").size() == 200);
    for (const auto& candidate : s.runtime->complete("many.k1", 7))
        CHECK(candidate.detail == candidate.label.substr(1));
    CHECK(s.runtime->complete("many.k", 6, 20).size() == 20);
    // A value that is not listed is not read.
    int reads = 0;
    fettle::property::ClassDescriptor counted{.name = "Counted"};
    counted.properties = {{.name = "alpha"}, {.name = "size"}};
    counted.properties[0].binding.kind = fettle::property::BindingKind::accessor;
    counted.properties[0].binding.context = &reads;
    counted.properties[0].binding.get = [](void* count, stage::Row) {
        ++*static_cast<int*>(count);
        return stage::Value(1.0);
    };
    s.tree->define(std::move(counted));
    s.run("world.counted = Counted {}");
    reads = 0;
    CHECK(completed(s, "world.counted.siz") == "world.counted.size");
    CHECK(reads == 0);
    CHECK(completed(s, "world.counted.alp") == "world.counted.alpha");
    CHECK(reads == 1);
}

TEST_CASE("a function without arguments can be called without parentheses") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    s.console("world.ball.mass = 5");
    CHECK_THAT(s.console("history"), contains("world.ball.mass = 5   console, step 0"));
    CHECK_THAT(s.console("tweaks"), contains("tweaks: this game has no journal of tweaks"));
    CHECK_THAT(s.console("undo"), contains("undo: world.ball.mass = 5"));
}

TEST_CASE("undo names a long command by its beginning that ends with a whole character") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    std::string accents;
    for (int i = 0; i < 100; ++i) accents += "é";
    const std::string before = "world.ball.mass = 5 ";
    s.console(before + "\n-- " + accents);
    CHECK_THAT(s.console("undo"),
               contains("undo: " + before + "-- " + accents.substr(0, 2 * 57) + "…"));
}

TEST_CASE("print and the console show records and objects without fields in the same form") {
    Stage s;
    s.run("world.crate = Body {} hit = world:raycast(vec(-1, 0), vec(5, 0))");
    const std::string shown = s.prints("print(hit)");
    CHECK_THAT(shown, contains("body = world.crate") && contains("point = vec(2, 0)"));
    CHECK(s.console("print(hit)") == shown);
    CHECK(s.console("world:watch('gravity', print)") == "connection");
    CHECK(s.prints("print(formula(function() return 1 end))") == "formula");
}
}  // namespace console_test
