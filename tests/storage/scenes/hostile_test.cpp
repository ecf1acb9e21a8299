// Hostile files: no crash, no endless loop, no change of the tree.

#include <random>

#include "catch.h"
#include "scene_world.h"

namespace hostile_test {

using namespace scene_test;

namespace {

std::string sample(SceneWorld& w) {
    const Handle scene = w.add("Object", "scene");
    const Handle thing = w.add("Thing", scene, "my ball");
    w.tree.set(thing, "position", Vec2(0.1, -infinity));
    w.tree.set(thing, "tint", Color{0.1f, 0.2f, 0.3f, 1});
    w.tree.set_or_add(thing, "bytes", "caf\xe9");
    w.tree.set_or_add(thing, "list", List{1, 2.5, Vec2(1, 2), "x", thing});
    const Handle note = w.add("Note", scene, "note");
    w.tree.set(note, "thing", thing);
    w.tree.set(note, "text", "a \"quoted\" ünï \\ text");
    w.tree.set_or_add(note, unknown_keys_property, "{\"properties\": {\"later\": [1, {}]}}");
    const std::string text = scene_text(w.tree, scene);
    w.tree.destroy(scene);
    w.tree.barrier();
    return text;
}

/// Loads the text; a loaded scene is saved and removed again.
bool loads(SceneWorld& w, const std::string& text) {
    try {
        const Handle top = w.load(text);
        const std::string saved = w.text(top);
        w.tree.destroy(top);
        return !saved.empty();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

TEST_CASE("a file cut off at any byte is refused") {
    SceneWorld w;
    const std::string text = sample(w);
    REQUIRE(loads(w, text));
    const std::size_t size = w.tree.size();
    for (std::size_t length = 0; length + 2 < text.size(); ++length) {
        CAPTURE(length);
        CHECK_FALSE(loads(w, text.substr(0, length)));
        CHECK(w.tree.size() == size);
    }
}

TEST_CASE("random damage to a file does no harm") {
    SceneWorld w;
    const std::string text = sample(w);
    const std::size_t size = w.tree.size();
    std::mt19937 random(7);
    const std::vector<std::string> pieces = {"{",
                                             "}",
                                             "[",
                                             "]",
                                             "\"",
                                             ",",
                                             ":",
                                             "null",
                                             "true",
                                             "1e308",
                                             "-",
                                             "/*",
                                             "//",
                                             "\\u",
                                             "\xff",
                                             "\"inf\"",
                                             "{\"reference\": \".\"}",
                                             "1e-400",
                                             "99999999999999999999999",
                                             "\n"};
    std::size_t loaded = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string damaged = text;
        for (unsigned i = 0; i <= random() % 4; ++i) {
            const std::size_t at = random() % damaged.size();
            switch (random() % 4) {
                case 0:
                    damaged[at] = static_cast<char>(random());
                    break;
                case 1:
                    damaged.erase(at, random() % 20);
                    break;
                case 2:
                    damaged.insert(at, pieces[random() % pieces.size()]);
                    break;
                default:
                    damaged.insert(at, damaged.substr(random() % damaged.size(), 30));
            }
        }
        loaded += loads(w, damaged);
        REQUIRE(w.tree.size() == size);
    }
    CHECK(loaded > 0);  // some damage is valid
}

TEST_CASE("random bytes are refused as a scene") {
    SceneWorld w;
    std::mt19937 random(11);
    for (int round = 0; round < 500; ++round) {
        std::string bytes;
        for (unsigned i = 0; i < random() % 300; ++i) bytes += static_cast<char>(random());
        CHECK_FALSE(loads(w, bytes));
    }
}

TEST_CASE("deep nesting is refused without harm") {
    SceneWorld w;
    const std::string head = "{\"fettle_scene\": 1, \"class\": \"Object\", \"x\": ";
    for (const char* brackets : {"[]", "{}"}) {
        std::string deep(5'000'000, brackets[0]);
        if (brackets[0] == '{') {
            deep.clear();
            for (int i = 0; i < 1'000'000; ++i) deep += "{\"a\":";
        }
        CHECK(w.refusal(head + deep).find("nested deeper than 1000 levels") != std::string::npos);
    }
    std::string instances = "{\"fettle_scene\": 1, \"class\": \"Object\"";
    for (int i = 0; i < 10000; ++i) instances += ", \"children\": [{\"class\": \"Object\"";
    CHECK(w.refusal(instances).find("nested deeper than 1000 levels") != std::string::npos);
    const auto lists = [&](std::size_t depth) {
        return head.substr(0, head.size() - 5) + "\"ad_hoc\": {\"x\": " + std::string(depth, '[') +
               std::string(depth, ']') + "}}";
    };
    CHECK(loads(w, lists(64)));
    CHECK(w.refusal(lists(65)).find("more than 64 deep") != std::string::npos);
    CHECK(w.refusal(lists(900)).find("more than 64 deep") != std::string::npos);
}

TEST_CASE("huge numbers and texts and arrays are read or refused") {
    SceneWorld w;
    const auto with = [](const std::string& value) {
        return "{\"fettle_scene\": 1, \"class\": \"Object\", \"ad_hoc\": {\"x\": " + value + "}}";
    };
    CHECK_FALSE(loads(w, with("1e400")));
    CHECK_FALSE(loads(w, with(std::string(100000, '9'))));
    CHECK(loads(w, with("0." + std::string(100000, '3'))));
    CHECK(loads(w, with("1e-99999")));
    CHECK(loads(w, with("18446744073709551615")));
    CHECK(loads(w, with("\"" + std::string(10'000'000, 'x') + "\"")));
    std::string many = "[0";
    for (int i = 0; i < 1'000'000; ++i) many += ",0";
    CHECK(loads(w, with(many + "]")));
    CHECK(w.refusal(std::string(65 << 20, ' ')).find("larger than 64 MB") != std::string::npos);
}

TEST_CASE("a file with many keys is read in reasonable time") {
    SceneWorld w;
    std::string text = "{\"fettle_scene\": 1, \"class\": \"Object\", \"ad_hoc\": {\"k0\": 0";
    for (int i = 1; i < 50'000; ++i) text += ", \"k" + std::to_string(i) + "\": 0";
    CHECK(loads(w, text + "}}"));
    CHECK(w.refusal(text + ", \"k1\": 1}}").find("was given before") != std::string::npos);
}

}  // namespace hostile_test
