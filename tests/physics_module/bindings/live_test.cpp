// Edits of a running game through the tree, by path and by handle.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fettle/property/observer.h>

#include "catch.h"
#include "game.h"

namespace live_test {

using namespace fettle::physics_module::testing;
using namespace fettle;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A slope of 20° with a box at rest on it; it slides if the friction is less than 0.36.
struct Slope : Game {
    Handle slope = make("Body", world(), {{"type", "static"}, {"angle", -0.349}});
    Handle crate = make("Body", world(), "crate");

    Slope() {
        make("Box", slope, {{"width", 40}, {"height", 2}});
        make("Box", crate);
        // On the upper side: 1 m of slope and half a box from the middle.
        set(crate, "angle", -0.349);
        set(crate, "position", Vec2(1.5 * std::sin(0.349), 1.5 * std::cos(0.349)));
    }
};

std::vector<Vec2> points_of(const Value& list) {
    std::vector<Vec2> points;
    for (const Value& v : list.list()) points.push_back(v.vec2());
    return points;
}

/// Records the writes that are reported in batches.
class Batches : public property::Observer {
  public:
    explicit Batches(property::Tree& tree) : tree_(tree) { tree_.observe(*this); }
    ~Batches() override { tree_.unobserve(*this); }
    void wrote_plain(const property::PlainWrites& writes) override {
        for (const property::PlainWrite& write : writes.list)
            if (write.instance)
                reported.push_back(write.property->name + " " + write_text(write.x));
    }
    void wrote(Handle, const property::Property& of, const Value& now) override {
        reported.push_back(of.name + " " + write_text(now.number()));
    }
    std::vector<std::string> reported;

  private:
    static std::string write_text(double x) { return property::number_text(x); }
    property::Tree& tree_;
};

bool has_point(const std::vector<Vec2>& points, const Vec2& wanted) {
    for (const Vec2& p : points)
        if ((p - wanted).length() < 1e-5) return true;
    return false;
}

}  // namespace

TEST_CASE_METHOD(Slope, "a body resting on a slope slides when its friction is set to 0") {
    step(20);
    REQUIRE(awake(crate));
    const double before = x(crate);
    property::set(tree, "world.crate.box_1.friction", 0);
    step(20);
    CHECK(x(crate) > before + 0.1);
}

TEST_CASE_METHOD(Slope, "a body sleeping on a slope slides when its friction is set to 0") {
    REQUIRE(falls_asleep(crate));
    const double before = x(crate);
    property::set(tree, "world.crate.box_1.friction", 0);
    step(1);
    CHECK(awake(crate));
    CHECK(vec(crate, "velocity").x > 0);
    step(19);
    CHECK(x(crate) > before + 0.1);
}

TEST_CASE_METHOD(Slope, "a body sleeping on a slope slides when the friction of the slope is set") {
    REQUIRE(falls_asleep(crate));
    const double before = x(crate);
    set(shape_of(slope), "friction", 0);
    step(20);
    CHECK(x(crate) > before + 0.1);
}

TEST_CASE_METHOD(Game, "sleeping bodies wake when gravity changes") {
    floor();
    const Handle ball = body("Circle", {0, 0.5});
    REQUIRE(falls_asleep(ball));
    property::set(tree, "world.gravity", Vec2(3, -10));
    step();
    CHECK(awake(ball));
    step(30);
    CHECK(x(ball) > 0.2);
}

TEST_CASE_METHOD(Game, "a body on a support falls when the support is deleted") {
    const Handle support = floor();
    const Handle lower = body("Box", {0, 0.5});
    const Handle upper = body("Box", {0, 1.5});
    REQUIRE(falls_asleep(upper));
    REQUIRE_FALSE(awake(lower));
    tree.destroy(support);
    step(30);
    CHECK(y(lower) < -0.5);
    CHECK(y(upper) < 0.5);
}

TEST_CASE_METHOD(Game, "a body on a support falls when only the shape of the support is deleted") {
    const Handle support = floor();
    const Handle crate = body("Box", {0, 0.5});
    REQUIRE(falls_asleep(crate));
    tree.destroy(shape_of(support));
    step(30);
    CHECK(y(crate) < -0.5);
}

TEST_CASE_METHOD(Game, "a body on a support falls when the support is moved") {
    const Handle support = floor();
    const Handle crate = body("Box", {0, 0.5});
    REQUIRE(falls_asleep(crate));
    set(support, "position", Vec2(100, -1));
    step(30);
    CHECK(y(crate) < -0.5);
}

TEST_CASE_METHOD(Game, "a body on a support falls when the support leaves the world") {
    const Handle support = floor();
    const Handle crate = body("Box", {0, 0.5});
    REQUIRE(falls_asleep(crate));
    tree.move(support, {});
    step(30);
    CHECK(y(crate) < -0.5);
}

TEST_CASE_METHOD(
    Game,
    "a vertex added to a rotated polygon moves no other vertex and updates everything derived") {
    const Handle stone = make("Body", world(), "stone");
    const Handle hull = make("Polygon", stone, "hull");
    property::set(tree, "world.stone.hull.vertices",
                  List{Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(0, 1)});
    set(stone, "gravity_scale", 0);
    set(stone, "angle", 0.7);
    set(stone, "position", Vec2(3, 4));
    step();
    const double mass = number(stone, "mass"), inertia = number(stone, "inertia");
    const Vec2 center = vec(stone, "center");
    const std::vector<Vec2> before = points_of(get(hull, "world_vertices"));
    const List box = get(hull, "aabb").list();
    REQUIRE(mass == Approx(2));
    REQUIRE((center - Vec2(1, 0.5)).length() < 1e-5);

    // An index one past the end of the list appends.
    property::set(tree, "world.stone.hull.vertices[5]", Vec2(1, 3));
    const std::vector<Vec2> after = points_of(get(hull, "world_vertices"));
    CHECK(after.size() == 5);
    for (const Vec2& corner : before) CHECK(has_point(after, corner));
    const Vec2 tip = std::get<Value>(tree.call(stone, "to_world", {Vec2(1, 3)})).vec2();
    CHECK(has_point(after, tip));
    CHECK(number(hull, "area") == Approx(4));
    CHECK(number(stone, "mass") == Approx(4));
    // A 2 × 1 rectangle with a triangle of height 2 on top, whose centroid is at (1, 5/3).
    CHECK((vec(stone, "center") - Vec2(1, (0.5 * 2 + 5.0 / 3 * 2) / 4)).length() < 1e-5);
    CHECK(number(stone, "inertia") > inertia);
    CHECK(get(hull, "aabb").list()[1].vec2().y > box[1].vec2().y);
    CHECK(vec(stone, "position") == Vec2(3, 4));
    step();
    CHECK((vec(stone, "position") - Vec2(3, 4)).length() < 1e-6);
    CHECK_FALSE(physics.world(world()).validate());
}

TEST_CASE_METHOD(Game, "ten edits of a polygon cause one rebuild") {
    const Handle stone = body("Polygon", {0, 3});
    const Handle hull = shape_of(stone);
    step();
    const auto rebuilds = [&] {
        return std::pair(physics.shape(hull).rebuilds(), physics.body(stone).rebuilds());
    };
    const auto before = rebuilds();
    for (int i = 1; i <= 10; ++i)
        set(hull, "vertices", List{Vec2(0, 0), Vec2(1 + 0.1 * i, 0), Vec2(0, 1)});
    CHECK(rebuilds() == before);
    step();
    CHECK(rebuilds() == std::pair(before.first + 1, before.second + 1));
    step(10);
    CHECK(rebuilds() == std::pair(before.first + 1, before.second + 1));
    CHECK(number(stone, "mass") == Approx(1.0));
}

TEST_CASE_METHOD(Game, "a polygon stays convex after any write") {
    const Handle hull = shape_of(body("Polygon", {0, 3}));
    set(hull, "vertices", List{Vec2(0, 0), Vec2(4, 0), Vec2(2, 1), Vec2(4, 4), Vec2(0, 4)});
    CHECK(points_of(get(hull, "vertices")).size() == 4);  // (2, 1) is inside the hull
    tree.call(hull, "add_vertex", {Vec2(1, 1)});
    CHECK(points_of(get(hull, "vertices")).size() == 4);
    tree.call(hull, "add_vertex", {Vec2(6, 2)});
    CHECK(points_of(get(hull, "vertices")).size() == 5);
    CHECK(number(hull, "area") == Approx(20));
}

TEST_CASE_METHOD(Game, "vertices without a hull are refused with a reason and nothing changes") {
    const Handle hull = shape_of(body("Polygon", {0, 3}));
    const Value before = get(hull, "vertices");
    const List in_a_line = {Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)};
    CHECK_THROWS_WITH(set(hull, "vertices", in_a_line),
                      contains("world.body_1.polygon_1.vertices") && contains("line"));
    CHECK_THROWS_WITH(set(hull, "vertices", List{Vec2(0, 0), Vec2(1, 1)}), contains("three"));
    CHECK_THROWS_AS(set(hull, "vertices", List{}), property::Error);
    CHECK_THROWS_WITH(set(hull, "vertices", List{Vec2(0, 0), 5, Vec2(2, 2)}), contains("vec2"));
    CHECK(get(hull, "vertices") == before);
}

TEST_CASE_METHOD(Game, "a radius edited during flight changes the mass and the place of landing") {
    floor();
    const Handle ball = body("Circle", {0, 3});
    step(10);
    set(shape_of(ball), "radius", 1);
    CHECK(number(ball, "mass") == Approx(3.14159).epsilon(1e-4));
    step(120);
    CHECK(y(ball) == Approx(1).margin(0.01));
}

TEST_CASE_METHOD(Game, "an edit of the density changes mass and inertia by the same factor") {
    const Handle crate = body("Box", {0, 3});
    const double inertia = number(crate, "inertia");
    set(shape_of(crate), "density", 4);
    CHECK(number(crate, "mass") == Approx(4));
    CHECK(number(crate, "inertia") == Approx(4 * inertia));
}

TEST_CASE_METHOD(Game, "an overridden mass stays until nil computes it again") {
    const Handle crate = body("Box", {0, 3});
    set(crate, "mass", 7);
    set(shape_of(crate), "density", 2);
    CHECK(number(crate, "mass") == 7);
    CHECK(tree.overridden(crate, tree.property(crate, "mass")));
    set(crate, "mass", Value());
    CHECK(number(crate, "mass") == 2);
    CHECK_FALSE(tree.overridden(crate, tree.property(crate, "mass")));
    // A value that equals the computed one is an override, too.
    set(crate, "mass", 2);
    set(shape_of(crate), "density", 3);
    CHECK(number(crate, "mass") == 2);
}

TEST_CASE_METHOD(Game, "a body whose mass becomes infinite stops falling") {
    const Handle crate = body("Box", {0, 30});
    step(30);
    REQUIRE(vec(crate, "velocity").y < -4);
    set(crate, "mass", inf);
    const double height = y(crate);
    step(30);
    CHECK(y(crate) == height);
    CHECK(number(crate, "mass") == inf);
    CHECK(get(crate, "type").text() == "dynamic");
}

TEST_CASE_METHOD(Game, "a body of infinite mass falls again when its mass is finite") {
    const Handle crate = body("Box", {0, 30});
    set(crate, "mass", inf);
    step(30);
    REQUIRE(y(crate) == 30);
    SECTION("a number") {
        set(crate, "mass", 3);
    }
    SECTION("nil") {
        set(crate, "mass", Value());
    }
    step(30);
    CHECK(y(crate) < 29);
    CHECK(std::isfinite(number(crate, "mass")));
}

TEST_CASE_METHOD(Game, "a body on a body whose mass becomes infinite stays there") {
    floor();
    const Handle lower = body("Box", {0, 0.5});
    const Handle upper = body("Box", {0, 1.5});
    REQUIRE(falls_asleep(upper));
    set(lower, "mass", inf);
    step(60);
    CHECK(y(upper) == Approx(1.5).margin(0.02));
    set(lower, "position", Vec2(10, 0.5));
    step(60);
    CHECK(y(upper) == Approx(0.5).margin(0.02));
}

TEST_CASE_METHOD(Game, "the type of a body may change at any time") {
    const Handle crate = body("Box", {0, 30});
    step(10);
    set(crate, "type", "static");
    const double height = y(crate);
    step(10);
    CHECK(y(crate) == height);
    set(crate, "type", "kinematic");
    set(crate, "velocity", Vec2(1, 0));
    step(60);
    CHECK(y(crate) == height);
    CHECK(x(crate) == Approx(1).epsilon(1e-4));
    set(crate, "type", "dynamic");
    step(30);
    CHECK(y(crate) < height - 1);
    CHECK_THROWS_WITH(set(crate, "type", "statik"), contains("did you mean \"static\"?"));
}

TEST_CASE_METHOD(Game, "a velocity without effect is refused with the reason") {
    const Handle ground = floor();
    CHECK_THROWS_WITH(set(ground, "velocity", Vec2(1, 0)),
                      contains("world.body_1.velocity") && contains("static"));
    CHECK_THROWS_WITH(set(ground, "angular_velocity", 1), contains("static"));
    CHECK_NOTHROW(set(ground, "velocity", Vec2(0, 0)));
    const Handle crate = body("Box", {0, 3});
    set(crate, "mass", inf);
    CHECK_THROWS_WITH(set(crate, "velocity", Vec2(1, 0)), contains("infinite mass"));
}

TEST_CASE_METHOD(
    Game,
    "a shape that becomes a sensor releases the bodies on it and holds them again afterwards") {
    const Handle ground = floor();
    const Handle crate = body("Box", {0, 0.5});
    REQUIRE(falls_asleep(crate));
    CHECK(get(crate, "contacts").list() == List{ground});
    set(shape_of(ground), "sensor", true);
    step(5);
    CHECK(y(crate) < 0.49);
    CHECK(get(crate, "contacts").list().empty());
    set(shape_of(ground), "sensor", false);
    step(60);
    CHECK(y(crate) > 0.4);
}

TEST_CASE_METHOD(Game, "a body whose position is written is not drawn between the two places") {
    const Handle crate = body("Box", {0, 3});
    step(5);
    set(crate, "position", Vec2(50, 60));
    CHECK(physics.body(crate).interpolated(0.5f).position.x == 50);
    CHECK(y(crate) == 60);
}

TEST_CASE_METHOD(Game, "sides and rounding of a box may be set in any order") {
    const Handle box = shape_of(body("Box", {0, 3}));
    set(box, "rounding", 2);
    set(box, "height", 10);
    set(box, "width", 10);
    CHECK(number(box, "rounding") == 2);
    CHECK(number(box, "area") == Approx(100 - (4 - 3.14159265) * 4).epsilon(1e-4));
}

TEST_CASE_METHOD(Game, "the ends of a segment may be set one after the other") {
    const Handle segment = shape_of(body("Segment", {0, 3}));
    set(segment, "from", Vec2(0.5, 0));  // the other end is still there
    step();
    set(segment, "to", Vec2(5, 0));
    CHECK(vec(segment, "from") == Vec2(0.5, 0));
    const List box = get(segment, "aabb").list();
    CHECK(box[1].vec2().x - box[0].vec2().x == Approx(4.5));
    CHECK_FALSE(physics.world(world()).validate());
}

TEST_CASE_METHOD(Game, "deleting a body in the middle of a pile leaves the world consistent") {
    floor();
    std::vector<Handle> pile;
    for (int i = 0; i < 20; ++i) pile.push_back(body(i % 2 ? "Box" : "Circle", {0.1 * i, 1.0 + i}));
    step(60);
    for (std::size_t i = 0; i < pile.size(); i += 3) {
        tree.destroy(pile[i]);
        CHECK_FALSE(physics.world(world()).validate());
        step(3);
    }
    step(120);
    CHECK_FALSE(physics.world(world()).validate());
    for (std::size_t i = 0; i < pile.size(); ++i)
        if (i % 3 != 0) CHECK(y(pile[i]) > 0.3);
}

TEST_CASE_METHOD(Game, "a body keeps its place when its center of mass is moved") {
    const Handle crate = body("Box", {2, 3});
    set(crate, "gravity_scale", 0);
    set(crate, "angle", 1);
    set(crate, "center", Vec2(0.4, 0.2));
    CHECK(vec(crate, "position") == Vec2(2, 3));
    step(5);
    CHECK((vec(crate, "position") - Vec2(2, 3)).length() < 1e-5);
    set(crate, "center", Value());
    CHECK(vec(crate, "center") == Vec2(0, 0));
}

TEST_CASE_METHOD(Game, "a number that a body refuses is not reported among the writes") {
    const Handle heavy = body("Circle", {0, 5}), other = body("Circle", {9, 5});
    const auto& spin = tree.property(heavy, "angular_velocity");
    step(1);
    Batches batches(tree);
    for (int i = 1; i <= 600; ++i) {  // in some batches the refused number is the last
        REQUIRE(tree.write(other, spin, i));
        // The mass is computed again before the number is refused; observers of the timeline are
        // notified of that.
        set(heavy, "mass", inf);
        CHECK_FALSE(tree.write(heavy, spin, i));
        REQUIRE_THROWS(tree.set(heavy, spin, Value(double(i))));
        REQUIRE(tree.write(other, spin, -i));
        set(heavy, "mass", 1);
    }
    tree.barrier();
    std::vector<std::string> expected;
    for (int i = 1; i <= 600; ++i)
        for (const std::string& reported :
             {"angular_velocity " + std::to_string(i), std::string("mass inf"),
              "angular_velocity " + std::to_string(-i), std::string("mass 1")})
            expected.push_back(reported);
    CHECK(batches.reported == expected);
    CHECK(number(other, "angular_velocity") == -600);
    CHECK(number(heavy, "angular_velocity") == 0);
}

TEST_CASE_METHOD(Game,
                 "numbers written to sleeping or kinematic or just edited bodies take effect") {
    floor();
    const Handle sleeper = body("Box", {0, 0.5}), driven = body("Box", {9, 5}, "kinematic");
    REQUIRE(falls_asleep(sleeper));
    tree.set(sleeper, tree.property(sleeper, "angular_velocity"), Value(1.0));
    CHECK(awake(sleeper));
    CHECK(number(sleeper, "angular_velocity") == 1);
    REQUIRE(falls_asleep(sleeper));
    tree.set(sleeper, tree.property(sleeper, "velocity"), Value(Vec2(0.5, 0)));
    CHECK(awake(sleeper));
    CHECK(vec(sleeper, "velocity") == Vec2(0.5, 0));
    REQUIRE(falls_asleep(sleeper));
    tree.set(sleeper, tree.property(sleeper, "gravity_scale"), Value(-1.0));
    CHECK(awake(sleeper));
    tree.set(driven, tree.property(driven, "velocity"), Value(Vec2(0, 2)));
    CHECK(vec(driven, "velocity") == Vec2(0, 2));
    tree.set(driven, tree.property(driven, "angular_velocity"), Value(2.0));
    CHECK(number(driven, "angular_velocity") == 2);
    set(shape_of(sleeper), "density", 3);
    tree.set(sleeper, tree.property(sleeper, "angular_velocity"), Value(4.0));
    CHECK(number(sleeper, "angular_velocity") == 4);
    step(1);
    CHECK(y(sleeper) > 0.5);
}

TEST_CASE_METHOD(Game, "a velocity written to a body is kept although its shape was moved") {
    const Handle plain = body("Circle", {0, 5}), watched = body("Circle", {9, 5});
    const auto watch = tree.watch(watched, tree.property(watched, "gravity_scale"),
                                  [](const property::Change&) {});
    for (const Handle spinning : {plain, watched}) {
        set(spinning, "angular_velocity", 2);
        step(1);
        const Vec2 velocity = vec(spinning, "velocity");
        // The center of mass moves with the shape, and the velocity there is different.
        set(shape_of(spinning), "center", Vec2(3, 0));
        const auto& written = tree.property(spinning, "velocity");
        if (!tree.write(spinning, written, velocity)) tree.set(spinning, written, Value(velocity));
        CHECK(vec(spinning, "velocity") == velocity);
    }
}

}  // namespace live_test
