// Errors in scene files: reported with line, column and path, and nothing has changed.

#include <random>

#include "catch.h"
#include "scene_world.h"

namespace error_test {

using namespace scene_test;

namespace {

std::string thing(std::string_view properties) {
    return "{\n  \"fettle_scene\": 1,\n  \"class\": \"Thing\",\n  \"name\": \"ball\",\n"
           "  \"properties\": {\n    " +
           std::string(properties) + "\n  }\n}\n";
}

std::string note(std::string_view properties) {
    std::string text = thing(properties);
    return text.replace(text.find("Thing"), 5, "Note");
}

struct Refused {
    std::string text;
    std::string message;
};

}  // namespace

TEST_CASE("a wrong value is reported with line and column and path and expectation") {
    SceneWorld w;
    CHECK(w.refusal(thing("\"density\": \"abc\"")) ==
          "level.json:6:16: world.ball.density: expected a number from 0 to 1000 kg/m², got text "
          "\"abc\"");
    const std::vector<Refused> all = {
        {thing("\"density\": -2"), "level.json:6:16: world.ball.density: expected a number from 0"},
        {thing("\"density\":\n  \"inf\""), "level.json:7:3: world.ball.density: "},
        {thing("\"number\": \"nan\""), "level.json:6:15: world.ball.number: "},
        {thing("\"number\": 9007199254740993"), "level.json:6:15: world.ball.number: the integer"},
        {thing("\"position\": [1, 9007199254740993]"), "level.json:6:21: world.ball.position: "},
        {thing("\"position\": [1, 2, 3]"), "level.json:6:17: world.ball.position: expected a vec2"},
        {thing("\"position\": {\"vec2\": [1]}"), "level.json:6:26: world.ball.position: expected"},
        {thing("\"position\": {\"vec\": 1}"),
         "level.json:6:17: world.ball.position: expected a value"},
        {thing("\"position\": {}"), "level.json:6:17: world.ball.position: expected a value"},
        {thing("\"integer\": 2.5"), "level.json:6:16: world.ball.integer: expected an integer"},
        {thing("\"integer\": 9223372036854775808"),
         "level.json:6:16: world.ball.integer: expected"},
        {thing("\"narrow\": true"), "level.json:6:15: world.ball.narrow: expected an integer"},
        {thing("\"kind\": \"statc\""), "level.json:6:13: world.ball.kind: expected one of"},
        {thing("\"tint\": \"tomatoe\""), "level.json:6:13: world.ball.tint: no color is called"},
        {thing("\"weight\": 5"), "level.json:6:15: world.ball.weight"},
        {thing("\"parent\": \"world\""), "level.json:6:15: world.ball.parent: is set by"},
        {thing("\"name\": \"other\""), "level.json:6:13: world.ball.name: is set by"},
        {thing("\"mass\": 13"), "level.json:6:13: world.ball.mass: thirteen kilograms"},
        {thing("/* ü */ \"mass\": \"é\""), "level.json:6:21: world.ball.mass: expected"},
        {note("\"text\": {\"bytes\": \"%4\"}"),
         "level.json:6:23: world.ball.text: expected a text"},
        {note("\"target\": \".nobody\""),
         "level.json:6:15: world.ball.target: refers to \".nobody\""},
        {note("\"target\": \"\""), "level.json:6:15: world.ball.target: expected the path"},
        {note("\"target\": \".a..b\""), "level.json:6:15: world.ball.target: expected the path"},
        {note("\"target\": \"world[1]\""), "level.json:6:15: world.ball.target: refers to"},
        {note("\"target\": \"wrld\""),
         "level.json:6:15: world.ball.target: refers to \"wrld\", which "
         "does not exist (did you mean \"world\"?)"},
        {note("\"thing\": \".\""), "level.json:6:14: world.ball.thing: expected a Thing or nil"},
        {note("\"thing\": 5"), "level.json:6:14: world.ball.thing: expected a Thing or nil, got"},
        {note("\"targets\": [\".\", 3]"),
         "level.json:6:16: world.ball.targets[2]: expected an instance"},
        {note("\"points\": [[1, 2], [3]]"),
         "level.json:6:15: world.ball.points[2]: expected a vec2"},
    };
    for (const Refused& each : all) {
        CAPTURE(each.text, each.message);
        const std::string message = w.refusal(each.text);
        CHECK(message.substr(0, each.message.size()) == each.message);
        CHECK(message.find("detached") == std::string::npos);
    }
}

TEST_CASE("a wrong structure is reported with line and column") {
    SceneWorld w;
    const std::vector<Refused> all = {
        {"", "level.json:1:1: not JSON: "},
        {"\n\n  ", "level.json:3:3: not JSON: "},
        {"[]", "level.json:1:1: expected a scene, that is an object, got an array"},
        {"{}", "level.json:1:1: not a scene: the key \"fettle_scene\""},
        {"{\"fettle_scene\": 1}", "level.json:1:1: expected an instance"},
        {"{\"fettle_scene\": 1, \"Class\": \"Thing\"}",
         "level.json:1:1: expected an instance, but there is no key \"class\", only \"Class\""},
        {"{\"fettle_scene\": 2, \"class\": \"Future\"}",
         "level.json:1:18: this scene is in version 2 of the format"},
        {"{\"fettle_scene\": 0}", "level.json:1:18: the version"},
        {"{\"fettle_scene\": 1.0}", "level.json:1:18: the version"},
        {"{\"fettle_scene\": 1, \"class\": \"Thng\"}",
         "level.json:1:30: no class is called \"Thng\" (did you mean \"Thing\"?)"},
        {"{\"fettle_scene\": 1, \"class\": \"Service\"}",
         "level.json:1:1: world.service: a Service"},
        {"{\"fettle_scene\": 1, \"class\": 5}", "level.json:1:30: \"class\" must be a text"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": 5}",
         "level.json:1:47: \"name\" must be a text, not an integer"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"\"}",
         "level.json:1:47: a name cannot be empty"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\", \"properties\": []}",
         "level.json:1:53: \"properties\" must be an object"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\",\n\"childern\": []}",
         "level.json:2:1: world.thing: an instance has no key \"childern\" (did you mean "
         "\"children\"?)"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\",\n\"children\": [4]}",
         "level.json:2:14: expected an instance"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"a\",\n"
         "\"children\": [{\"class\": \"Bdy\", \"name\": \"b\"}]}",
         "level.json:2:24: world.a.b: no class is called \"Bdy\""},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"a\",\n"
         "\"children\": [{\"class\": \"Note\", \"name\": \"b\"},\n{\"class\": \"Note\", \"name\": "
         "\"b\"}]}",
         "level.json:3:27: world.a has two children called \"b\""},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"a\",\n"
         "\"children\": [{\"class\": \"Note\", \"name\": \"mass\"}]}",
         "level.json:2:40: world.a"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\",\n\"class\": \"Note\"}",
         "level.json:2:1: the key \"class\" was given before, on line 1"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\",\n\"ad_hoc\": {\"x\": 1, \"\\u0078\": 2}}",
         "level.json:2:20: the key \"x\" was given before, on line 2"},
        {"{\"fettle_scene\": 1, \"class\": \"Host\", \"name\": \"h\",\n"
         "\"children\": [{\"class\": \"Thing\", \"name\": \"service\"}]}",
         "level.json:2:41: world.h.service: is made by its parent, as a Service, not a Thing"},
        {"{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"h\",\n"
         "\"ad_hoc\": {\"b\": 1}, \"children\": [{\"class\": \"Thing\", \"name\": \"b\"}]}",
         "level.json:2:17: world.h"},
        {"{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"h\",\n\"ad_hoc\": {\"\": 1}}",
         "level.json:2:16: world.h"},
        {"{\"fettle_scene\": 1,\n \"class\": Thing}", "level.json:2:11: not JSON: "},
        {"{\"fettle_scene\": 1,\n \"class\": \"Th\x01ing\"}", "level.json:2:14: not JSON: "},
        {"{\"fettle_scene\": 1,\n \"class\": \"Th\xff\"}", "level.json:2:14: not JSON: "},
        {"{\"fettle_scene\": 1,,}", "level.json:1:20: not JSON: "},
        {"{\"fettle_scene\": 1e999}", "level.json:1:18: not JSON: number overflow"},
        {std::string("{\"fettle_scene\": 1, \"class\": \"Thing\"}\0 {", 40),
         "level.json:1:38: not JSON: a zero byte"},
        {"{\"fettle_scene\": 1, \"class\": \"Thing\"} x", "level.json:1:39: not JSON: "},
    };
    for (const Refused& each : all) {
        CAPTURE(each.text, each.message);
        CHECK(w.refusal(each.text).substr(0, each.message.size()) == each.message);
    }
}

TEST_CASE("a misplaced key is reported with its right place") {
    SceneWorld w;
    const auto scene = [](const std::string& members) {
        return "{\n  \"fettle_scene\": 1,\n  \"class\": \"Thing\",\n  " + members +
               ",\n  \"name\": \"ball\"\n}\n";
    };
    const std::string inside = "belongs inside \"properties\"";
    const std::vector<Refused> all = {
        {scene("\"position\": [1, 2]"),
         "level.json:4:3: world.ball: an instance has no key \"position\"; it is a property of "
         "Thing "
         "and " +
             inside},
        {scene("\"flag\": true"),
         "level.json:4:3: world.ball: an instance has no key \"flag\"; it"},
        {scene("\"postion\": [1, 2]"),
         "level.json:4:3: world.ball: an instance has no key \"postion\" (did you mean "
         "\"position\"? "
         "It is a property of Thing and " +
             inside},
        {scene("\"Density\": 3"), "level.json:4:3: world.ball: an instance has no key \"Density\""},
        {scene("\"weight\": 3"),
         "level.json:4:3: world.ball: an instance has no key \"weight\"; it is a property of "
         "Thing, "
         "which no scene file sets"},
        {scene("\"children\": [{\"class\": \"Thing\", \"fettle_scene\": 1}]"),
         "level.json:4:35: world.ball.thing: an instance has no key \"fettle_scene\": it stands "
         "once"},
        {scene("\"children\": [{\"class\": \"Thing\", \"name\": \"b\", \"mass\": 1}]"),
         "level.json:4:48: world.ball.b: an instance has no key \"mass\"; it is a property"},
        {scene("\"properties\": {\"children\": [{\"class\": \"Note\"}]}"),
         "level.json:4:18: world.ball: \"children\" stands inside \"properties\" and belongs "
         "beside it"},
        {scene("\"properties\": {\"ad_hoc\": {\"x\": 1}}"),
         "level.json:4:18: world.ball: \"ad_hoc\" stands inside \"properties\" and belongs beside "
         "it"},
        {scene("\"properties\": {\"properties\": {\"mass\": 1}}"),
         "level.json:4:18: world.ball: \"properties\" stands inside \"properties\""},
        {scene("\"properties\": {\"class\": \"Note\"}"),
         "level.json:4:27: world.ball.class: is set by the keys and the place of the instance"},
        {scene("\"properties\": {\"circle\": {\"class\": \"Note\"}}"),
         "level.json:4:18: world.ball: \"circle\" stands inside \"properties\" and belongs into "
         "the "
         "list \"children\""},
        {scene("\"ad_hoc\": {\"circle\": {\"class\": \"Note\", \"name\": \"c\"}}"),
         "level.json:4:14: world.ball: \"circle\" stands inside \"ad_hoc\" and belongs into the "
         "list"},
        {scene("\"ad_hoc\": {\"children\": [{\"class\": \"Note\"}]}"),
         "level.json:4:14: world.ball: \"children\" stands inside \"ad_hoc\" and belongs beside "
         "it"},
        {"{\"fettle_scen\": 1, \"class\": \"Thing\"}",
         "level.json:1:1: not a scene: the key \"fettle_scene\" with the version of the format is "
         "missing, there is only \"fettle_scen\""},
    };
    for (const Refused& each : all) {
        CAPTURE(each.text, each.message);
        CHECK(w.refusal(each.text).substr(0, each.message.size()) == each.message);
    }
}

TEST_CASE("an unknown key is kept with a warning unless it is an object as editors leave") {
    SceneWorld w;
    const std::string head = "{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"ball\",\n";
    w.load(head + "\"propreties_\": {\"mass\": 1}}");
    REQUIRE(w.warnings.size() == 1);
    CHECK(w.warnings[0] ==
          "level.json:2:1: world.ball: an instance has no key \"propreties_\" (did you mean "
          "\"properties\"?); kept as it is");
    w.load(head + "\"editor\": {\"zoom\": 2}}");
    CHECK(w.warnings.empty());
    w.load(head + "\"lives\": 3}");
    REQUIRE(w.warnings.size() == 1);
    CHECK(w.warnings[0] ==
          "level.json:2:1: world.ball: an instance has no key \"lives\"; kept as it is (what is "
          "your own belongs under \"ad_hoc\")");
}

TEST_CASE("an error contains its kind and place") {
    SceneWorld w;
    try {
        w.load(thing("\"density\": -2"));
        FAIL("nothing was refused");
    } catch (const SceneError& e) {
        CHECK(e.kind() == ErrorKind::out_of_range);
        CHECK(e.file() == "level.json");
        CHECK(e.line() == 6);
        CHECK(e.column() == 16);
    }
}

TEST_CASE("a load that fails changes nothing") {
    SceneWorld w;
    w.add("Thing", "ball");
    w.add("Note", "note");
    w.tree.barrier();
    const std::string before = w.everything();
    const std::size_t size = w.tree.size();
    std::vector<std::string> reported;
    const Class& object = w.tree.object_class();
    w.tree.watch_created(object,
                         [&](const Existence& e) { reported.push_back("created " + e.path); });
    w.tree.on(object, *object.event("ready"),
              [&](const Occurrence& o) { reported.push_back("ready " + w.tree.path(o.instance)); });
    const std::string tail =
        "\"children\": [{\"class\": \"Thing\", \"name\": \"a\", \"properties\": {\"number\": 1}},"
        "{\"class\": \"Note\", \"name\": \"b\", \"properties\": {\"target\": \".c\"}}]}";
    const std::string head = "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"demo\", ";
    CHECK(w.refusal(head + tail).find("refers to \".c\"") != std::string::npos);
    CHECK(w.refusal(thing("\"mass\": 13")) != "");
    CHECK_THROWS_AS(w.load(thing("\"number\": 13"), "note"), Error);
    CHECK(w.warnings.empty());
    CHECK(w.everything() == before);
    CHECK(w.tree.size() == size);
    w.tree.barrier();
    CHECK(reported.empty());
}

TEST_CASE("loading below a deleted parent is refused") {
    SceneWorld w;
    const Handle parent = w.add("Object");
    w.tree.destroy(parent);
    CHECK_THROWS_AS(load_scene_text(w.tree, thing(""), "level.json", parent), Error);
}

}  // namespace error_test
