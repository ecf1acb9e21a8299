// The effect of a view: its file, and the values of its uniforms. Its pictures are tested in a
// window.

#include <catch.h>

#include <fstream>

#include <fettle/app/services.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/game_files.h>

#include <loop/effects.h>

#include "temporary_folder.h"

namespace effect_test {

using namespace fettle;
using property::Value;

namespace {

struct Shown {
    TemporaryFolder folder;
    property::GameFiles files;
    property::Assets assets{files, folder.path};
    property::Tree tree;
    app::Services services{tree, &assets};
    std::vector<std::string> problems;

    Shown() {
        services.on_effect_problem([this](const std::string& line) { problems.push_back(line); });
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder.path / name) << text;
    }
    void set(const char* path, const Value& value) { property::set(tree, path, value); }
    void add(const char* name, const Value& value) {
        tree.set_or_add(tree.child(tree.child(tree.root(), "view"), "uniforms"), name, value);
    }
    const app::Effect* now() {
        const app::Effect* const effect = services.effects().now(2);
        if (effect != nullptr) services.effects().drawn(problem);
        return effect;
    }
    std::string problem;  // of the shader
};

}  // namespace

TEST_CASE("uniforms are found in the code of a shader") {
    const auto all = app::uniforms_in(R"(#version 120
        // uniform float no;
        /* uniform vec2 neither; */ uniform float a, b = min(1.0, 2.0), c;
        uniform mediump vec4 tint;uniform vec2 far[3];
        float uniformity = 1.0; uniform int)");
    CHECK(all ==
          std::map<std::string, std::string>{
              {"a", "float"}, {"b", "float"}, {"c", "float"}, {"tint", "vec4"}, {"far", "vec2"}});
    CHECK(app::uniforms_in("").empty());
    CHECK(app::uniforms_in("uniform").empty());
    CHECK(app::uniforms_in("/* uniform float a;").empty());
    CHECK(app::uniforms_in(std::string(1'000'000, '/')).empty());
}

TEST_CASE_METHOD(Shown, "an effect has the values that its code declares") {
    CHECK(now() == nullptr);
    write("glow.frag", "uniform float strength; uniform vec3 tint; uniform bool on;");
    set("view.effect", Value("glow.frag"));
    add("strength", Value(3));
    add("tint", Value(property::Color{1, 0, 0, 1}));
    REQUIRE(now() != nullptr);
    CHECK(now()->time == 2);
    CHECK(now()->uniforms.size() == 2);
    CHECK(problems.empty());
    add("on", Value(1));
    add("strong", Value(1));
    CHECK(now()->uniforms.size() == 2);
    now();
    CHECK(problems == std::vector<std::string>{
                          "view.uniforms.on: glow.frag declares a bool, got 1",
                          "view.uniforms.strong: glow.frag declares no uniform of that name"});
}

TEST_CASE_METHOD(Shown, "a picture that an effect declares itself is reported as not there") {
    write("glow.frag", "uniform sampler2D texture; uniform float strength;");
    set("view.effect", Value("glow.frag"));
    REQUIRE(now() != nullptr);
    CHECK(problems ==
          std::vector<std::string>{"view.effect: glow.frag declares a sampler2D \"texture\", which "
                                   "has no picture; picture(point) is the color at a point, in "
                                   "pixels"});
}

TEST_CASE_METHOD(Shown, "the uniforms of an effect are not reported while its code is in error") {
    write("glow.frag", "uniform float strength");
    set("view.effect", Value("glow.frag"));
    add("strong", Value(1));
    problem = "glow.frag:1: syntax error";
    now();
    CHECK(problems == std::vector<std::string>{"view.effect: glow.frag:1: syntax error"});
    problem.clear();
    now();
    CHECK(problems.size() == 2);
}

TEST_CASE_METHOD(Shown, "an effect whose file is gone for a moment stays") {
    write("glow.frag", "one");
    set("view.effect", Value("glow.frag"));
    CHECK(now()->code == "one");
    std::filesystem::remove(folder.path / "glow.frag");
    services.renew_effect("glow.frag");
    REQUIRE(now() != nullptr);
    CHECK(now()->code == "one");
    CHECK(problems.size() == 1);
    write("glow.frag", "two");
    services.renew_effect("glow.frag");
    CHECK(now()->code == "two");
}

TEST_CASE_METHOD(Shown, "the file of an effect is read again and a missing one is reported once") {
    write("glow.frag", "one");
    set("view.effect", Value("glow.frag"));
    CHECK(now()->code == "one");
    write("glow.frag", "two");
    CHECK(now()->code == "one");
    services.renew_effect("other.frag");
    CHECK(now()->code == "one");
    services.renew_effect("glow.frag");
    CHECK(now()->code == "two");
    set("view.effect", Value("glew.frag"));
    CHECK(now() == nullptr);
    CHECK(now() == nullptr);
    CHECK(problems == std::vector<std::string>{"view.effect: there is no file \"glew.frag\" (did "
                                               "you mean \"glow.frag\"?)"});
    set("view.effect", Value(""));
    CHECK(now() == nullptr);
    CHECK(problems.size() == 1);
}

}  // namespace effect_test
