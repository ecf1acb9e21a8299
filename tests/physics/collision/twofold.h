#pragma once

#include <collision/large_polygon.h>

#include <random>

#include "catch.h"
#include "scenes.h"

namespace scenes {

using namespace fettle::physics::detail;

/// A convex polygon as the narrow phase sees it, in both ways: rotated, and to be rotated.
struct Twofold {
    std::vector<Vec2> plain, plain_normals, local, local_normals;
    std::vector<float> offsets;
    Rotation q;
    float radius;

    Twofold(std::mt19937& random, int count, float rounding) : radius(rounding) {
        std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), stretch(0.3f, 2.0f);
        const float a = stretch(random), b = stretch(random);
        const std::vector<Vec2> points = ellipse_points(a, b, count, {0.3f, -0.1f});
        std::vector<Vec2> hull;
        REQUIRE(convex_hull(points, hull) == HullStatus::ok);
        REQUIRE(int(hull.size()) == count);
        const float turn = angle(random);
        q = {std::cos(turn), std::sin(turn)};
        for (const Vec2& v : hull) local.push_back(v);
        for (size_t i = 0; i < local.size(); ++i) {
            const Vec2 n = normalized(right_perp(local[(i + 1) % local.size()] - local[i]));
            local_normals.push_back(n);
            offsets.push_back(dot(n, local[i]));
            plain.push_back(rotate(q, local[i]));
            plain_normals.push_back(rotate(q, n));
        }
    }
    Solid large() const {
        const bool many = int(local.size()) > most_small_vertices;
        if (!many) return {convex()};
        return {{local.data(), local_normals.data(), offsets.data(), int(local.size()), radius},
                FormKind::large,
                q,
                nullptr,
                nullptr};
    }
    Convex convex() const {
        return {plain.data(), plain_normals.data(), offsets.data(), int(plain.size()), radius};
    }
};

}  // namespace scenes
