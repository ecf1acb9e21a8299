// Random worlds with hostile values, and random edits while they run: the input bytes choose what
// is created and changed. The world must stay consistent and finite.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <fettle/physics/physics.h>

using namespace fettle::physics;

namespace {

/// Reads choices from the input; zeros after its end.
class Choices {
  public:
    Choices(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}
    bool empty() const { return data_ == end_; }
    unsigned byte() { return empty() ? 0u : *data_++; }
    unsigned of(unsigned count) { return byte() % count; }
    bool flip() { return byte() % 2 == 1; }
    /// Positive, from 10⁻⁶ to 10⁶, mostly near 1.
    float size() {
        const unsigned choice = byte();
        if (choice < 160) return 0.2f + static_cast<float>(choice) / 100.0f;
        const float power = static_cast<float>(choice - 160) / 95.0f * 12.0f - 6.0f;
        return std::pow(10.0f, power);
    }
    float number() {
        const float value = size();
        return flip() ? value : -value;
    }
    /// Mostly near the origin, so that shapes overlap.
    float coordinate() {
        const unsigned choice = byte();
        if (choice > 250) return number();
        return (static_cast<float>(choice) - 125.0f) / 25.0f;
    }
    Vec2 place() {
        const float x = coordinate();
        return {x, coordinate()};
    }
    Vec2 vector() {
        const float x = number();
        return {x, number()};
    }

  private:
    const std::uint8_t* data_;
    const std::uint8_t* end_;
};

class Builder {
  public:
    Builder(const std::uint8_t* data, std::size_t size) : choose_(data, size) {}

    void run() {
        world_.set_solver(static_cast<Solver>(choose_.of(3)));
        if (choose_.flip()) world_.set_bounds(Aabb{{-6, -6}, {6, 6}});
        world_.set_substeps(1 + static_cast<int>(choose_.of(6)));
        for (int edits = 0; edits < 120 && !choose_.empty(); ++edits) {
            try {
                edit();
            } catch (const std::invalid_argument&) {
                // a refused call is a valid result
            }
        }
        for (int i = 0; i < 4; ++i) step();
    }

  private:
    void step() {
        // A step of the exact solver may take some tenths of a second where there are many
        // contacts, and ten times as long with the sanitizers.
        const bool exact = world_.solver() == Solver::direct;
        spent_ += exact ? 1 + world_.contacts().size() / 4 : 1;
        if (spent_ > 60) return;
        world_.step(choose_.of(16) == 0 ? choose_.size() : 1.0f / 60);
        if (const auto fault = world_.validate()) {
            std::fprintf(stderr, "%s\n", fault->c_str());
            std::abort();
        }
        for (const Contact& contact : world_.contacts()) {
            if (!std::isfinite(contact.normal_force)) {
                std::fputs("a contact force is not finite\n", stderr);
                std::abort();
            }
        }
        for (const Joint& joint : world_.joints()) {
            if (!joint.force().is_finite() || !std::isfinite(joint.torque())) {
                std::fputs("a joint force is not finite\n", stderr);
                std::abort();
            }
        }
    }

    void edit() {
        switch (choose_.of(12)) {
            case 0:
            case 1:
            case 2:
                return make_body();
            case 3:
                return make_joint();
            case 4:
                return edit_body();
            case 5:
                return edit_shape();
            case 6:
                return edit_world();
            case 7:
                return edit_joint();
            case 8:
                return crowd_one_body();
            case 9:
                return destroy();
            default:
                step();
        }
    }

    template <class List>
    auto pick(List&& list) {
        return list[choose_.byte() % list.size()];
    }

    void add_shape(Body body) {
        ShapeDef def;
        def.density = choose_.size();
        if (choose_.flip()) def.friction = choose_.size();
        if (choose_.flip()) def.restitution = static_cast<float>(choose_.of(11)) / 10.0f;
        if (choose_.of(4) == 0) def.rolling_resistance = choose_.size();
        if (choose_.of(4) == 0) def.surface_speed = choose_.number();
        def.sensor = choose_.of(8) == 0;
        def.hit_events = choose_.flip();
        switch (choose_.of(9)) {
            case 0:
                body.add(Circle{.radius = choose_.size(), .center = choose_.place()}, def);
                return;
            case 1: {
                const float width = choose_.size();
                body.add(Box{.width = width, .height = choose_.size(), .angle = choose_.number()},
                         def);
                return;
            }
            case 2: {
                const Vec2 from = choose_.place();
                body.add(Segment{.from = from,
                                 .to = choose_.place(),
                                 .rounding = choose_.flip() ? choose_.size() : 0.0f},
                         def);
                return;
            }
            case 3: {
                const float wide = choose_.size();
                body.add(Ellipse{.radius_x = wide, .radius_y = choose_.size()}, def);
                return;
            }
            case 4:
                body.add(Polygon{.vertices = outline(9 + choose_.byte()),
                                 .rounding = choose_.flip() ? choose_.size() : 0.0f},
                         def);
                return;
            case 5:
                body.add(Chain{outline(2 + choose_.of(40)), choose_.flip()}, def);
                return;
            case 6: {
                // A star if the two radii differ.
                std::vector<Vec2> points = outline(4 + choose_.of(40));
                const float inner = choose_.size();
                for (std::size_t i = 0; i < points.size(); i += 2) points[i] *= inner;
                body.add(Concave{points}, def);
                return;
            }
            default: {
                Polygon polygon;
                for (unsigned n = choose_.of(10); n > 0; --n)
                    polygon.vertices.push_back(choose_.flip() ? choose_.place() : choose_.vector());
                if (choose_.of(4) == 0) polygon.rounding = choose_.size();
                body.add(polygon, def);
            }
        }
    }

    /// Points on an ellipse.
    std::vector<Vec2> outline(unsigned count) {
        const Vec2 center = choose_.place();
        const float wide = choose_.size(), high = choose_.size();
        std::vector<Vec2> points;
        for (unsigned i = 0; i < count; ++i) {
            const float t = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
            points.push_back(center + Vec2(wide * std::cos(t), high * std::sin(t)));
        }
        return points;
    }

    void make_body() {
        if (world_.body_count() > 60) return;
        BodyDef def;
        def.type = static_cast<BodyType>(choose_.of(8) < 6 ? 2 : choose_.of(2));
        def.position = choose_.place();
        if (choose_.flip()) def.angle = choose_.number();
        if (choose_.flip()) def.velocity = choose_.vector();
        if (choose_.of(4) == 0) def.angular_velocity = choose_.number();
        if (choose_.of(4) == 0) def.mass = choose_.size();
        if (choose_.of(8) == 0) def.inertia = choose_.size();
        if (choose_.of(8) == 0) def.center = choose_.place();
        def.bullet = choose_.of(4) == 0;
        def.locked_x = choose_.of(8) == 0;
        def.locked_rotation = choose_.of(8) == 0;
        Body body = world_.create_body(def);
        for (unsigned n = 1 + choose_.of(2); n > 0; --n) add_shape(body);
    }

    /// Makes a body with very many contacts.
    void crowd_one_body() {
        if (world_.body_count() > 60) return;
        const Vec2 at = choose_.place();
        Body big = world_.create_body({.position = at});
        big.add(Box{.width = 8, .height = 0.5f});
        const float size = 0.05f + static_cast<float>(choose_.byte()) / 500.0f;
        for (unsigned n = choose_.of(40); n > 0; --n) {
            Body small = world_.create_body(
                {.position = {at.x + static_cast<float>(n) * 0.2f - 4.0f, at.y + 0.2f}});
            small.add(Circle{.radius = size});
        }
    }

    void make_joint() {
        auto bodies = world_.bodies();
        if (bodies.empty() || world_.joint_count() > 40) return;
        JointDef def;
        if (choose_.of(4) != 0) def.body_a = pick(bodies).id();
        def.body_b = pick(bodies).id();
        def.anchor_a = choose_.place();
        def.anchor_b = choose_.flip() ? choose_.place() : choose_.vector();
        def.collide = choose_.flip();
        const float a = choose_.size(), b = choose_.number();
        switch (choose_.of(13)) {
            case 0:
                world_.create_mouse_joint({.body = def.body_b, .target = choose_.vector()});
                return;
            case 1:
                world_.create_distance_joint(def).set_length(a);
                return;
            case 2: {
                DistanceJoint rope = world_.create_distance_joint(def);
                rope.set_hertz(a);
                rope.set_max_length(std::fabs(b));
                return;
            }
            case 3: {
                RevoluteJoint pin = world_.create_revolute_joint(def);
                pin.set_max_motor_torque(a);
                pin.set_motor_speed(b);
                pin.set_upper_angle(0.5f);
                pin.set_lower_angle(-0.1f);
                return;
            }
            case 4: {
                PrismaticJoint rail = world_.create_prismatic_joint(def);
                rail.set_upper_translation(a);
                rail.set_hertz(std::fabs(b));
                return;
            }
            case 5:
                world_.create_wheel_joint(def).set_hertz(a);
                return;
            case 6: {
                WeldJoint weld = world_.create_weld_joint(def);
                if (choose_.flip()) weld.set_hertz(a);
                weld.set_break_torque(std::fabs(b));
                return;
            }
            case 7: {
                MotorJoint motor = world_.create_motor_joint(def);
                motor.set_max_force(a);
                motor.set_max_torque(a);
                motor.set_linear_velocity({b, a});
                if (choose_.flip()) motor.set_hertz(choose_.size());
                return;
            }
            case 8: {
                PulleyJoint pulley = world_.create_pulley_joint(def);
                pulley.set_ratio(a);
                pulley.set_length(std::fabs(b));
                return;
            }
            case 9:
                world_.create_gear_joint(def).set_ratio(b);
                return;
            case 10:
                world_.create_groove_joint(def).set_end({a, b});
                return;
            case 11:
                world_.create_pin_slot_joint(def).set_hertz(a);
                return;
            default:
                world_.create_ratchet_joint(def).set_tooth(b);
        }
    }

    void edit_body() {
        auto bodies = world_.bodies();
        if (bodies.empty()) return;
        Body body = pick(bodies);
        switch (choose_.of(12)) {
            case 0:
                return body.set_position(choose_.place());
            case 1:
                return body.set_velocity(choose_.vector());
            case 2:
                return body.set_angular_velocity(choose_.number());
            case 3:
                return body.set_mass(choose_.flip() ? std::optional<float>(choose_.size())
                                                    : std::nullopt);
            case 4:
                return body.set_type(static_cast<BodyType>(choose_.of(3)));
            case 5:
                return body.set_force(choose_.vector());
            case 6:
                return body.set_torque(choose_.number());
            case 7:
                return body.set_awake(choose_.flip());
            case 8:
                return body.apply_impulse(choose_.vector(), choose_.place());
            case 9:
                return body.set_linear_damping(choose_.size());
            case 10:
                return body.set_gravity_scale(choose_.number());
            default:
                return add_shape(body);
        }
    }

    void edit_shape() {
        auto shapes = world_.shapes();
        if (shapes.empty()) return;
        Shape shape = pick(shapes);
        switch (choose_.of(6)) {
            case 0:
                return shape.set_density(choose_.size());
            case 1:
                return shape.set_friction(choose_.size());
            case 2:
                return shape.set_sensor(choose_.flip());
            case 3:
                return shape.set_restitution(choose_.flip() ? 1.0f : 0.0f);
            case 4:
                return shape.set_geometry(Circle{.radius = choose_.size()});
            default:
                return shape.detach();
        }
    }

    void edit_world() {
        switch (choose_.of(11)) {
            case 0:
                return world_.set_solver(static_cast<Solver>(choose_.of(3)));
            case 1:
                return world_.set_gravity(choose_.vector());
            case 2:
                return world_.set_contact_hertz(choose_.size());
            case 3:
                return world_.set_push_speed(choose_.size());
            case 4:
                return world_.set_contact_damping(choose_.size());
            case 5:
                return world_.explode(choose_.place(), choose_.size(), choose_.number());
            case 6: {
                std::vector<std::byte> saved;
                world_.save(saved);
                return world_.restore(saved);
            }
            case 7:
                return disable_some_contacts();
            case 8:
                return check_queries();
            case 9:
                return world_.set_max_speed(choose_.size());
            default:
                return world_.set_continuous(choose_.flip());
        }
    }

    void disable_some_contacts() {
        const unsigned every = choose_.byte();
        if (every == 0) return world_.set_before_solve({});
        world_.set_before_solve([every, calls = 0u](ContactEdit& contact) mutable {
            contact.enabled = ++calls % every != 0;
        });
    }

    /// The results of queries are finite.
    void check_queries() {
        const Vec2 from = choose_.place(), to = choose_.place();
        bool finite = true;
        if (const auto hit = world_.cast_ray(from, to))
            finite &= hit->point.is_finite() && hit->fraction >= 0.0f && hit->fraction <= 1.0f;
        if (const auto near = world_.closest(from, choose_.size()))
            finite &= near->point.is_finite() && std::isfinite(near->distance);
        (void)world_.query_point(from);
        const auto bodies = world_.bodies();
        if (!bodies.empty()) {
            const auto shapes = pick(bodies).shapes(), others = pick(bodies).shapes();
            if (!shapes.empty() && !others.empty()) {
                const Shape shape = pick(shapes);
                finite &= std::isfinite(distance(shape, pick(others)).distance);
                if (const auto hit = world_.cast_shape(shape, to))
                    finite &= hit->point.is_finite() && std::isfinite(hit->fraction);
                (void)world_.query_overlap(shape);
            }
        }
        if (finite) return;
        std::fputs("a result of a query is not finite\n", stderr);
        std::abort();
    }

    void edit_joint() {
        auto joints = world_.joints();
        if (joints.empty()) return;
        Joint joint = pick(joints);
        switch (choose_.of(3)) {
            case 0:
                return joint.set_enabled(choose_.flip());
            case 1:
                return joint.set_break_force(choose_.size());
            default:
                return joint.set_broken(choose_.flip());
        }
    }

    void destroy() {
        auto bodies = world_.bodies();
        auto joints = world_.joints();
        if (choose_.flip() && !bodies.empty())
            pick(bodies).destroy();
        else if (!joints.empty())
            pick(joints).destroy();
    }

    Choices choose_;
    World world_;
    std::size_t spent_ = 0;  // cost of the steps so far
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Builder(data, size).run();
    return 0;
}
