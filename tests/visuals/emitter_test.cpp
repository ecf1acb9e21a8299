// Emitters: how particles begin, move, end, are drawn and saved.

#include <catch.h>

#include <cmath>

#include "gallery.h"

namespace emitter_test {

using namespace fettle::visuals::test;

namespace {

struct Sparks : Gallery {
    Handle emitter(std::vector<std::pair<std::string, Value>> values = {}, Handle parent = {}) {
        return make("Emitter", std::move(values), parent);
    }
    std::int64_t count(Handle of) { return tree.get(of, "count").integer(); }
    static Vec2 center(const Drawn& d) { return 0.5 * (d.lower_right + d.upper_left); }
};

}  // namespace

TEST_CASE_METHOD(Sparks, "particles begin at the rate and end after their life") {
    const Handle e = emitter({{"rate", 60.0}, {"lifetime", 0.5}, {"randomness", 0.0}});
    step(10);
    CHECK(count(e) == 10);
    step(100);
    CHECK(std::abs(count(e) - 30) <= 1);
    tree.set(e, "playing", Value(false));
    step(31);
    CHECK(count(e) == 0);
    CHECK(draw().empty());
}

TEST_CASE_METHOD(Sparks, "a rate of less than one particle a step makes particles in time") {
    const Handle e = emitter({{"rate", 1.0}, {"lifetime", 100.0}});
    step(59);
    CHECK(count(e) == 0);
    step(2);
    CHECK(count(e) == 1);
    step(600);
    CHECK(count(e) == 11);
}

TEST_CASE_METHOD(Sparks, "a burst begins at once and its end is an event") {
    const Handle e = emitter({{"rate", 0.0}, {"burst", 20}, {"lifetime", 0.2}});
    int ended = 0;
    tree.on(e, *tree.class_of(e).event("finished"), [&](const Occurrence&) { ++ended; });
    step(1);
    CHECK(count(e) == 20);
    step(30);
    CHECK(count(e) == 0);
    CHECK(ended == 1);
    tree.call(e, "emit", {Value(5)});
    step(1);
    CHECK(count(e) == 5);
    step(30);
    CHECK(ended == 2);
    tree.set(e, "playing", Value(false));
    step(1);
    tree.set(e, "playing", Value(true));
    step(1);
    CHECK(count(e) == 20);
    tree.call(e, "clear", {});
    CHECK(count(e) == 0);
}

TEST_CASE_METHOD(Sparks, "an emitter has no more particles than its limit") {
    const Handle e = emitter({{"rate", 1e6}, {"burst", 50}, {"limit", 30}, {"lifetime", 9.0}});
    step(3);
    CHECK(count(e) == 30);
    tree.set(e, "limit", Value(7));
    step(1);
    CHECK(count(e) == 7);
    tree.call(e, "emit", {Value(std::int64_t{1} << 60)});
    tree.call(e, "emit", {Value(-3)});
    step(1);
    CHECK(count(e) == 7);
}

TEST_CASE_METHOD(Sparks, "all emitters together have a limit") {
    for (int i = 0; i < 4; ++i)
        emitter({{"rate", 0.0}, {"burst", 200'000}, {"limit", 200'000}, {"lifetime", 9.0}});
    step(2);
    std::int64_t all = 0;
    for (const Handle each : tree.children(tree.root()))
        if (tree.class_of(each).name() == "Emitter") all += count(each);
    CHECK(all == 500'000);
}

TEST_CASE_METHOD(Sparks, "particles fly in the direction of the emitter") {
    const Handle e = emitter({{"rate", 0.0},
                              {"burst", 1},
                              {"speed", 3.0},
                              {"spread", 0.0},
                              {"randomness", 0.0},
                              {"lifetime", 10.0},
                              {"angle", std::acos(-1.0) / 2},
                              {"position", Vec2(2, 1)}});
    step(1);
    CHECK(near(center(draw().at(0)), {2, 1}, 1e-5));
    step(60);
    CHECK(near(center(draw().at(0)), {2, 4}, 1e-4));
    tree.set(e, "gravity", Value(Vec2(2, 0)));
    step(60);
    const Vec2 after = center(draw().at(0));
    CHECK(after.x == Approx(3).margin(0.05));
    CHECK(after.y == Approx(7).margin(0.01));
    tree.set(e, "damping", Value(1e4));
    tree.set(e, "gravity", Value(Vec2(0, 0)));
    step(60);
    CHECK(near(center(draw().at(0)), after, 0.1));
}

TEST_CASE_METHOD(Sparks, "size and color of a particle change over its life") {
    emitter({{"rate", 0.0},
             {"burst", 1},
             {"speed", 0.0},
             {"randomness", 0.0},
             {"lifetime", 1.0},
             {"size", Value(List{0.0, 2.0, 0.0})},
             {"color", Value(List{Color{1, 0, 0, 1}, Color{0, 0, 1, 0.5f}})}});
    step(31);  // the first step lets it begin
    const Drawn middle = draw().at(0);
    CHECK((middle.lower_right - middle.lower_left).length() == Approx(2).margin(0.05));
    CHECK(middle.color.r == Approx(0.5).margin(0.02));
    CHECK(middle.color.a == Approx(0.75).margin(0.02));
}

TEST_CASE_METHOD(Sparks, "particles stay in the world or move with the emitter") {
    for (const char* space : {"world", "local"}) {
        const Handle e = emitter(
            {{"rate", 0.0}, {"burst", 1}, {"speed", 0.0}, {"lifetime", 10.0}, {"space", space}});
        step(1);
        tree.set(e, "position", Value(Vec2(5, 0)));
        step(1);
        const double x = center(draw().at(0)).x;
        CHECK(x == Approx(std::string(space) == "world" ? 0 : 5));
        tree.destroy(e);
    }
}

TEST_CASE_METHOD(Sparks, "a moving emitter leaves an even trail") {
    const Handle e = emitter({{"rate", 240.0}, {"speed", 0.0}, {"lifetime", 10.0}});
    step(1);
    tree.call(e, "clear", {});
    tree.set(e, "position", Value(Vec2(4, 0)));
    step(1);
    const auto drawn = draw();
    REQUIRE(drawn.size() == 4);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(center(drawn[i]).x == Approx(1.0 + static_cast<double>(i)));
}

TEST_CASE_METHOD(Sparks, "particles begin within the shape of the emitter") {
    for (const char* shape : {"point", "circle", "ring", "box"}) {
        const Handle e = emitter({{"rate", 0.0},
                                  {"burst", 500},
                                  {"speed", 0.0},
                                  {"shape", shape},
                                  {"area", Vec2(4, 2)}});
        step(1);
        Vec2 lower(0, 0), upper(0, 0);
        double nearest = 10;
        for (const Drawn& d : draw()) {
            lower = lower.min(center(d));
            upper = upper.max(center(d));
            nearest = std::min(nearest, center(d).length());
        }
        INFO(shape);
        const bool is_point = std::string(shape) == "point";
        CHECK(near(upper, is_point ? Vec2(0, 0) : Vec2(2, 1), 0.2));
        CHECK(near(lower, is_point ? Vec2(0, 0) : Vec2(-2, -1), 0.2));
        CHECK((nearest > 0.9) == (std::string(shape) == "ring"));
        tree.destroy(e);
    }
}

TEST_CASE_METHOD(Sparks, "equal seeds give equal particles") {
    const auto places = [&](int seed) {
        const Handle e = emitter({{"burst", 5}, {"seed", seed}});
        step(20);
        std::vector<Vec2> all;
        for (const Drawn& d : draw()) all.push_back(center(d));
        tree.destroy(e);
        return all;
    };
    CHECK(places(1) == places(1));
    CHECK(places(1) != places(2));
}

TEST_CASE_METHOD(Sparks, "a restored emitter goes on in the same way") {
    const Handle e = emitter({{"rate", 500.0}, {"rotation", 2.0}, {"gravity", Vec2(0, -9)}});
    emitter({{"rate", 30.0}});
    const Handle gone = emitter();
    step(20);
    tree.destroy(gone);
    const Snapshot then = Snapshot::from_bytes(tree.snapshot().to_bytes());
    const auto play = [&] {
        step(30);
        return visuals.hash();
    };
    const std::uint64_t first = play();
    tree.destroy(e);
    emitter({{"rate", 999.0}});
    step(3);
    tree.restore(then);
    CHECK(play() == first);
    CHECK(draw().size() > 100);
}

TEST_CASE_METHOD(Sparks, "damaged bytes of particles are refused") {
    emitter({{"burst", 3}});
    step(2);
    const std::uint64_t before = visuals.hash();
    std::vector<std::byte> bytes;
    ByteWriter writer(bytes);
    visuals.save(writer);
    // No instance is being restored, so no row has one.
    ByteReader whole(bytes);
    CHECK_THROWS_AS(visuals.restore(whole, nullptr), Error);
    for (std::size_t size = 0; size < bytes.size(); size += 3) {
        ByteReader part(std::span<const std::byte>(bytes).first(size));
        CHECK_THROWS_AS(visuals.restore(part, nullptr), Error);
    }
    CHECK(visuals.hash() == before);
}

TEST_CASE_METHOD(Sparks, "particles have the picture and the blend mode of the emitter") {
    emitter({{"burst", 1},
             {"rate", 0.0},
             {"image", "hero.tga"},
             {"blend", "add"},
             {"size", Value(List{1.0})},
             {"randomness", 0.0}});
    step(1);
    const Drawn d = draw().at(0);
    CHECK(d.area.width == 8);
    CHECK(d.blend == Blend::add);
    CHECK((d.lower_right - d.lower_left).length() == Approx(2));
    CHECK((d.upper_left - d.lower_left).length() == Approx(1));
}

TEST_CASE_METHOD(Sparks, "a missing image is reported once also if nothing is drawn") {
    const Handle e = emitter({{"rate", 0.0}, {"image", "hreo.tga"}});
    step(2);
    const std::vector<std::string> expected{
        tree.path(e) + ".image: there is no file \"hreo.tga\" (did you mean \"hero.tga\"?)"};
    CHECK(problems == expected);
    tree.set(e, "image", Value("hero.tga"));
    tree.set(e, "rate", Value(60.0));
    step(1);
    CHECK(draw().at(0).area.width == 8);
    tree.set(e, "image", Value(""));
    CHECK(draw().at(0).area.width != 8);
    CHECK(problems == expected);
}

TEST_CASE_METHOD(Sparks, "particles in a screen layer move in pixels") {
    const Handle layer = make("Layer", {{"space", "screen"}});
    emitter({{"burst", 1},
             {"rate", 0.0},
             {"position", Vec2(100, 50)},
             {"angle", std::acos(-1.0) / 2},
             {"spread", 0.0},
             {"speed", 60.0},
             {"randomness", 0.0}},
            layer);
    step(11);
    const Drawn d = draw().at(0);
    CHECK(d.on_screen);
    // Upwards, as seen.
    CHECK(near(center(d), {100, 40}, 0.01));
}

TEST_CASE_METHOD(Sparks, "a particle is not drawn before it begins") {
    const Handle e = emitter({{"rate", 0.0},
                              {"position", Vec2(3, 0)},
                              {"spread", 0.0},
                              {"speed", 30.0},
                              {"randomness", 0.0}});
    step(1);
    tree.call(e, "emit", {Value(4)});
    step(1);
    CHECK(count(e) == 4);
    CHECK(draw({}, 0.25).empty());
    CHECK(draw({}, 1).size() == 4);
    step(1);
    for (const Drawn& d : draw({}, 0.25)) CHECK(center(d).x > 3);
}

TEST_CASE_METHOD(Sparks, "particles begin at the emitter when it comes into the world") {
    const Handle e = emitter({{"rate", 600.0},
                              {"space", "local"},
                              {"position", Vec2(50, 0)},
                              {"speed", 0.0},
                              {"randomness", 0.0}});
    step(3);
    tree.set(e, "space", Value("world"));
    tree.call(e, "clear", {});
    step(1);
    REQUIRE(count(e) > 0);
    for (const Drawn& d : draw()) CHECK(center(d).x > 49);
}

}  // namespace emitter_test
