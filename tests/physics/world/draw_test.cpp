#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "catch.h"
#include "scenes.h"

namespace draw_test {

// A world draws itself with the functions of a host.

using namespace scenes;

namespace {

class Sheet : public DebugDraw {
  public:
    struct Outline {
        std::vector<Vec2> points;
        bool closed;
        uint32_t color;
    };
    struct Round {
        Vec2 center;
        float radius, angle;
        uint32_t color;
    };
    std::vector<Outline> polygons;
    std::vector<Round> circles;
    std::vector<std::pair<Vec2, Vec2>> segments;
    std::vector<Vec2> points;

    void polygon(std::span<const Position> outline, bool closed, uint32_t color) override {
        polygons.push_back({{outline.begin(), outline.end()}, closed, color});
    }
    void circle(const Position& center, float radius, float angle, uint32_t color) override {
        circles.push_back({Vec2(center), radius, angle, color});
    }
    void segment(const Position& from, const Position& to, uint32_t) override {
        segments.push_back({Vec2(from), Vec2(to)});
    }
    void point(const Position& at, uint32_t) override { points.push_back(Vec2(at)); }
};

}  // namespace

TEST_CASE("every geometry is drawn where it is") {
    World world;
    Body body = world.create_body({.position = {10, 20}, .angle = 1.5707963f});
    body.add(Circle{.radius = 2, .center = {1, 0}});
    body.add(Box{.width = 4, .height = 2});
    body.add(Box{.width = 4, .height = 2, .rounding = 0.5f});
    body.add(Ellipse{.radius_x = 3, .radius_y = 1});
    body.add(Concave{.vertices = {{0, 0}, {2, 0}, {1, 0.5f}, {1, 2}}});
    body.add(Chain{.points = {{0, 0}, {1, 0}, {2, 1}}});
    Sheet sheet;
    world.draw(sheet);
    REQUIRE(sheet.circles.size() == 1);
    REQUIRE((sheet.circles[0].center - Vec2(10, 21)).length() < 1e-4f);
    REQUIRE(sheet.circles[0].radius == 2);
    REQUIRE(sheet.circles[0].angle == Approx(1.5707963));
    REQUIRE(sheet.polygons.size() == 5);
    const auto has = [&](size_t which, const Vec2& corner) {
        return std::ranges::any_of(sheet.polygons[which].points,
                                   [&](const Vec2& p) { return (p - corner).length() < 1e-4f; });
    };
    REQUIRE(has(0, {9, 18}));
    REQUIRE_FALSE(has(1, {9, 18}));
    REQUIRE(has(1, {9, 18.5f}));
    REQUIRE(sheet.polygons[1].points.size() > 12);
    REQUIRE(has(2, {10, 23}));
    REQUIRE(has(3, {9.5f, 21}));
    REQUIRE(sheet.polygons[3].closed);
    REQUIRE(has(4, {9, 22}));
    REQUIRE_FALSE(sheet.polygons[4].closed);
}

TEST_CASE("static kinematic awake and sleeping bodies and sensors have different colors") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    world.create_body({.type = BodyType::kinematic_body, .position = {9, 9}}).add(Box{});
    world.create_body({.position = {5, 50}, .gravity_scale = 0}).add(Box{}, {.sensor = true});
    const auto colors = [&] {
        Sheet sheet;
        world.draw(sheet);
        std::vector<uint32_t> found;
        for (const auto& polygon : sheet.polygons) found.push_back(polygon.color);
        return found;
    };
    const auto awake = colors();
    REQUIRE(awake.size() == 4);
    for (size_t i = 0; i < 4; ++i)
        for (size_t k = 0; k < i; ++k) REQUIRE(awake[i] != awake[k]);
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    REQUIRE(colors()[1] != awake[1]);
    REQUIRE(colors()[0] == awake[0]);

    struct Red : Sheet {
        uint32_t color_of(const Body&, const Shape&) const override { return 0xff0000; }
    } red;
    world.draw(red);
    for (const auto& polygon : red.polygons) REQUIRE(polygon.color == 0xff0000);
}

TEST_CASE("options choose what is drawn and where and when") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.6f}), far = add_box(world, {300, 0});
    world.create_distance_joint({.body_a = box.id(), .anchor_b = {0, 3}});
    run(world, 1.0f);
    Sheet nothing;
    world.draw(nothing, {.shapes = false, .joints = false});
    REQUIRE((nothing.polygons.empty() && nothing.points.empty() && nothing.segments.empty()));
    Sheet joints;
    world.draw(joints, {.shapes = false});
    REQUIRE(joints.points.size() == 2);
    REQUIRE(joints.segments.size() == 2);
    Sheet marks;
    world.draw(marks, {.shapes = false, .joints = false, .boxes = true, .centers = true});
    REQUIRE(marks.polygons.size() == 3);
    REQUIRE(marks.points.size() == 3);
    Sheet near;
    world.draw(near, {.region = Aabb{{-5, -5}, {5, 5}}});
    REQUIRE(near.polygons.size() == 2);
    Sheet early;
    far.set_velocity({60, 0});
    world.step(frame);
    world.draw(early, {.joints = false, .fraction = 0});
    const auto left_of = [](const Sheet& sheet) { return sheet.polygons[2].points[0].x; };
    Sheet late;
    world.draw(late, {.joints = false});
    REQUIRE(left_of(late) - left_of(early) == Approx(1).margin(0.01));
    REQUIRE_THROWS_WITH(world.draw(late, {.fraction = NAN}), contains("fraction"));
}

TEST_CASE("contacts are drawn with their normals") {
    World world;
    add_floor(world);
    add_box(world, {0, 0.5f});
    run(world, 0.3f);
    Sheet sheet;
    world.draw(sheet, {.shapes = false, .contacts = true});
    REQUIRE(sheet.points.size() == 2);
    for (const auto& [from, to] : sheet.segments) {
        REQUIRE((to - from).length() == Approx(0.2).margin(1e-4));
        REQUIRE(std::fabs(from.y) < 0.02f);
    }
}

TEST_CASE("a function that draws and destroys the world ends the drawing with an error") {
    struct Destroyer : Sheet {
        std::unique_ptr<World>* world = nullptr;
        mutable int calls = 0;
        int last = 0;
        void act() const {
            if (++calls == last) world->reset();
        }
        void polygon(std::span<const Position>, bool, uint32_t) override { act(); }
        void circle(const Position&, float, float, uint32_t) override { act(); }
        void segment(const Position&, const Position&, uint32_t) override { act(); }
        void point(const Position&, uint32_t) override { act(); }
        uint32_t color_of(const Body&, const Shape&) const override {
            act();
            return 0;
        }
    };
    int last = 0;
    for (bool destroyed = true; destroyed;) {
        auto world = std::make_unique<World>();
        Body floor = add_floor(*world);
        Body ball = add_ball(*world, {0, 0.5f});
        world->create_weld_joint({.body_a = floor.id(), .body_b = ball.id(), .collide = true});
        run(*world, 0.1f);
        Destroyer target;
        target.world = &world;
        target.last = ++last;
        const DebugDrawOptions everything = {.contacts = true, .boxes = true, .centers = true};
        try {
            world->draw(target, everything);
            destroyed = false;
        } catch (const Locked& error) {
            REQUIRE_THAT(error.what(), contains("the world was destroyed inside a function of"));
        }
        REQUIRE((world == nullptr) == destroyed);
        REQUIRE(target.calls == last - (destroyed ? 0 : 1));
    }
    REQUIRE(last > 12);
}

TEST_CASE("functions that draw may read and must not edit") {
    World world;
    Body body = add_box(world, {0, 0});
    struct Editor : Sheet {
        Body body;
        std::string refused;
        void polygon(std::span<const Position>, bool, uint32_t) override {
            (void)body.position();
            try {
                body.set_position({1, 1});
            } catch (const Locked& error) {
                refused = error.what();
            }
            throw std::runtime_error("no paper");
        }
    } editor;
    editor.body = body;
    REQUIRE_THROWS_WITH(world.draw(editor), "no paper");
    REQUIRE_THAT(editor.refused, contains("inside a function of the DebugDraw (World::draw)"));
    REQUIRE(body.position() == Vec2{});
    REQUIRE_NOTHROW(body.set_position({1, 1}));
}

}  // namespace draw_test
