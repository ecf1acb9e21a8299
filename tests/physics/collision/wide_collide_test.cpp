#include <geometry/trigonometry.h>
#include <geometry/vertex_pool.h>
#include <wide/kernels.h>

#include <algorithm>
#include <random>
#include <vector>

#include "catch.h"

namespace wide_collide_test {

using namespace fettle::physics::detail;
using fettle::physics::Vec2;

namespace {

/// Pairs of triangles and quadrilaterals near each other, with a manifold from the step before.
struct Pairs {
    VertexPool pool;
    std::vector<uint32_t> begins;
    std::vector<CollisionBatch> batches;
    std::vector<Manifold> manifolds;

    explicit Pairs(int count, float rounding) {
        std::mt19937 random(23);
        std::uniform_real_distribution<float> any(-1.0f, 1.0f), size(0.02f, 0.5f);
        manifolds.resize(size_t(count) * CollisionBatch::size);
        for (int i = 0; i < count; ++i) {
            CollisionBatch& batch = batches.emplace_back();
            batch = {};
            for (int lane = 0; lane < CollisionBatch::size; ++lane) {
                // Level, at rest on each other, and in any position.
                const bool level = lane % 4 == 0;
                const int a = 3 + int(random() % 2), b = 3 + int(random() % 2);
                batch.begin_a[lane] = add(a, size(random), level ? 0.0f : 3.0f * any(random));
                batch.begin_b[lane] = add(b, size(random), level ? 0.0f : 3.0f * any(random));
                batch.count_a[lane] = a;
                batch.count_b[lane] = b;
                batch.radius_a[lane] = lane % 3 == 0 ? rounding : 0.0f;
                batch.radius_b[lane] = rounding;
                batch.offset_x[lane] = 0.7f * any(random);
                batch.offset_y[lane] = 0.7f * any(random);
                batch.margin[lane] = lane % 5 == 0 ? 0.0f : 0.02f;
            }
            batch.count = CollisionBatch::size;
        }
    }

    uint32_t add(int count, float half, float angle) {
        const uint32_t begin = pool.allocate(4);
        const Rotation q = rotation_of(double(angle));
        const Vec2 box[4] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
        const Vec2 triangle[3] = {{-half, -half}, {half, -half}, {0.0f, 0.7f * half}};
        const Vec2* corners = count == 4 ? box : triangle;
        for (int i = 0; i < count; ++i) {
            const Vec2 edge = corners[(i + 1) % count] - corners[i];
            const Vec2 normal = normalized(right_perp(edge));
            pool.vertices[begin + uint32_t(i)] = rotate(q, corners[i]);
            pool.directions[begin + uint32_t(i)] = rotate(q, normal);
            pool.offsets[begin + uint32_t(i)] = dot(normal, corners[i]);
        }
        if (count == 3) pool.pad_triangle(begin);
        return begin;
    }
    ConvexArrays arrays() const {
        return {pool.vertices.data(), pool.directions.data(), pool.offsets.data()};
    }
    Convex convex(uint32_t begin, int count, float radius) const {
        return {&pool.vertices[begin], &pool.directions[begin], &pool.offsets[begin], count,
                radius};
    }
    Manifold one_by_one(const CollisionBatch& batch, int lane) const {
        Manifold m;
        collide(convex(batch.begin_a[lane], batch.count_a[lane], batch.radius_a[lane]),
                convex(batch.begin_b[lane], batch.count_b[lane], batch.radius_b[lane]),
                {batch.offset_x[lane], batch.offset_y[lane]}, batch.margin[lane], m);
        return m;
    }
    /// Manifolds and lanes left to do, as one text of bytes.
    std::vector<uint32_t> run(int width) {
        std::fill(manifolds.begin(), manifolds.end(), Manifold{});
        std::vector<uint32_t> again;
        Manifold* next = manifolds.data();
        for (CollisionBatch& batch : batches) {
            for (Manifold*& manifold : batch.manifolds) manifold = next++;
            again.push_back(wide_kernels(width).collide(arrays(), batch));
        }
        return again;
    }
};

bool equal_points(const Manifold& a, const Manifold& b) {
    if (a.count != b.count) return false;
    if (a.count == 0) return true;
    bool equal = a.normal.x == b.normal.x && a.normal.y == b.normal.y && a.corner == b.corner;
    for (int k = 0; k < a.count; ++k) {
        const ManifoldPoint &p = a.points[k], &q = b.points[k];
        equal &= p.anchor_a.x == q.anchor_a.x && p.anchor_a.y == q.anchor_a.y &&
                 p.anchor_b.x == q.anchor_b.x && p.anchor_b.y == q.anchor_b.y &&
                 p.separation == q.separation && p.feature == q.feature;
    }
    return equal;
}

}  // namespace

TEST_CASE("pairs of small polygons collide the same alone and sixteen at a time") {
    for (const float rounding : {0.0f, 0.01f}) {
        Pairs pairs(200, rounding);
        const std::vector<uint32_t> again = pairs.run(16);
        int met = 0, left = 0, different = 0;
        for (size_t i = 0; i < pairs.batches.size(); ++i) {
            for (int lane = 0; lane < CollisionBatch::size; ++lane) {
                if ((again[i] >> lane & 1) != 0) {
                    ++left;
                    continue;
                }
                const Manifold one = pairs.one_by_one(pairs.batches[i], lane);
                met += one.count > 0;
                different += !equal_points(one, *pairs.batches[i].manifolds[lane]);
            }
        }
        REQUIRE(different == 0);
        REQUIRE(met > 500);
        REQUIRE(left < met);
    }
}

TEST_CASE("pairs of small polygons collide bit for bit the same at every width") {
    Pairs pairs(100, 0.01f);
    const auto again = pairs.run(4);
    const std::vector<Manifold> baseline = pairs.manifolds;
    for (const int width : {8, 16}) {
        if (wide_kernels(width).width != width) WARN("skipped: no " << width << " lanes here");
        REQUIRE(pairs.run(width) == again);
        REQUIRE(
            std::equal(baseline.begin(), baseline.end(), pairs.manifolds.begin(), equal_points));
    }
}

TEST_CASE("contact points of the same vertices keep their impulses in any order") {
    Pairs pairs(100, 0.0f);
    pairs.run(16);
    int exchanged = 0;
    for (Manifold& m : pairs.manifolds) {
        if (m.count < 2) continue;
        for (int k = 0; k < 2; ++k) {
            m.points[k].normal_impulse = float(m.points[k].feature);
            m.points[k].tangent_impulse = -float(m.points[k].feature);
        }
        if (++exchanged % 2 == 0) std::swap(m.points[0], m.points[1]);
        if (exchanged % 5 == 0) m.points[0].feature ^= 0xffff;  // was another one
    }
    REQUIRE(exchanged > 100);
    const std::vector<Manifold> before = pairs.manifolds;
    for (CollisionBatch& batch : pairs.batches) wide_kernels().collide(pairs.arrays(), batch);
    for (size_t i = 0; i < before.size(); ++i) {
        const Manifold &old = before[i], &m = pairs.manifolds[i];
        for (int k = 0; k < m.count && old.count == 2; ++k) {
            float expected = 0.0f;
            for (const ManifoldPoint& p : old.points) {
                if (p.feature == m.points[k].feature) expected = p.normal_impulse;
            }
            REQUIRE(m.points[k].normal_impulse == expected);
            REQUIRE(m.points[k].tangent_impulse == -expected);
        }
    }
}

}  // namespace wide_collide_test
