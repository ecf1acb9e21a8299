// Edits while the world runs: of everything that games change, and objects that come and go.

#include "wild/generator/sketch.h"
#include "wild/plans/setters.h"

namespace fettle::bench::wild {
namespace {

Edit of_body(Random& random, int body) {
    const auto edit = [&](const char* setter, const Vec2& value) {
        return Edit{.target = Target::body, .object = body, .setting = {setter, value}};
    };
    switch (random.whole(0, 10)) {
        case 0:
            return edit("destroy", {0, 0});
        case 1:
            return edit("set_type", {float(random.whole(0, 2)), 0});
        case 2:
            return edit("set_position", {random.number(-10, 10), random.number(2, 10)});
        case 3:
            return edit("set_velocity", {random.number(-20, 20), random.number(-20, 20)});
        case 4:
            return edit("set_angular_velocity", {random.number(-30, 30), 0});
        case 5:
            return edit("apply_impulse", {random.number(-5, 5), random.number(-5, 5)});
        case 6:
            return edit("set_gravity_scale", {random.one_of({0.0f, 0.5f, -0.5f}), 0});
        case 7:
            return edit("set_awake", {float(random.whole(0, 1)), 0});
        case 8:
            return edit("set_angle", {random.number(-3, 3), 0});
        case 9:
            return edit("set_locked_rotation", {float(random.whole(0, 1)), 0});
        default:
            return edit("set_bullet", {float(random.whole(0, 1)), 0});
    }
}

Edit of_shape(Random& random, int body, int shape) {
    Edit edit{.target = Target::shape, .object = body, .shape = shape};
    switch (random.whole(0, 7)) {
        case 0:
            edit.setting = {"set_friction", {random.one_of({0.0f, 0.3f, 1.0f}), 0}};
            break;
        case 1:
            edit.setting = {"set_restitution", {random.one_of({0.0f, 0.5f, 1.0f}), 0}};
            break;
        case 2:
            edit.setting = {"set_density", {random.one_of({0.5f, 2.0f}), 0}};
            break;
        case 3:
            edit.setting = {"set_surface_speed", {random.number(-4, 4), 0}};
            break;
        case 4:
            edit.setting = {"set_sensor", {float(random.whole(0, 1)), 0}};
            break;
        case 5:
            edit.setting = {"set_mask", {float(random.whole(0, 1)), 0}};
            break;
        case 6:
            edit.setting = {"destroy", Vec2{}};
            break;
        default:
            edit.setting = {"set_geometry", Vec2{}};
            edit.geometry = random_geometry(random, random.number(0.2f, 1.5f), true);
    }
    return edit;
}

Edit of_world(Random& random) {
    Edit edit{.target = Target::world};
    switch (random.whole(0, 3)) {
        case 0:
            edit.setting = {"set_gravity", {random.number(-10, 10), random.number(-15, 5)}};
            break;
        case 1:
            edit.setting = {"set_substeps", {float(random.whole(2, 8)), 0}};
            break;
        case 2:
            edit.setting = {"set_solver", {float(random.whole(0, 2)), 0}};
            break;
        default:
            edit.setting = {"set_sleeping", {float(random.whole(0, 1)), 0}};
    }
    return edit;
}

Edit of_joint(Random& random, const JointPlan& joint, int index) {
    Edit edit{.target = Target::joint, .object = index};
    const auto set = [&](const char* setter, const Vec2& value) { edit.setting = {setter, value}; };
    switch (random.whole(0, 3)) {
        case 0:
            set("destroy", {0, 0});
            return edit;
        case 1:
            set("set_enabled", {float(random.whole(0, 1)), 0});
            return edit;
        default:
            break;
    }
    switch (joint.type) {
        case JointType::mouse:
            set("set_target", joint.anchor_a + Vec2{random.number(-3, 3), random.number(-1, 3)});
            break;
        case JointType::distance:
            set("set_length", {random.number(0.3f, 2), 0});
            break;
        case JointType::revolute:
        case JointType::wheel:
        case JointType::prismatic:
        case JointType::pin_slot:
            set("set_motor_speed", {random.number(-8, 8), 0});
            break;
        case JointType::motor:
            set("set_linear_offset", {random.number(-1, 1), random.number(-1, 1)});
            break;
        default:
            set("set_enabled", {0, 0});
    }
    return edit;
}

}  // namespace

void random_edits(Sketch& sketch) {
    Random& random = sketch.random;
    WorldPlan& plan = sketch.plan;
    for (int i = random.whole(1, 6); i > 0; --i) {
        Edit edit;
        const int body = random.whole(0, int(plan.bodies.size()) - 1);
        // Static bodies are edited less often: without its ground, the world would fall for the
        // rest of its time.
        const bool spared = is_fixed(plan.bodies[std::size_t(body)]) && !random.chance(0.2);
        const int joints = int(plan.joints.size());
        if (random.chance(0.1))
            edit = of_world(random);
        else if (joints > 0 && random.chance(0.4)) {
            const int joint = random.whole(0, joints - 1);
            edit = of_joint(random, plan.joints[std::size_t(joint)], joint);
        } else if (spared)
            continue;
        else if (random.chance(0.5))
            edit = of_body(random, body);
        else
            edit = of_shape(random, body,
                            random.whole(0, int(plan.bodies[std::size_t(body)].shapes.size()) - 1));
        edit.step = random.whole(1, plan.steps * 2 / 3);
        plan.edits.push_back(std::move(edit));
    }
}

}  // namespace fettle::bench::wild
