// Valid scene files, unknown keys in them, and other effects of loading.

#include "catch.h"
#include "scene_world.h"

namespace load_test {

using namespace scene_test;

namespace {

std::string scene(std::string_view members) {
    return "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"demo\"" +
           std::string(members.empty() ? "" : ", ") + std::string(members) + "}";
}

std::string children(std::string_view text) {
    return scene("\"children\": [" + std::string(text) + "]");
}

}  // namespace

TEST_CASE("a scene may have comments and a byte order mark") {
    SceneWorld w;
    const Handle top = w.load(
        "\xef\xbb\xbf// the level\n"
        "{ /* format */ \"fettle_scene\": 1, // one\r\n"
        "  \"class\": /**/ \"Thing\", \"name\": \"ball\",\n"
        "  \"properties\": { \"number\": 4 /* kg // */ , \"kind\": \"static\" } }\n// end");
    CHECK(w.tree.get(top, "number") == Value(4.0));
    CHECK(w.tree.get(top, "kind") == Value("static"));
}

TEST_CASE("references may lead forward and backward and out of the scene") {
    SceneWorld w;
    const Handle floor = w.add("Thing", "my floor");
    const Handle top = w.load(children(
        R"({"class": "Note", "name": "first", "properties": {"thing": ".last.part", "target": "game.world[\"my floor\"]"}},
           {"class": "Object", "name": "last", "children": [{"class": "Thing", "name": "part"}]},
           {"class": "Note", "name": "up", "properties": {"target": ".", "targets": [".first", "world.demo.last", null, "game"]}})"));
    const Handle first = w.tree.child(top, "first");
    const Handle last = w.tree.child(top, "last");
    const Handle up = w.tree.child(top, "up");
    CHECK(w.tree.get(first, "thing") == Value(w.tree.child(last, "part")));
    CHECK(w.tree.get(first, "target") == Value(floor));
    CHECK(w.tree.get(up, "target") == Value(top));
    CHECK(w.tree.get(up, "targets") == Value(List{first, last, Handle{}, w.tree.root()}));
}

TEST_CASE("references inside a scene are right under another name and parent") {
    SceneWorld w;
    const Handle top = w.add("Object", "original");
    const Handle thing = w.add("Thing", top, "thing");
    const Handle note = w.add("Note", top, "note");
    w.tree.set(note, "thing", thing);
    w.tree.set_or_add(note, "also", List{thing, w.world});
    const Handle copy = w.copy(top, "second");
    const Handle copied = w.tree.child(copy, "thing");
    CHECK(w.tree.get(w.tree.child(copy, "note"), "thing") == Value(copied));
    CHECK(w.tree.get(w.tree.child(copy, "note"), "also") == Value(List{copied, w.world}));
}

TEST_CASE("the name of a scene is that in the file or the one given by the caller") {
    SceneWorld w;
    CHECK(w.tree.path(w.load(scene(""))) == "world.demo");
    CHECK(w.tree.path(w.load(scene(""))) == "world.demo_1");
    CHECK(w.tree.path(w.load(scene(""), "other")) == "world.other");
    CHECK_THROWS_AS(w.load(scene(""), "other"), Error);
    const Handle loose = load_scene_text(w.tree, scene(""), "level.json", {});
    CHECK_FALSE(w.tree.parent(loose));
    CHECK(w.tree.name(loose) == "demo");
}

TEST_CASE("children without a name are named as by a constructor") {
    SceneWorld w;
    const Handle top = w.load(children(R"({"class": "Thing"}, {"class": "Thing"},
        {"class": "Note"}, {"class": "Thing", "name": "thing_2"}, {"class": "Thing"})"));
    std::vector<std::string> names;
    for (const Handle child : w.tree.children(top)) names.push_back(w.tree.name(child));
    CHECK(names == std::vector<std::string>{"thing", "thing_3", "note", "thing_2", "thing_4"});
    // After saving and loading, they have the same names.
    const std::string text = scene_text(w.tree, top);
    const Handle again = load_scene_text(w.tree, text, "level.json", {});
    CHECK(scene_text(w.tree, again) == text);
}

TEST_CASE("a child without a name does not get the name of a member of its parent") {
    SceneWorld w;
    const Handle top = w.load(R"({"fettle_scene": 1, "class": "Note", "name": "demo",
        "children": [{"class": "Thing"}, {"class": "Thing"}]})");
    REQUIRE(w.tree.class_of(top).property("thing") != nullptr);
    CHECK(w.tree.name(w.tree.children(top)[0]) == "thing_2");
    CHECK(w.tree.name(w.tree.children(top)[1]) == "thing_3");
}

TEST_CASE("ready is called for children before their parents when all values are set") {
    SceneWorld w;
    std::vector<std::string> seen;
    const Event& ready = *w.tree.object_class().event("ready");
    w.tree.on(w.tree.object_class(), ready, [&](const Occurrence& happened) {
        seen.push_back(w.tree.path(happened.instance));
        if (w.tree.class_of(happened.instance).name() == "Note") {
            CHECK(w.tree.get(happened.instance, "target") ==
                  Value(w.tree.child(w.tree.child(w.world, "demo"), "b")));
        }
    });
    w.load(children(
        R"({"class": "Object", "name": "a", "children": [
              {"class": "Note", "name": "x", "properties": {"target": ".b"}},
              {"class": "Thing", "name": "y"}]},
           {"class": "Object", "name": "b"})"));
    CHECK(seen.empty());
    w.tree.barrier();
    CHECK(seen == std::vector<std::string>{"world.demo.a.x", "world.demo.a.y", "world.demo.a",
                                           "world.demo.b", "world.demo"});
}

TEST_CASE("the writer of the values of a scene is load at a line of the file") {
    SceneWorld w;
    std::vector<Cause> causes;
    const Class& thing = w.tree.class_named("Thing");
    w.tree.watch(thing, thing.property("number"),
                 [&](const Change& change) { causes.push_back(change.cause); });
    w.load(
        "{\n\"fettle_scene\": 1,\n\"class\": \"Thing\",\n\"properties\": {\n\n"
        "\"number\": 3\n}}");
    w.tree.barrier();
    REQUIRE(causes.size() == 1);
    CHECK(causes[0].writer == Writer::load);
    CHECK(causes[0].where == "level.json:6");
}

TEST_CASE("a property that the class does not have is kept and written back unchanged") {
    SceneWorld w;
    const std::string text =
        "{\n"
        "  \"fettle_scene\": 1,\n"
        "  \"class\": \"Thing\",\n"
        "  \"name\": \"ball\",\n"
        "  \"properties\": {\n"
        "    \"number\": 3,\n"
        "    \"densety\": 1.50,\n"
        "    \"charge\": [\n"
        "      1e0, {\"vec2\": [1, 2]}  // two\n"
        "    ]\n"
        "  },\n"
        "  \"editor\": {\"folded\": true}\n"
        "}\n";
    const Handle ball = w.load(text);
    CHECK(
        w.warnings ==
        std::vector<std::string>{
            "level.json:7:5: world.ball: Thing has no property \"densety\" (did you mean "
            "\"density\"?); kept as it is",
            "level.json:8:5: world.ball: Thing has no property \"charge\"; kept as it is (what is "
            "your own belongs under \"ad_hoc\")"});
    CHECK(w.tree.find(ball, "densety") == nullptr);
    CHECK(w.tree.find(ball, "charge") == nullptr);
    CHECK(w.tree.get(ball, "density") == Value(1.0));
    CHECK(w.text(ball) == text);
    std::string copied = w.text(w.copy(ball, "twin"));
    copied.replace(copied.find("twin"), 4, "ball");
    CHECK(copied == text);

    w.tree.remove_ad_hoc(ball, unknown_keys_property);
    CHECK(w.text(ball).find("densety") == std::string::npos);
}

TEST_CASE("a kept property is not written once the class has it") {
    SceneWorld w;
    const Handle ball = w.load(scene(R"("properties": {"charge": 3}, "notes": "x")"));
    w.tree.set_or_add(
        ball, unknown_keys_property,
        R"({"properties": {"parent": 1, "charge": 4}, "class": "Evil", "children": 7})");
    const std::string text = w.text(ball);
    CHECK(text.find("\"charge\": 4") != std::string::npos);
    CHECK(text.find("parent") == std::string::npos);
    CHECK(text.find("Evil") == std::string::npos);
    CHECK(text.find("children") == std::string::npos);
    CHECK_NOTHROW(w.load(text, "again"));
}

TEST_CASE("a text of the user's own called unknown_keys is saved like any other") {
    SceneWorld w;
    const Handle object = w.add("Object", "mine");
    w.tree.set_or_add(object, unknown_keys_property, "house key, car key");
    CHECK(w.tree.get(w.copy(object), unknown_keys_property) == Value("house key, car key"));
}

TEST_CASE("an ad hoc property becomes the declared one of that name") {
    SceneWorld w;
    const Handle ball = w.load(
        R"({"fettle_scene": 1, "class": "Thing", "ad_hoc": {"number": 4, "numbr": 5, "poke": 6}})");
    CHECK(w.tree.get(ball, "number") == Value(4.0));
    CHECK(w.tree.find(ball, "numbr") == nullptr);
    CHECK(w.warnings.size() == 2);
    CHECK(w.text(ball).find("\"numbr\": 5") != std::string::npos);
    CHECK(w.text(ball).find("\"poke\": 6") != std::string::npos);
}

TEST_CASE("values may be written in every form of their type") {
    SceneWorld w;
    const Handle a = w.load(
        R"({"fettle_scene": 1, "class": "Thing", "properties": {"number": "-inf", "integer": 4.0,
            "tint": "tomato", "position": [1, "inf"], "small": {"number": "inf"}}})");
    CHECK(w.tree.get(a, "number") == Value(-infinity));
    CHECK(w.tree.get(a, "small") == Value(infinity));
    CHECK(w.tree.get(a, "integer") == Value(4));
    CHECK(w.tree.get(a, "position") == Value(Vec2(1, infinity)));
    Color tomato;
    REQUIRE(parse_color("tomato", tomato));
    CHECK(w.tree.get(a, "tint") == Value(tomato));
    const Handle b = w.load(
        R"({"fettle_scene": 1, "class": "Thing", "properties": {"tint": [1, 0.5, 0],
            "position": {"vec2": [3, 4]}, "number": -0, "density": null}})");
    CHECK(w.tree.get(b, "tint") == Value(Color{1, 0.5f, 0, 1}));
    CHECK(w.tree.get(b, "position") == Value(Vec2(3, 4)));
    CHECK(w.tree.get(b, "number") == Value(-0.0));
    CHECK(w.tree.get(b, "density") == Value(1.0));
}

TEST_CASE("a value that cannot be saved is reported with the reason") {
    SceneWorld w;
    const auto refusal = [&](Handle node) -> std::string {
        try {
            scene_text(w.tree, node);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    CHECK(refusal(w.tree.root()).find("root of the tree") != std::string::npos);
    const Handle host = w.add("Host", "host");
    CHECK(refusal(w.tree.child(host, "service")).find("world.host.service is a Service") !=
          std::string::npos);

    const Handle note = w.add("Note", "note");
    const Handle loose = w.tree.create(w.tree.class_named("Thing"), {}, "loose");
    w.tree.set(note, "target", loose);
    CHECK(refusal(note).find("world.note.target: refers to (detached loose)") == 0);
    w.tree.destroy(loose);
    CHECK(refusal(note) == "");
    CHECK(w.tree.get(w.copy(note, "note_2"), "target") == Value(Handle{}));

    const Handle thing = w.add("Thing", "thing");
    w.things[w.tree.row(thing)].position[1] = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal(thing) == "world.thing.position: a file cannot hold NaN");

    const Handle odd = w.add("Object", "caf\xe9");
    CHECK(refusal(odd).find("not UTF-8") != std::string::npos);
    CHECK_THROWS_AS(scene_text(w.tree, loose), Error);

    Handle deep = w.add("Object", "deep");
    const Handle top = deep;
    for (int i = 1; i < 400; ++i) deep = w.add("Note", deep, "in");
    CHECK(refusal(top) == "");
    CHECK(w.tree.alive(w.copy(top)));
    w.add("Note", deep, "in");
    CHECK(refusal(top).find("at most 400 instances") != std::string::npos);
}

TEST_CASE("a list of children in a section and colors beyond their range and nan are errors") {
    SceneWorld w;
    const auto [members, message] = GENERATE(table<std::string, std::string>({
        {R"("properties": {"children": []})", "\"children\" stands inside \"properties\""},
        {R"("ad_hoc": {"children": []})", "\"children\" stands inside \"ad_hoc\""},
        {R"("ad_hoc": {"tint": {"color": [2, 0, 0, 1]}})",
         "a color's channels are from 0 to 1, and 2 is not"},
        {R"("ad_hoc": {"tint": {"color": [0, -0.5, 0]}})",
         "a color's channels are from 0 to 1, and -0.5 is not"},
    }));
    CHECK_THROWS_WITH(w.load(scene(members)), contains(message));
    CHECK_THROWS_WITH(
        w.load(R"({"fettle_scene": 1, "class": "Thing", "properties": {"number": "nan"}})"),
        Catch::Matchers::EndsWith("got text \"nan\""));
}

}  // namespace load_test
