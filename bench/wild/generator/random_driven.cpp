// Bodies that move by command, and fields of force.

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

int kinematic(Sketch& sketch, const Vec2& place, const Geometry& geometry) {
    const int index = sketch.fixed(place, geometry);
    sketch.body(index).def.type = BodyType::kinematic_body;
    return index;
}

void load(Sketch& sketch, const Vec2& place, int count) {
    for (int i = 0; i < count; ++i) {
        const float size = sketch.random.number(0.3f, 0.6f);
        sketch.dynamic(place + Vec2(0.7f * float(i - count / 2), size),
                       random_geometry(sketch.random, size, true));
    }
}

}  // namespace

void random_driven_bodies(Sketch& sketch, float x) {
    Random& random = sketch.random;
    switch (random.whole(0, 4)) {
        case 0: {  // a lift or a ferry
            const int lift = kinematic(sketch, {x, 2}, Box{.width = 3, .height = 0.2f});
            const bool up = random.chance(0.5);
            const float reach = random.number(0.3f, 1.5f);
            sketch.body(lift).swing = {.reach = up ? Vec2{0, reach} : Vec2{reach, 0},
                                       .hertz = random.one_of({0.05f, 0.2f, 0.5f, 1.0f})};
            load(sketch, {x, 2.3f}, random.whole(1, 4));
            break;
        }
        case 1: {  // a paddle
            const int paddle = kinematic(sketch, {x, 1.5f},
                                         Box{.width = 2.5f, .height = random.one_of({0.1f, 0.3f})});
            sketch.body(paddle).def.angular_velocity =
                random.sign() * random.one_of({0.5f, 3.0f, 10.0f, 30.0f});
            sketch.body(paddle).def.bullet = random.chance(0.5);
            load(sketch, {x, 3.5f}, random.whole(1, 4));
            break;
        }
        case 2: {  // a wall that pushes
            const int wall = kinematic(sketch, {x - 3, 1.1f},
                                       Box{.width = random.one_of({0.1f, 0.5f}), .height = 2});
            sketch.body(wall).def.velocity = {random.one_of({0.03f, 0.5f, 3.0f, 10.0f, 20.0f}), 0};
            load(sketch, {x, 0}, random.whole(1, 4));
            break;
        }
        case 3: {  // a conveyor
            const int belt = sketch.fixed({x, 1}, Box{.width = 4, .height = 0.3f});
            sketch.body(belt).shapes[0].def.surface_speed = random.sign() * random.number(0.02f, 6);
            load(sketch, {x, 1.2f}, random.whole(1, 4));
            break;
        }
        default: {  // a bat with a motor, which may be a bullet
            const int bat = sketch.dynamic({x + 1, 2}, Box{.width = 2, .height = 0.15f});
            sketch.body(bat).def.bullet = random.chance(0.5);
            JointPlan& pin = sketch.joint(JointType::revolute, the_world, bat, {x, 2});
            pin.set({"set_motor_speed", {random.sign() * random.one_of({2.0f, 10.0f, 30.0f}), 0}});
            pin.set({"set_max_motor_torque", {random.one_of({10.0f, 100.0f}), 0}});
            load(sketch, {x, 3.5f}, random.whole(1, 4));
        }
    }
}

void random_fields(Sketch& sketch) {
    Random& random = sketch.random;
    FieldDef field;
    switch (random.whole(0, 3)) {
        case 0:
            field.force = WindField{.velocity = {random.number(-15, 15), random.number(-5, 5)}};
            break;
        case 1:
            field.force = DragField{.flow = {random.number(-3, 3), 0},
                                    .linear = random.number(0, 5),
                                    .quadratic = random.number(0, 2)};
            break;
        case 2:
            field.force = BuoyancyField{.level = random.number(0.5f, 4),
                                        .density = random.number(0.5f, 3),
                                        .flow = {random.number(-2, 2), 0}};
            break;
        default:
            field.force = AttractorField{.center = {random.number(-10, 10), random.number(1, 8)},
                                         .strength = random.number(-20, 20),
                                         .falloff = random.whole(0, 2)};
    }
    if (random.chance(0.5))
        field.region = Aabb{{random.number(-15, -1), -2}, {random.number(1, 15), 10}};
    sketch.plan.fields.push_back(field);
}

}  // namespace fettle::bench::wild
