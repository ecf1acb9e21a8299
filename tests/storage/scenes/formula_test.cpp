// Formulas in scene files: their text, and the value for programs that cannot compute it.

#include <fettle/property/path.h>

#include "catch.h"
#include "scene_world.h"

namespace formula_test {

using namespace scene_test;

namespace {

/// Compiles one kind of formula, "twice PATH", in place of a language.
Formula twice(const std::string& source) {
    if (!source.starts_with("twice "))
        throw Error(ErrorKind::formula, "the formula does not compile: expected twice PATH");
    const std::string path = source.substr(6);
    return {.function = [path](const Tree& tree) { return Value(2 * get(tree, path).as_double()); },
            .source = source};
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string scene(const std::string& members) {
    return R"({"fettle_scene": 1, "class": "Thing", "name": "b", )" + members + "}";
}

}  // namespace

TEST_CASE("a formula is saved as its text and its current value") {
    SceneWorld w;
    const Handle a = w.add("Thing", "a"), b = w.add("Thing", "b");
    w.tree.set(a, "number", 3.0);
    w.tree.set_formula(b, "number", twice("twice world.a.number"));
    w.tree.set_formula(b, "score", twice("twice world.b.number"));
    const std::string text = w.text(b);
    CHECK(has(text, R"("number": {"is": "twice world.a.number", "value": 6})"));
    CHECK(has(text, R"("score": {"is": "twice world.b.number", "value": 12.0})"));
}

TEST_CASE("a loaded formula is computed again when its source changes") {
    SceneWorld w;
    w.tree.compile_formulas_with(twice);
    const Handle a = w.add("Thing", "a"), b = w.add("Thing", "b");
    w.tree.set(a, "number", 3.0);
    w.tree.set_formula(b, "number", twice("twice world.a.number"));
    w.tree.set_formula(b, "score", twice("twice world.a.number"));
    const std::string text = w.text(b);
    const Handle c = w.load(text, "c");
    CHECK(w.warnings.empty());
    w.tree.set(a, "number", 5.0);
    CHECK(w.tree.get(c, "number") == Value(10.0));
    CHECK(w.tree.get(c, "score") == Value(10.0));
    w.tree.set(a, "number", 3.0);
    w.tree.rename(b, "d");
    w.tree.rename(c, "b");
    CHECK(w.text(c) == text);
}

TEST_CASE("without a compiler the text and the value of a formula are kept") {
    SceneWorld w;
    const std::string text =
        w.text(w.load(scene(R"("properties": {"number": {"is": "magic", "value": 6}, "position": )"
                            R"({"is": "more magic", "value": [1, 2]}})")));
    const Handle b = w.tree.child(w.world, "b");
    CHECK(w.tree.get(b, "number") == Value(6.0));
    CHECK(w.tree.get(b, "position") == Value(Vec2(1, 2)));
    REQUIRE(w.tree.formula(b, w.tree.property(b, "number")) != nullptr);
    CHECK(w.tree.formula(b, w.tree.property(b, "number"))->source == "magic");
    CHECK(has(text, R"("number": {"is": "magic", "value": 6})"));
    w.tree.set(b, "number", 7.0);
    CHECK(has(w.text(b), R"("number": 7)"));
}

TEST_CASE("a formula written by hand needs no value") {
    SceneWorld w;
    w.tree.compile_formulas_with(twice);
    w.tree.set(w.add("Thing", "a"), "number", 3.0);
    const Handle b = w.load(scene(R"("properties": {"number": {"is": "twice world.a.number"}}, )"
                                  R"("ad_hoc": {"score": {"is": "twice world.a.number"}})"));
    CHECK(w.tree.get(b, "number") == Value(6.0));
    CHECK(w.tree.get(b, "score") == Value(6.0));
}

TEST_CASE("a formula whose text does not compile is refused with its place") {
    SceneWorld w;
    w.tree.compile_formulas_with(twice);
    const std::string before = w.everything();
    CHECK(w.refusal(scene("\"properties\": {\n  \"number\": {\"is\": \"half world.a\"}}")) ==
          "level.json:2:20: world.b.number: the formula does not compile: expected twice PATH");
    CHECK(w.refusal(scene("\"ad_hoc\": {\n  \"x\": {\"value\": 1, \"is\": \"3\"}}")) ==
          "level.json:2:27: world.b.x: the formula does not compile: expected twice PATH");
    CHECK(has(w.refusal(scene("\"ad_hoc\": {\n  \"x\": {\"is\": 3}}")), "expected a formula as"));
    CHECK(has(w.refusal(scene("\"ad_hoc\": {\n  \"x\": {\"is\": \"twice a\", \"vale\": 3}}")),
              "level.json:2:26: world.b.x: expected a formula as"));
    CHECK(w.everything() == before);
}

TEST_CASE("a formula that its text does not define is saved as its value with a warning") {
    SceneWorld w;
    const Handle b = w.add("Thing", "b");
    Formula bound = twice("twice world.a.number");
    w.tree.set(w.add("Thing", "a"), "number", 3.0);
    bound.not_saved = "uses the local variable \"speed\" of main.lua:12";
    w.tree.set_formula(b, "number", bound);
    w.tree.set_formula(b, "small", Formula{[](const Tree&) { return Value(0.25); }});
    std::vector<std::string> warnings;
    const std::string text = scene_text(w.tree, b, &warnings);
    CHECK(has(text, R"("number": 6)"));
    CHECK(has(text, R"("small": 0.25)"));
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0] ==
          "world.b.number: its formula uses the local variable \"speed\" of main.lua:12, so it "
          "cannot be saved; its value 6 is saved instead");
    CHECK(has(warnings[1], "world.b.small: its formula has no text"));
}

TEST_CASE("a formula in error is saved with its last valid value") {
    SceneWorld w;
    w.tree.compile_formulas_with(twice);
    const Handle a = w.add("Thing", "a"), b = w.add("Thing", "b");
    w.tree.set(a, "number", 3.0);
    w.tree.set_formula(b, "number", twice("twice world.a.number"));
    CHECK(w.tree.get(b, "number") == Value(6.0));
    w.tree.destroy(a);
    const std::string text = w.text(b);
    CHECK(has(text, R"({"is": "twice world.a.number", "value": 6})"));
    const Handle c = w.load(text, "c");
    CHECK_FALSE(w.tree.problem(c, w.tree.property(c, "number")).empty());
    w.tree.set(w.add("Thing", "a"), "number", 4.0);
    CHECK(w.tree.get(c, "number") == Value(8.0));
}

TEST_CASE("the value of a formula is saved only if it can be loaded") {
    SceneWorld w;
    w.tree.compile_formulas_with(twice);
    const Handle b = w.add("Thing", "b");
    w.things.at(0).density = -1;  // the mass that is computed from it is out of range
    Formula failing = twice("twice world.a.number");
    w.tree.set_formula(b, "mass", failing);
    std::vector<std::string> warnings;
    std::string text = scene_text(w.tree, b, &warnings);
    CHECK(has(text, R"("mass": {"is": "twice world.a.number"})"));
    CHECK(warnings.empty());

    failing.not_saved = "uses the local variable \"speed\" of main.lua:12";
    w.tree.set_formula(b, "mass", failing);
    text = scene_text(w.tree, b, &warnings);
    CHECK_FALSE(has(text, "mass"));
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] ==
          "world.b.mass: its formula uses the local variable \"speed\" of main.lua:12, so it "
          "cannot be saved; it has had no value yet, so none is saved");
}

TEST_CASE("a file cannot define a formula for name or parent") {
    SceneWorld w;
    w.tree.compile_formulas_with(twice);
    const Handle top = w.load(scene(R"("properties": {"number": 2})"), "b");
    for (const std::string key : {"name", "parent"}) {
        INFO(key);
        std::string reported;
        try {
            w.load(R"({"fettle_scene": 1, "class": "Thing", "properties": {")" + key +
                       R"(": {"is": "twice world.b.number", "value": "c"}}})",
                   "c");
        } catch (const Error& error) {
            reported = error.what();
        }
        for (const std::string& warning : w.warnings) reported += warning;
        CHECK_THAT(reported, contains(key));
        CHECK(w.tree.name(top) == "b");
        w.tree.restore(w.tree.snapshot());
    }
}
}  // namespace formula_test
