// A joint of a random type with random settings, between two bodies or a body and the world. Gears,
// ratchets and pulleys are in random_contraptions.cpp.

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

void random_motor(Sketch& sketch, JointPlan& joint, const char* strength) {
    if (!sketch.random.chance(0.4)) return;
    joint.set({"set_motor_speed", {sketch.random.sign() * sketch.random.number(0, 8), 0}});
    joint.set({strength, {sketch.random.one_of({1.0f, 10.0f, 50.0f}), 0}});
}

void random_translations(Sketch& sketch, JointPlan& joint) {
    if (!sketch.random.chance(0.7)) return;
    joint.set({"set_lower_translation", {-sketch.random.number(0, 1.5f), 0}});
    joint.set({"set_upper_translation", {sketch.random.number(0, 1.5f), 0}});
}

void random_settings(Sketch& sketch, JointPlan& joint) {
    Random& random = sketch.random;
    const float between = sketch.angle_between(joint.a, joint.b);
    const Vec2 axis = random.one_of<Vec2>({{1, 0}, {0, 1}, {0.6f, 0.8f}});
    switch (joint.type) {
        case JointType::revolute:
            joint.set({"set_reference_angle", {between, 0}});
            if (random.chance(0.5)) {
                joint.set({"set_lower_angle", {-random.number(0, 2), 0}});
                joint.set({"set_upper_angle", {random.number(0, 2), 0}});
            }
            random_motor(sketch, joint, "set_max_motor_torque");
            if (random.chance(0.2)) joint.set({"set_hertz", {random.number(1, 10), 0}});
            break;
        case JointType::prismatic:
            joint.set({"set_reference_angle", {between, 0}});
            joint.set({"set_axis", axis});
            random_translations(sketch, joint);
            random_motor(sketch, joint, "set_max_motor_force");
            break;
        case JointType::pin_slot:
            joint.set({"set_axis", axis});
            random_translations(sketch, joint);
            random_motor(sketch, joint, "set_max_motor_force");
            break;
        case JointType::wheel:
            joint.set({"set_hertz", {random.one_of({0.0f, 2.0f, 8.0f}), 0}});
            random_translations(sketch, joint);
            random_motor(sketch, joint, "set_max_motor_torque");
            break;
        case JointType::weld:
            joint.set({"set_reference_angle", {between, 0}});
            if (random.chance(0.3)) joint.set({"set_angular_hertz", {random.number(1, 10), 0}});
            break;
        case JointType::groove:
            joint.set({"set_end", joint.anchor_a + random.one_of<Vec2>({{1.5f, 0}, {0, -2}})});
            break;
        case JointType::motor:
            joint.set({"set_max_force", {random.one_of({5.0f, 50.0f}), 0}});
            joint.set({"set_max_torque", {random.one_of({0.0f, 5.0f}), 0}});
            if (random.chance(0.5)) joint.set({"set_hertz", {random.number(1, 8), 0}});
            break;
        default:
            break;
    }
}

}  // namespace

void random_joint_of_any_type(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const Vec2 place{x, random.number(2, 6)};
    const auto part = [&](const Vec2& at) {
        BodyPlan body{.def = {.position = at, .angle = random.one_of({0.0f, 0.5f})}};
        random_shapes(sketch, body, random.number(0.4f, 1.2f));
        return sketch.add(std::move(body));
    };
    const int a = random.chance(0.4) ? the_world : part(place);
    const int b = part(place + Vec2{1.5f, 0});
    const Vec2 at = place + Vec2{random.one_of({0.0f, 0.75f, 1.5f}), 0};
    const auto type = random.one_of({JointType::mouse, JointType::distance, JointType::revolute,
                                     JointType::prismatic, JointType::wheel, JointType::weld,
                                     JointType::motor, JointType::groove, JointType::pin_slot});
    if (type == JointType::mouse) {
        JointPlan& mouse = sketch.joint(type, the_world, b, place, place + Vec2{1.5f, 0});
        mouse.anchor_a = place + Vec2{random.number(-2, 2), random.number(0, 2)};
        mouse.set({"set_max_force", {random.one_of({20.0f, 200.0f}), 0}});
        return;
    }
    if (type == JointType::distance) {
        const Vec2 to = place + Vec2{1.5f, 0};
        JointPlan& rod = sketch.joint(type, a, b, place, to);
        rod.set({"set_length", {(to - place).length(), 0}});
        if (random.chance(0.5)) rod.set({"set_hertz", {random.one_of({0.0f, 2.0f, 6.0f}), 0}});
        if (random.chance(0.5)) rod.set({"set_max_length", {2, 0}});
        return;
    }
    JointPlan& joint = sketch.joint(type, a, b, at);
    joint.collide = random.chance(0.1);
    random_settings(sketch, joint);
}

}  // namespace fettle::bench::wild
