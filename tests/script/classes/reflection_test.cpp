// Descriptions of classes in scripts.

#include "stage.h"

namespace reflection_test {

using stage::Stage;

TEST_CASE("a script can list the properties of a class") {
    Stage s;
    CHECK(s.prints("local n = 0 "
                   "for _, p in ipairs(classes.Body.properties) do "
                   "  n = n + 1 "
                   "  if p.name == 'velocity' then print(p.name, p.type, p.unit) end "
                   "end "
                   "print(n == #Body.properties)") == "velocity\tvec2\tm/s|true");
}

TEST_CASE("the table of classes has every class by number and by name") {
    Stage s;
    std::string expected;
    for (const auto* of : s.tree->classes()) expected += (expected.empty() ? "" : "|") + of->name();
    CHECK(s.prints("for _, c in ipairs(classes) do print(c.name) end") == expected);
    CHECK(s.prints("for i, c in ipairs(classes) do assert(classes[c.name] == c) end "
                   "print(classes.Body == Body, Body.base, Object.base)") == "true\tObject\tnil");
}

TEST_CASE("the description of a property has unit and range and default and kind") {
    Stage s;
    CHECK(s.prints("local p = Body.properties.mass "
                   "print(p.type, p.unit, p.min, p.max, p.default, p.inf, p.read_only, p.owner)") ==
          "number\tkg\t0.0\tinf\t1.0\ttrue\tfalse\tBody");
    CHECK(s.prints("for _, e in ipairs(Body.properties.type.enumerators) do print(e) end") ==
          "static|kinematic|dynamic");
    CHECK(s.prints("print(Body.properties.type.min, Body.properties.name.default)") == "nil\tnil");
}

TEST_CASE("descriptions of methods and events have arguments and results") {
    Stage s;
    CHECK(s.prints("local m = World.methods.raycast "
                   "print(m.signature, m.doc, m.many) "
                   "for _, f in ipairs(m.parameters) do print(f.name, f.type, f.optional) end "
                   "for _, f in ipairs(m.returns) do print(f.name, f.type) end") ==
          "raycast(from, to)\tThe first body a ray meets.\tfalse|from\tvec2\tfalse|to\tvec2\tfalse|"
          "body\treference|point\tvec2|fraction\tnumber|note\ttext");
    CHECK(s.prints("print(Object.events.deleted.fields.path.doc)") == "Where it was.");
}

TEST_CASE("classes that scripts define are described like native ones") {
    Stage s;
    CHECK(s.prints("Ball = class('Ball', Body) { lives = 3, doc = { 'A ball.', lives = 'Left.' } } "
                   "local p = classes.Ball.properties.lives "
                   "print(p.type, p.default, p.doc, p.owner, Ball.doc, Ball.creatable) "
                   "print(#Body.derived, Body.derived.Ball == Ball)") ==
          "integer\t3\tLeft.\tBall\tA ball.\ttrue|1\ttrue");
}

TEST_CASE("descriptions cannot be changed and unknown fields are reported") {
    Stage s;
    CHECK(s.fails("Body.properties.mass.unit = 'g'").find("cannot be changed") !=
          std::string::npos);
    CHECK(s.fails("Body.properties.extra = {}").find("cannot be changed") != std::string::npos);
    CHECK(s.fails("classes.Body = nil").find("cannot be changed") != std::string::npos);
    CHECK(s.fails("print(Body.properties.mas)").find("did you mean \"mass\"") != std::string::npos);
    CHECK(s.fails("print(Body.properties.mass.units)").find("did you mean \"unit\"") !=
          std::string::npos);
    CHECK(s.fails("rawset(Body.properties, 1, 2)").find("table expected") != std::string::npos);
    CHECK(s.fails("rawset(classes.Body.properties.mass, 'unit', 'g')").find("table expected") !=
          std::string::npos);
    CHECK(s.fails("setmetatable(Body.properties, {})").find("needs a table") != std::string::npos);
    CHECK(s.prints("print(getmetatable(Body.properties))") == "description");
    CHECK(s.fails("function Body:properties() end").find("every class has that") !=
          std::string::npos);
    CHECK(s.prints("local p = Body.properties.position p.default.x = 99 "
                   "print(p.default.x, Body.properties.position.default.x)") == "0.0\t0.0");
}

TEST_CASE("a global of the game named classes hides only that name") {
    Stage s;
    CHECK(s.prints("classes = { 1 } print(#classes, Body.properties.mass.unit)") == "1\tkg");
}

TEST_CASE("pairs of a description visits its fields in the documented order") {
    Stage s;
    CHECK(s.prints("local names = {} "
                   "for k, v in pairs(Object.events.deleted.fields.path) do names[#names + 1] = k "
                   "end print(table.concat(names, ' '))") ==
          "name type unit doc nullable optional");
    CHECK(s.prints("for k, v in pairs(World.methods) do print(k, v.name) end") ==
          "1\tdrawn_position|2\tdrawn_angle|3\tto_drawn|4\traycast|5\traycast_all");
}

TEST_CASE("the description of an instance includes its ad-hoc properties") {
    Stage s;
    CHECK(s.prints("world.ball = Body {} world.ball.lives = 3 "
                   "local p = world.ball:describe('lives') print(p.type, p.owner) "
                   "local found for _, q in ipairs(world.ball:describe()) do "
                   "  if q.name == 'lives' then found = true end end print(found) "
                   "print(world.ball:describe('nudge').parameters.by.type)") ==
          "any\tnil|true|vec2");
    CHECK(s.fails("world.ball:describe('mas')").find("did you mean \"mass\"") != std::string::npos);
}

TEST_CASE("the console shows and completes descriptions") {
    Stage s;
    CHECK(s.console("Body.properties.mass.unit") == "\"kg\"");
    const std::string lines = s.console("Body.properties");
    CHECK(lines.find("velocity") != std::string::npos);
    CHECK(lines.find("m/s") != std::string::npos);
    const auto labels = [&](const std::string& input) {
        std::string all;
        for (const auto& each : s.runtime->complete(input, input.size())) all += each.label + " ";
        return all;
    };
    CHECK(labels("Body.prop").starts_with("properties "));
    CHECK(labels("Body.properties.mas").starts_with("mass "));
    CHECK(labels("Body.properties.mass.un").starts_with("unit "));
    CHECK(labels("classes.Bod").starts_with("Body "));
    CHECK(labels("clas").find("classes ") != std::string::npos);
}

TEST_CASE("every global of the language and every member of its values is explained by help") {
    Stage s;
    const std::string missing = s.prints(
        "local function look(prefix, t) "
        "  for k, v in pairs(t) do "
        "    if k ~= '_G' and type(v) == 'table' then look(prefix .. k .. '.', v) "
        "    elseif #prefix == 0 or type(v) ~= 'table' then print(prefix .. k) end "
        "  end "
        "end look('', _G)");
    std::size_t seen = 0;
    for (std::size_t start = 0; start < missing.size();) {
        const std::size_t end = std::min(missing.find('|', start), missing.size());
        const std::string name = missing.substr(start, end - start);
        start = end + 1;
        INFO(name);
        const std::string help = s.console("help('" + name + "')");
        CHECK(help.find(name) != std::string::npos);
        CHECK(help.find("|  ") != std::string::npos);
        ++seen;
    }
    CHECK(seen > 90);
    CHECK(s.console("help('vec.rotated')").find(":rotated(angle: number): vec") == 0);
    CHECK(s.console("help('pen.circle')").find(".circle(center: vec, radius: number") == 0);
    CHECK(s.console("help('key_pressed')").find("key_pressed(key: string)") == 0);
}

}  // namespace reflection_test
