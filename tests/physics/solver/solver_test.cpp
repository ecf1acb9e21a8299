#include <solver/contacts/contact_solver.h>
#include <wide/kernels.h>

#include <cstring>
#include <random>
#include <vector>

#include "catch.h"

namespace solver_test {

using namespace fettle::physics::detail;

namespace {

/// Random contacts between bodies of their own, as single constraints and as lanes of wide ones.
struct Scene {
    std::vector<SolverBody> bodies;
    std::vector<ContactConstraint> single;
    std::vector<WideContact> wide;
    Softness softness[2] = {make_softness(30.0f, 10.0f, 1.0f / 240),
                            make_softness(60.0f, 10.0f, 1.0f / 240)};

    explicit Scene(int groups) {
        std::mt19937 random(17);
        std::uniform_real_distribution<float> any(-1.0f, 1.0f), positive(0.1f, 2.0f);
        bodies.resize(1);
        wide.resize(size_t(groups));
        for (int i = 0; i < groups * group_size; ++i) {
            ContactConstraint c = {};
            for (uint32_t* end : {&c.a, &c.b}) {
                if (end == &c.a && i % 5 == 0) {
                    c.fixed = 1;  // one side is body 0
                    continue;
                }
                *end = uint32_t(bodies.size());
                bodies.push_back({{any(random), any(random)},
                                  any(random),
                                  positive(random),
                                  {0.01f * any(random), 0.01f * any(random)},
                                  0.01f * any(random),
                                  positive(random)});
            }
            const float angle = 3.0f * any(random);
            c.normal = {std::cos(angle), std::sin(angle)};
            c.friction = positive(random);
            c.count = uint16_t(1 + i % 2);
            c.coupling_normal = c.count == 2 ? any(random) : 0.0f;
            c.coupling_tangent = c.count == 2 ? any(random) : 0.0f;
            for (int k = 0; k < c.count; ++k) {
                c.points[k] = {any(random),      any(random),         any(random),
                               any(random),      0.02f * any(random), positive(random),
                               positive(random), positive(random),    0.1f * any(random)};
            }
            c.soft = softness[c.fixed];
            single.push_back(c);
            pack(c, wide[size_t(i / group_size)], i % group_size);
        }
    }

    void pack(const ContactConstraint& c, WideContact& w, int lane) const {
        w.a[lane] = c.a;
        w.b[lane] = c.b;
        w.normal_x[lane] = c.normal.x;
        w.normal_y[lane] = c.normal.y;
        w.friction[lane] = c.friction;
        w.bias_rate[lane] = c.soft.bias_rate;
        w.mass_scale[lane] = c.soft.mass_scale;
        w.impulse_keep[lane] = 1.0f - c.soft.impulse_scale;
        w.coupling_normal[lane] = c.coupling_normal;
        w.coupling_tangent[lane] = c.coupling_tangent;
        for (int k = 0; k < 2; ++k) {
            const ConstraintPoint& p = c.points[k];
            WidePoint& to = w.points[k];
            to.normal_lever_a[lane] = p.normal_lever_a;
            to.normal_lever_b[lane] = p.normal_lever_b;
            to.tangent_lever_a[lane] = p.tangent_lever_a;
            to.tangent_lever_b[lane] = p.tangent_lever_b;
            to.separation[lane] = p.separation;
            to.normal_mass[lane] = p.normal_mass;
            to.tangent_mass[lane] = p.tangent_mass;
            to.normal_impulse[lane] = p.normal_impulse;
            to.tangent_impulse[lane] = p.tangent_impulse;
        }
    }
};

constexpr int rounds = 6;
constexpr float inverse_h = 240.0f, push_speed = 3.0f;

std::vector<SolverBody> run_wide(Scene scene, const WideKernels& kernels) {
    std::vector<uint32_t> pushed(scene.wide.size()), unsettled(scene.wide.size());
    const WideStep step = {.bodies = scene.bodies.data(),
                           .contacts = scene.wide.data(),
                           .pushed = pushed.data(),
                           .unsettled = unsettled.data(),
                           .count = scene.wide.size(),
                           .inverse_h = inverse_h,
                           .push_speed = push_speed};
    for (int i = 0; i < rounds; ++i) {
        kernels.warm_start(step);
        kernels.solve_biased(step);
        kernels.relax(step);
    }
    return scene.bodies;
}

std::vector<SolverBody> run_single(Scene scene) {
    std::vector<ContactExtra> extras;
    std::vector<Relaxed> relaxed(scene.single.size());
    for (ContactConstraint& c : scene.single) {
        const float a = scene.bodies[c.a].inverse_mass, b = scene.bodies[c.b].inverse_mass;
        c.inverse_a = {a, a};
        c.inverse_b = {b, b};
    }
    ContactSolver solver;
    solver.bodies = scene.bodies;
    solver.constraints = scene.single;
    solver.extras = extras;
    solver.relaxed = relaxed;
    solver.inverse_h = inverse_h;
    solver.push_speed = push_speed;
    for (int i = 0; i < rounds; ++i) {
        solver.warm_start();
        solver.solve_biased();
        solver.relax();
    }
    return scene.bodies;
}

bool equal_bits(const std::vector<SolverBody>& a, const std::vector<SolverBody>& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(SolverBody)) == 0;
}

}  // namespace

TEST_CASE("wide contacts compute bit for bit the same at every width") {
    const Scene scene(40);
    const auto before = scene.bodies;
    const auto baseline = run_wide(scene, wide_kernels(4));
    REQUIRE_FALSE(equal_bits(before, baseline));
    for (const int width : {8, 16}) {
        const WideKernels& wider = wide_kernels(width);
        if (wider.width != width) WARN("skipped: this machine has no " << width << " lanes");
        REQUIRE(equal_bits(baseline, run_wide(scene, wider)));
    }
}

TEST_CASE("a wide contact computes what a single one does") {
    const Scene scene(40);
    const auto wide = run_wide(scene, wide_kernels());
    const auto single = run_single(scene);
    REQUIRE(wide.size() == single.size());
    for (size_t i = 0; i < wide.size(); ++i) {
        REQUIRE(wide[i].velocity.x == Approx(single[i].velocity.x).margin(1e-4));
        REQUIRE(wide[i].velocity.y == Approx(single[i].velocity.y).margin(1e-4));
        REQUIRE(wide[i].angular_velocity == Approx(single[i].angular_velocity).margin(1e-4));
        REQUIRE(wide[i].inverse_mass == single[i].inverse_mass);
    }
}

}  // namespace solver_test
