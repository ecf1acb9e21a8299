// Concave bodies that overlap other shapes: each overlap has a contact, whichever parts of the
// outlines it is between.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;
using families::turned;

namespace hooked_outlines_test {
namespace {

constexpr float turn = 6.2831853f;
/// An overlap that must have a contact, m.
constexpr float deep = 0.01f;

int number(Random& random, int count) {
    return std::min(int(random(0, float(count))), count - 1);
}

std::vector<Vec2> scaled(std::vector<Vec2> points, float size) {
    for (Vec2& p : points) p = size * p;
    return points;
}

Concave brick(Random& random) {
    const float size = random(0.3f, 0.6f);
    switch (number(random, 4)) {
        case 0:
            return {scaled({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, size)};
        case 1:
            return {scaled({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, size)};
        case 2:
            return {scaled({{1, 0},
                            {2, 0},
                            {2, 1},
                            {3, 1},
                            {3, 2},
                            {2, 2},
                            {2, 3},
                            {1, 3},
                            {1, 2},
                            {0, 2},
                            {0, 1},
                            {1, 1}},
                           size)};
        default: {
            std::vector<Vec2> star;
            const int count = 5 + number(random, 6);
            for (int i = 0; i < count; ++i) {
                const float angle = turn * (float(i) + random(0, 0.5f)) / float(count);
                star.push_back(random(0.3f, 1.2f) * turned(angle));
            }
            return {star};
        }
    }
}

Polygon round_polygon(float width, float height) {
    Polygon polygon;
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
        const Vec2 at = turned(turn * float(i) / float(count));
        polygon.vertices.push_back({width * at.x, height * at.y});
    }
    return polygon;
}

constexpr int visitors = 5;
Geometry visitor(Random& random, int kind) {
    const float width = random(0.1f, 0.8f), height = width * random(0.2f, 1);
    switch (kind) {
        case 0:
            return brick(random);
        case 1:
            return Box{.width = 2 * width, .height = 2 * height};
        case 2:
            return Polygon{.vertices = {{-width, 0}, {width, 0}, {random(-width, width), height}}};
        case 3:
            return round_polygon(width, height);
        default:
            return Ellipse{.radius_x = width, .radius_y = height};
    }
}

using Outline = std::vector<Vec2>;

std::vector<Outline> placed_parts(const Form& form, const Pose& pose) {
    std::vector<Outline> parts = form.parts();
    const Vec2 x = turned(pose.angle);
    for (Outline& part : parts)
        for (Vec2& v : part)
            v = Vec2(pose.position) + Vec2{x.x * v.x - x.y * v.y, x.y * v.x + x.x * v.y};
    return parts;
}

float separation_along(const Outline& a, const Outline& b) {
    float best = -1e9f;
    for (size_t i = 0; i < a.size(); ++i) {
        const Vec2 edge = a[(i + 1) % a.size()] - a[i];
        const Vec2 normal = (1 / edge.length()) * Vec2{edge.y, -edge.x};
        float least = 1e9f;
        for (const Vec2 v : b)
            least = std::min(least, normal.x * (v.x - a[i].x) + normal.y * (v.y - a[i].y));
        best = std::max(best, least);
    }
    return best;
}

/// The overlap of the two convex parts that overlap most, m.
float overlap_of(const std::vector<Outline>& a, const std::vector<Outline>& b) {
    float most = 0;
    for (const Outline& part : a)
        for (const Outline& other : b)
            most = std::max(
                most, -std::max(separation_along(part, other), separation_along(other, part)));
    return most;
}

std::vector<Outline> outlines_of(const Geometry& geometry, const Pose& pose) {
    if (const auto* ellipse = std::get_if<Ellipse>(&geometry))
        return placed_parts(Geometry(round_polygon(ellipse->radius_x, ellipse->radius_y)), pose);
    return placed_parts(Form(geometry), pose);
}

}  // namespace

TEST_CASE("a shape that overlaps a concave polygon has contact points with it") {
    unsigned overlaps = 0, missed = 0, worst = 0;
    for (unsigned seed = 1; seed <= families::seeds_or(4000); ++seed) {
        Random random{std::mt19937(seed)};
        const Geometry still = brick(random), moving = visitor(random, int(seed % visitors));
        const Pose pose = {{0, 0}, random(-3, 3)};
        const Vec2 from = turned(random(-3, 3));
        const Vec2 aside = random(-1.2f, 1.2f) * Vec2{-from.y, from.x};
        const float wanted = random(0.015f, 0.12f), angle = random(-3, 3);
        const std::vector<Outline> outline = outlines_of(still, pose);
        for (float far = 4; far > -1; far -= 0.01f) {
            const Pose at = {Position(far * from + aside), angle};
            if (overlap_of(outline, outlines_of(moving, at)) < wanted) continue;
            ++overlaps;
            if (!contact_manifolds(still, pose, moving, at).empty() &&
                !contact_manifolds(moving, at, still, pose).empty())
                break;
            ++missed;
            worst = seed;
            break;
        }
    }
    INFO("seed " << worst << ", " << overlaps << " overlaps");
    CHECK(overlaps > families::seeds_or(4000) / 2);
    CHECK(missed <= overlaps / 1000);
}

TEST_CASE("concave bricks in a pit have a contact in each step in which they overlap") {
    unsigned overlaps = 0, missed = 0, worst = 0;
    for (unsigned seed = 1; seed <= families::seeds_or(24); ++seed) {
        Random random{std::mt19937(seed)};
        const float step = 1 / std::vector<float>{30, 60, 144}[seed % 3];
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 20, .height = 2, .center = {0, -1}});
        for (const float side : {-1.0f, 1.0f})
            ground.add(Box{.width = 1, .height = 60, .center = {4 * side, 30}});
        std::vector<std::pair<Shape, Form>> bricks;
        const float speed = random(0, 8);
        constexpr int count = 16;
        const int wait = int(0.7f / step);
        for (int i = 0; i < (count + 3) * wait; ++i) {
            if (i % wait == 0 && i / wait < count) {
                Body body = world.create_body({.position = {random(-1.5f, 1), 14},
                                               .angle = random(-3, 3),
                                               .velocity = {0, -speed}});
                const Concave form = brick(random);
                bricks.emplace_back(body.add(form), Form(form));
            }
            std::vector<std::vector<Outline>> before;
            for (const auto& [shape, form] : bricks)
                before.push_back(
                    placed_parts(form, {shape.body().position(), shape.body().angle()}));
            world.step(step);
            for (size_t a = 0; a < bricks.size(); ++a) {
                for (size_t b = 0; b < a; ++b) {
                    const Shape &of_a = bricks[a].first, &of_b = bricks[b].first;
                    if (!of_a.body().awake() && !of_b.body().awake()) continue;
                    const Aabb box = of_a.aabb(), other = of_b.aabb();
                    if (box.max.x < other.min.x || other.max.x < box.min.x ||
                        box.max.y < other.min.y || other.max.y < box.min.y)
                        continue;
                    if (overlap_of(before[a], before[b]) < deep) continue;
                    ++overlaps;
                    if (world.is_touching(ContactId::of(of_a.id(), of_b.id()))) continue;
                    const auto now = [](const std::pair<Shape, Form>& it) {
                        const Body body = it.first.body();
                        return placed_parts(it.second, {body.position(), body.angle()});
                    };
                    if (overlap_of(now(bricks[a]), now(bricks[b])) < deep) continue;
                    ++missed;
                    worst = seed;
                }
            }
        }
    }
    INFO("seed " << worst << ", " << overlaps << " overlaps");
    CHECK(overlaps > 0);
    CHECK(missed == 0);
}

}  // namespace hooked_outlines_test
