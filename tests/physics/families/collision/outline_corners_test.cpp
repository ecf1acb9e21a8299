// Shapes beside corners of chains and concave polygons: what is apart is not pushed, and what comes
// is stopped, whichever part of the outline has the nearest point.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;

namespace outline_corners_test {
namespace {

constexpr float turn = 6.2831853f;

enum class Outline { ground, terrain, island, star };

Geometry outline(Random& random, Outline kind) {
    const int count = 3 + int(random(0, 6.999f));
    std::vector<Vec2> points;
    if (kind == Outline::ground || kind == Outline::terrain) {
        float x = 0;
        for (int i = 0; i < count; ++i) {
            points.push_back({x, random(-0.6f, 0.6f)});
            x += random(0.15f, 1.2f);
        }
        if (kind == Outline::ground) return Chain{.points = points};
        points.push_back({x, -3});
        points.push_back({-1, -3});
        return Concave{.vertices = points};
    }
    for (int i = 0; i < count; ++i) {
        const float angle = -turn * float(i) / float(count);
        const float radius = random(0.5f, 1.6f);
        points.push_back({1.5f + radius * std::cos(angle), radius * std::sin(angle) - 0.5f});
    }
    if (kind == Outline::island) return Chain{.points = points, .closed = true};
    return Concave{.vertices = points};
}

Polygon round_polygon(Random& random, float size) {
    Polygon polygon;
    const int count = 3 + int(random(0, 6.999f));
    for (int i = 0; i < count; ++i) {
        const float angle = turn * (float(i) + random(0, 0.6f)) / float(count);
        polygon.vertices.push_back({size * std::cos(angle), size * std::sin(angle)});
    }
    polygon.rounding = size * random(0.15f, 0.5f);
    return polygon;
}

/// `less`: by how much all sides are nearer to the center (m).
Geometry visitor(Random random, int kind, float less) {
    const float size = random(0.15f, 0.8f);
    switch (kind) {
        case 0:
            return Circle{.radius = size - less};
        case 1: {
            const float rounding = size * random(0.1f, 0.3f);
            return Box{.width = 2 * size - 2 * less,
                       .height = size * random(1, 1.6f) - 2 * less,
                       .rounding = std::max(rounding - less, 0.0f)};
        }
        case 2:
            return Segment{.from = {-size * random(0.1f, 1), 0},
                           .to = {size * random(0.1f, 1), 0},
                           .rounding = std::max(size * random(0.2f, 0.7f), 0.08f) - less};
        case 3: {
            const float first = size * random(0.5f, 1);
            return Ellipse{.radius_x = first - less,
                           .radius_y = std::max(first * random(0.25f, 1), 0.08f) - less};
        }
        default: {
            Polygon polygon = round_polygon(random, size);
            polygon.rounding = std::max(polygon.rounding, 0.05f) - less;
            return polygon;
        }
    }
}

/// True if the point is on the solid side, or under a ground.
bool is_inside(const std::vector<Vec2>& points, const Vec2& p, Outline kind) {
    if (kind == Outline::ground) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2 a = points[i - 1], b = points[i];
            if (p.x < a.x || p.x > b.x) continue;
            return p.y < a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x);
        }
        return true;
    }
    bool inside = false;
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
        const Vec2 a = points[i], b = points[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

struct Approach {
    World world{WorldDef{.gravity = {0, 0}}};
    Shape fixed, moving;
    Body body;
    Separation gap;
    int kind = 0;
    Random of_visitor;
};

/// A shape less than 5 cm in front of an outline; none if this seed gives another place.
std::optional<Approach> approach(unsigned seed) {
    Random random{std::mt19937(seed)};
    Approach it;
    const Outline kind = Outline(seed % 4);
    Body ground = it.world.create_body({.type = BodyType::static_body});
    try {
        it.fixed = ground.add(outline(random, kind));
    } catch (const std::invalid_argument&) {
        return {};  // an outline that crosses itself
    }
    it.body = it.world.create_body({.position = {random(-0.5f, 5), random(-1.6f, 1.6f)},
                                    .angle = random(-3, 3),
                                    .locked_rotation = random(0, 1) < 0.5f});
    it.kind = int(seed / 4 % 5);
    it.of_visitor = random;
    it.moving = it.body.add(visitor(random, it.kind, 0));
    it.gap = distance(it.fixed, it.moving);
    if (!(it.gap.distance > 0.0005f && it.gap.distance < 0.05f)) return {};
    const auto points = it.fixed.vertices();
    if (is_inside({points.begin(), points.end()}, Vec2(it.moving.world_center()), kind)) return {};
    return it;
}

/// Calls `act` for this number of places.
template <class Act>
void for_each_approach(unsigned count, Act&& act) {
    unsigned found = 0;
    for (unsigned seed = 1; found < count; ++seed) {
        std::optional<Approach> it = approach(seed);
        if (!it) continue;
        ++found;
        act(seed, *it);
    }
}

}  // namespace

TEST_CASE("a shape that is apart from an outline is not pushed by it") {
    unsigned pushed = 0, worst = 0;
    for_each_approach(families::seeds_or(2000), [&](unsigned seed, Approach& it) {
        const Position before = it.body.position();
        it.world.step(1.0f / 60);
        const bool moved = (it.body.position() - before).length() > 1e-5f;
        pushed += moved;
        if (moved) worst = seed;
    });
    INFO("seed " << worst);
    CHECK(pushed == 0);
}

TEST_CASE("a shape that comes to a corner of an outline is stopped by it") {
    constexpr float deep = 0.03f;
    unsigned sank = 0, worst = 0;
    for_each_approach(families::seeds_or(2000), [&](unsigned seed, Approach& it) {
        it.body.set_velocity(-1.0f * it.gap.normal);
        const Geometry core = visitor(it.of_visitor, it.kind, deep);
        for (int i = 0; i < 20; ++i) {
            it.world.step(1.0f / 60);
            World apart;
            const Pose pose = {it.body.position(), it.body.angle()};
            Body copy = apart.create_body({.position = pose.position, .angle = pose.angle});
            if (distance(it.fixed, copy.add(core)).distance > 0) continue;
            ++sank;
            worst = seed;
            break;
        }
    });
    INFO("seed " << worst);
    CHECK(sank == 0);
}

}  // namespace outline_corners_test
