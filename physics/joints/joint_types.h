#pragma once

#include <solver/joints/geometric_stiffness.h>
#include <solver/joints/joint_passes.h>
#include <solver/joints/long_levers.h>
#include <solver/joints/obstructed_joints.h>

#include <cmath>
#include <memory>
#include <type_traits>
#include <utility>

// All types of joints. Each type has one file with its settings (`Settings`), its solver
// (`Constraint`), and its handle, which the public headers declare.

namespace fettle::physics::detail {

/// All types, in the order of `JointType`.
#define FETTLE_JOINT_TYPES(type)                                                                 \
    type(mouse) type(distance) type(revolute) type(prismatic) type(wheel) type(weld) type(motor) \
        type(pulley) type(gear) type(groove) type(pin_slot) type(ratchet) type(filter)           \
            type(rotary_limit)

#define FETTLE_DECLARE_JOINT(type) extern const JointKind type##_joint;
FETTLE_JOINT_TYPES(FETTLE_DECLARE_JOINT)
#undef FETTLE_DECLARE_JOINT

/// The functions of a type of joint.
template <class Constraint>
class JointFunctions {
    using Settings = typename Constraint::Settings;
    using Impulses = decltype(Constraint::impulses);
    static_assert(std::is_trivially_copyable_v<Settings> && std::is_trivially_copyable_v<Impulses>);

    /// True if `pass<biased>` is both `solve` and `relax`.
    static constexpr bool has_one_pass = requires { &Constraint::template pass<true>; };
    static constexpr bool has_motor = requires { &Constraint::drive; };
    static constexpr bool has_length = requires { &Constraint::pull_now; };
    static constexpr bool has_rail = requires { &Constraint::rail; };
    static constexpr bool is_rigid = requires { &Constraint::separation; };

  public:
    static constexpr JointKind kind(const char* name) {
        float (*measure)(const JointRecord&, const JointPlace&) = nullptr;
        if constexpr (is_rigid) measure = separation;
        bool (*is_held)(const JointRecord&) = nullptr;
        if constexpr (requires { &Constraint::holds; }) is_held = holds;
        bool (*is_driven)(const JointRecord&) = nullptr;
        if constexpr (requires { &Settings::gives_energy; }) is_driven = gives_energy;
        Drive (*motor)(JointArray&, size_t) = nullptr;
        if constexpr (has_motor) motor = drive_of;
        Pull (*length)(const JointArray&, size_t) = nullptr;
        if constexpr (has_length) length = pull_of;
        return {.name = name,
                .constraint_size = sizeof(Constraint),
                .pushes_at_b = has_rail,
                .begin = begin,
                .check = check,
                .separation = measure,
                .holds = is_held,
                .gives_energy = is_driven,
                .prepare = prepare,
                .warm_start = warm_start,
                .solve = solve,
                .relax = relax,
                .load = load,
                .ends = ends_of,
                .pull = length,
                .drive = motor,
                .impulses = impulses_of,
                .load_on = load_on,
                .write_rows = write_rows,
                .store = store};
    }

  private:
    static void begin(JointRecord& joint) { joint.settings.become(Settings()); }
    static void check(const JointRecord& joint) { joint.settings.as<Settings>().check(); }
    static float separation(const JointRecord& joint, const JointPlace& place) {
        return Constraint::separation(joint.settings.as<Settings>(), place);
    }

    static bool holds(const JointRecord& joint) {
        return Constraint::holds(joint.settings.as<Settings>());
    }
    static bool gives_energy(const JointRecord& joint) {
        return joint.settings.as<Settings>().gives_energy();
    }

    static uint8_t prepare(const JointSource& source, JointArray& array, const JointStep& step,
                           JointRange range) {
        bool pulls_hard = false, presses = false, is_strong = false, reaches_far = false;
        for (size_t i = range.begin; i < range.end; ++i) {
            const JointRecord& joint = source.objects.joints[array.joints[i]];
            Constraint& c = *std::construct_at(array.as<Constraint>() + i);
            c.ends = source.ends_of(joint);
            if (!array.shares.empty()) c.ends.share = array.shares[i];
            c.impulses = joint.impulses.as<Impulses>();
            c.impulses.scale(step.impulse_ratio);
            const SolverBody &a = source.bodies.solver_bodies[c.ends.a],
                             &b = source.bodies.solver_bodies[c.ends.b];
            c.prepare(joint.settings.as<Settings>(), source.frame_of(joint), step, a, b);
            pulls_hard |= GeometricStiffness::may_be_too_great(c.ends, joint.force, a, b, step.h) ||
                          may_be_obstructed(joint.force, a, b, step.h);
            if constexpr (is_rigid) reaches_far |= has_long_lever(c.ends, has_rail, a, b);
            if constexpr (has_motor) {
                const Drive drive = c.drive();
                presses = presses || may_press(drive, a, b);
                is_strong = is_strong || load_of_drive(drive, a, b) > 0;
            }
            if constexpr (has_length) {
                const Pull pull = c.pull_now();
                presses =
                    presses || pull.is_strained || may_be_held(source.objects, joint, pull, a, b);
            }
        }
        return uint8_t((pulls_hard ? pull : 0) | (presses ? press : 0) | (is_strong ? strong : 0) |
                       (reaches_far ? lever : 0));
    }

    /// Calls `act(constraint, a, b)`. Other threads may read a body that does not move, so such a
    /// body is not written: the joint gets a copy.
    template <typename Act>
    static void for_each(JointArray& array, std::span<SolverBody> bodies, JointRange range,
                         Act&& act) {
        const auto still = [](const SolverBody& body) {
            return body.inverse_mass == 0.0f && body.inverse_inertia == 0.0f;
        };
        for (size_t i = range.begin; i < range.end; ++i) {
            Constraint& c = array.as<Constraint>()[i];
            SolverBody *a = &bodies[c.ends.a], *b = &bodies[c.ends.b];
            SolverBody copy;
            if (still(*a))
                a = &(copy = *a);
            else if (still(*b))
                b = &(copy = *b);
            act(c, *a, *b);
        }
    }

    /// Calls `act(a, b)`. A body that obstacles hold gets the impulses of its rope in the next
    /// sub-step only, with the warm start.
    template <typename Act>
    static void act_beside_obstacle(Constraint& c, SolverBody& a, SolverBody& b, Act&& act) {
        if (!has_length || c.ends.held < 0) return act(a, b);
        const bool is_a = c.ends.held == 0;
        Vec2& inverse = is_a ? c.ends.inverse_a : c.ends.inverse_b;
        const Vec2 own = std::exchange(inverse, Vec2{});
        SolverBody copy = is_a ? a : b;
        copy.inverse_inertia = 0.0f;
        is_a ? act(copy, b) : act(a, copy);
        inverse = own;
    }

    static void warm_start(JointArray& array, std::span<SolverBody> bodies, const JointStep&,
                           JointRange range) {
        for_each(array, bodies, range,
                 [](const Constraint& c, SolverBody& a, SolverBody& b) { c.warm_start(a, b); });
    }
    static void solve(JointArray& array, std::span<SolverBody> bodies, const JointStep& step,
                      JointRange range) {
        for_each(array, bodies, range, [&](Constraint& c, SolverBody& a, SolverBody& b) {
            act_beside_obstacle(c, a, b, [&](SolverBody& of_a, SolverBody& of_b) {
                if constexpr (has_one_pass)
                    c.template pass<true>(of_a, of_b, step);
                else
                    c.solve(of_a, of_b, step);
            });
        });
    }
    static void relax(JointArray& array, std::span<SolverBody> bodies, const JointStep& step,
                      JointRange range) {
        for_each(array, bodies, range, [&](Constraint& c, SolverBody& a, SolverBody& b) {
            act_beside_obstacle(c, a, b, [&](SolverBody& of_a, SolverBody& of_b) {
                if constexpr (has_one_pass)
                    c.template pass<false>(of_a, of_b, step);
                else
                    c.relax(of_a, of_b, step);
            });
        });
    }

    static JointLoad load(const JointArray& array, size_t index) {
        return array.as<Constraint>()[index].load();
    }
    static JointEnds& ends_of(JointArray& array, size_t index) {
        return array.as<Constraint>()[index].ends;
    }
    static Pull pull_of(const JointArray& array, size_t index) {
        return array.as<Constraint>()[index].pull_now();
    }
    static Drive drive_of(JointArray& array, size_t index) {
        return array.as<Constraint>()[index].drive();
    }
    static JointImpulses impulses_of(const JointArray& array, size_t index) {
        JointImpulses all;
        all.become(array.as<Constraint>()[index].impulses);
        return all;
    }
    /// Two bodies of unit mass and inertia at rest get the impulses: their velocities are the load.
    static JointLoad load_on(const JointArray& array, size_t index, const JointImpulses& impulses,
                             size_t side) {
        Constraint c = array.as<Constraint>()[index];
        c.impulses = impulses.template as<Impulses>();
        c.ends.inverse_a = c.ends.inverse_b = {1.0f, 1.0f};
        SolverBody bodies[2];
        for (SolverBody& body : bodies) body.inverse_mass = body.inverse_inertia = 1.0f;
        c.warm_start(bodies[0], bodies[1]);
        const Vec2 push = bodies[side].velocity,
                   lever = side == 0 ? c.ends.lever_a : c.ends.lever_b;
        return {push, bodies[side].angular_velocity, length(push) * length(lever)};
    }

    static void write_rows(JointArray& array, std::span<SolverBody> bodies, RowWriter& rows,
                           JointRange range) {
        for (size_t i = range.begin; i < range.end; ++i) {
            Constraint& c = array.as<Constraint>()[i];
            c.write_rows(rows, bodies[c.ends.a], bodies[c.ends.b]);
        }
    }

    static void store(JointArray& array, std::span<const SolverBody> bodies, ObjectState& objects,
                      const JointStep& step, JointRange range) {
        for (size_t i = range.begin; i < range.end; ++i) {
            const Constraint& c = array.as<Constraint>()[i];
            array.drives[i] = 0;
            if constexpr (requires { &Constraint::moves_bodies; })
                array.drives[i] = c.moves_bodies(bodies[c.ends.a], bodies[c.ends.b]);
            if constexpr (requires { &Constraint::holds_point; })
                array.open[i] =
                    c.holds_point() && c.ends.stays_open(bodies[c.ends.a], bodies[c.ends.b]);
            JointRecord& joint = objects.joints[array.joints[i]];
            const JointLoad load = c.load();
            // The next step begins with these impulses, so an overflow would never disappear.
            if (std::isfinite(load.push.x + load.push.y + load.twist))
                joint.impulses.become(c.impulses);
            else
                joint.impulses = {};
            joint.force = bounded(step.inverse_h * load.push, greatest_impulse);
            joint.torque = bounded(step.inverse_h * load.twist, greatest_impulse);
        }
    }
};

}  // namespace fettle::physics::detail
