// Bodies with many pins, welds and rods: hubs with spokes, windmills, trees of welded boxes. They
// gain no energy, whatever the masses are. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catch.h"
#include "family.h"

namespace crowded_joints_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

/// Bodies without gravity and without contacts, which a push sets in motion.
class Jointed {
  public:
    explicit Jointed(Random& random) {
        switch (int(random(0, 3))) {
            case 0:
                hub(random);
                break;
            case 1:
                tree(random);
                break;
            default:
                windmill(random);
        }
        for (Body& body : bodies_) {
            body.set_velocity({random(-1, 1), random(-1, 1)});
            body.set_angular_velocity(random(-1, 1));
        }
        what_ += " of " + std::to_string(bodies_.size());
    }
    float energy() const {
        float sum = 0;
        for (const Body& body : bodies_) {
            const float w = body.angular_velocity();
            sum += 0.5f * (body.mass() * body.velocity().length_squared() + body.inertia() * w * w);
        }
        return sum;
    }
    void step() { world_.step(1.0f / 60); }
    const std::string& what() const { return what_; }

  private:
    Body add(Position at, float angle, const Geometry& geometry, float density) {
        bodies_.push_back(world_.create_body({.position = at, .angle = angle}));
        bodies_.back().add(geometry, {.density = density, .mask = 0});
        return bodies_.back();
    }
    void join(int kind, const Body& a, const Body& b, Position at) {
        const Vec2 on_a = a.local_point(at), on_b = b.local_point(at);
        if (kind == 0)
            world_.create_revolute_joint(
                {.body_a = a.id(), .body_b = b.id(), .anchor_a = on_a, .anchor_b = on_b});
        else if (kind == 1)
            world_.create_weld_joint(
                {.body_a = a.id(), .body_b = b.id(), .anchor_a = on_a, .anchor_b = on_b});
        else
            world_.create_distance_joint({.body_a = a.id(), .body_b = b.id()});
    }
    /// Spokes around a body, light or heavy, near it or far away.
    void hub(Random& random) {
        const int kind = int(random(0, 3)), count = int(random(3, 25));
        const float radius = random(0.2f, 0.6f), arm = random(0.1f, 3);
        const float size = random(0.1f, 0.8f), density = random(0.3f, 3);
        const Body middle = add({0, 0}, 0, Circle{.radius = radius}, 1);
        for (int i = 0; i < count; ++i) {
            const Vec2 way = turned(6.2832f * float(i) / float(count));
            const Body spoke = add(arm * way, 0, Circle{.radius = size}, density);
            join(kind, middle, spoke,
                 random(0, 1) < 0.5f ? Position(arm * way) : Position(0.5f * arm * way));
        }
        what_ = kind == 0 ? "pinned hub" : kind == 1 ? "welded hub" : "hub with rods";
    }
    void windmill(Random& random) {
        const int count = int(random(2, 9));
        const float radius = random(0.2f, 0.6f), length = random(0.5f, 4);
        const Body middle = add({0, 0}, 0, Circle{.radius = radius}, 1);
        world_.create_revolute_joint({.body_b = middle.id()});
        for (int i = 0; i < count; ++i) {
            const float angle = 6.2832f * float(i) / float(count);
            const Vec2 way = turned(angle);
            const Body blade = add((radius + 0.5f * length) * way, angle,
                                   Box{.width = length, .height = random(0.1f, 0.4f)}, 1);
            join(1, middle, blade, radius * way);
        }
        what_ = "windmill";
    }
    /// Boxes, each joined with one that was there at a point of its border.
    void tree(Random& random) {
        const int count = int(random(4, 14));
        add({0, 0}, 0, Box{.width = random(0.2f, 2), .height = random(0.2f, 2)}, 1);
        for (int i = 1; i < count; ++i) {
            const Body parent = bodies_[size_t(random(0, float(i) - 0.01f))];
            const Vec2 way = turned(random(-3.1f, 3.1f));
            const Position at = parent.position() + random(0.1f, 1) * way;
            const float angle = random(-3, 3), width = random(0.2f, 2);
            const Position middle = at + 0.5f * width * turned(angle);
            const Body child =
                add(middle, angle, Box{.width = width, .height = random(0.2f, 2)}, 1);
            join(random(0, 1) < 0.5f ? 1 : 0, parent, child, at);
        }
        what_ = "tree";
    }

    World world_{WorldDef{.gravity = {0, 0}, .sleeping = false}};
    std::vector<Body> bodies_;
    std::string what_;
};

/// A hub with spokes, one of which has two more joints. All that decides whether joints crowd a
/// body is edited.
class EditedHub {
  public:
    EditedHub() {
        for (int i = 0; i < 8; ++i) {
            bodies_.push_back(world_.create_body({.position = i == 0 ? Vec2() : turned(float(i))}));
            bodies_.back().add(Circle{.radius = 0.3f}, {.mask = 0});
        }
        for (size_t i = 1; i < bodies_.size(); ++i) connect(bodies_[0], bodies_[i]);
        connect(bodies_[1], bodies_[2]);
        connect(bodies_[1], bodies_[3]);
    }
    void edit(Random& random) {
        Body body = bodies_[size_t(random(0, 7.99f))];
        const size_t at = size_t(random(0, float(joints_.size()) - 0.01f));
        DistanceJoint& joint = joints_[at];
        switch (int(random(0, 9.99f))) {
            case 0:
                body.set_mass(random(0, 1) < 0.5f ? 0.02f : 5.0f);
                break;
            case 1:
                body.set_inertia(random(0.001f, 1.0f));
                break;
            case 2:
                body.set_type(body.type() == BodyType::dynamic_body ? BodyType::kinematic_body
                                                                    : BodyType::dynamic_body);
                break;
            case 3:
                body.set_enabled(!body.enabled());
                break;
            case 4:
                joint.set_enabled(!joint.enabled());
                break;
            case 5:
                joint.set_broken(!joint.broken());
                break;
            case 6:
                joint.set_hertz(joint.hertz() < 100 ? infinity : 5.0f);
                break;
            case 7:
                joint.set_anchor_a({random(-2, 2), random(-2, 2)});
                break;
            case 8:
                body.set_center(Vec2(random(-1, 1), random(-1, 1)));
                break;
            default:
                if (joint.body_a() != body && joint.body_b() != body) joint.set_body_a(body);
        }
    }
    void replace_a_joint() {
        joints_.front().destroy();
        joints_.erase(joints_.begin());
        connect(bodies_[0], bodies_[4]);
    }
    World& world() { return world_; }

  private:
    void connect(const Body& a, const Body& b) {
        joints_.push_back(world_.create_distance_joint({.body_a = a.id(), .body_b = b.id()}));
    }
    World world_{WorldDef{.gravity = {0, 0}}};
    std::vector<Body> bodies_;
    std::vector<DistanceJoint> joints_;
};

}  // namespace

TEST_CASE("every edit that lets joints crowd a body is noticed") {
    for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        EditedHub hub;
        for (int i = 0; i < 100; ++i) {
            hub.edit(random);
            if (i % 16 == 15) hub.replace_a_joint();
            hub.world().step(1.0f / 60);
            const auto fault = hub.world().validate();
            INFO("seed " << seed << ", edit " << i << ": " << fault.value_or(""));
            REQUIRE(!fault);
        }
    }
}

TEST_CASE("bodies with many joints gain no energy") {
    for (unsigned seed = 0; seed < seeds_or(400); ++seed) {
        Random random{std::mt19937(seed)};
        Jointed jointed(random);
        // The joints do not fit to these velocities: they only take energy away.
        const float first = jointed.energy();
        float greatest = 0, settled = 0;
        for (int i = 0; i < 600; ++i) {
            jointed.step();
            greatest = std::max(greatest, jointed.energy());
            if (i == 60) settled = jointed.energy();
        }
        INFO("seed " << seed << ": " << jointed.what() << ", " << first << " J, then " << greatest);
        CHECK(greatest < 1.05f * first);
        CHECK(jointed.energy() < 1.5f * settled + 1e-3f);
    }
}

}  // namespace crowded_joints_test
