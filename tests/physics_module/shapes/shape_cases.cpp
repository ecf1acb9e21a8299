#include <cmath>
#include <limits>

#include "catch.h"
#include "stage.h"

namespace fettle::physics_module::testing {
namespace {

const property::Color green{0, 1, 0, 1};

bool fell_through(Stage& stage) {
    return stage.game.y(stage.body) < 0.0;
}
void drop(Stage& stage) {
    stage.game.set(stage.body, "position", Vec2(0, 3));
}
void roll(Stage& stage) {
    stage.game.set(stage.body, "velocity", Vec2(2, 0));
    stage.game.set(stage.body, "angular_velocity", -4);
}
bool bounced(Stage& stage) {
    return stage.fastest_rise > 3;
}

Case make_case(Value value, int steps, std::function<bool(Stage&)> effect) {
    Case one;
    one.value = to(std::move(value));
    one.steps = steps;
    one.effect = std::move(effect);
    return one;
}

/// The same case for a shape of another class.
Case of(std::string shape, Case one) {
    one.shape = std::move(shape);
    return one;
}

double aabb_width(Stage& stage) {
    const List box = stage.game.get(stage.shape, "aabb").list();
    return box[1].vec2().x - box[0].vec2().x;
}

}  // namespace

Cases shape_cases() {
    Cases cases;
    cases["Shape.density"] = make_case(5, 30, [](Stage& s) {
        return s.load() > 45 && s.game.number(s.body, "mass") == Approx(5);
    });
    Case& friction = cases["Shape.friction"] =
        make_case(0, 30, [](Stage& s) { return s.game.x(s.body) > 0.1; });
    friction.prepare = [](Stage& s) { s.game.set(s.body, "force", Vec2(3, 0)); };
    cases["Shape.restitution"] = make_case(1, 120, bounced);
    cases["Shape.restitution"].then = drop;
    Case& rolling = cases["Shape.rolling_resistance"] =
        make_case(0.5, 120, [](Stage& s) { return s.game.x(s.body) < 1.5; });
    rolling.shape = "Circle";
    rolling.then = roll;
    cases["Shape.surface_speed"] =
        make_case(2, 60, [](Stage& s) { return std::fabs(s.game.x(s.body)) > 0.5; });
    cases["Shape.material"] =
        make_case(7, 1, [](Stage& s) { return s.game.get(s.shape, "material").integer() == 7; });
    const auto count = [](const char* name) {
        return [name](Stage& s) {
            const auto& event = *s.game.tree.class_of(s.body).event(name);
            s.game.tree.on(s.body, event, [&s](const property::Occurrence&) { ++s.hits; });
        };
    };
    const auto drop_silently = [](Stage& s) {
        s.hits = 0;
        drop(s);
    };
    const auto nothing_heard = [](Stage& s) { return s.hits == 0; };
    Case& touches = cases["Shape.contact_events"] = make_case(false, 120, nothing_heard);
    touches.prepare = count("contact_begin");
    touches.then = drop_silently;
    Case& sensed = cases["Shape.sensor_events"] = make_case(false, 120, nothing_heard);
    sensed.prepare = [count](Stage& s) {
        s.other = s.game.body("Box", Vec2(0, 2));
        s.game.set(s.other, "type", "static");
        s.game.set(s.game.shape_of(s.other), "sensor", true);
        count("sensor_begin")(s);
    };
    sensed.then = drop_silently;
    cases["Shape.sensor"] = make_case(true, 40, fell_through);
    Case& category = cases["Shape.category"] = make_case(2, 40, fell_through);
    category.prepare = [](Stage& s) { s.game.set(s.game.shape_of(s.floor), "mask", 1); };
    cases["Shape.mask"] = make_case(2, 40, fell_through);
    Case& group = cases["Shape.group"] = make_case(-3, 40, fell_through);
    group.prepare = [](Stage& s) { s.game.set(s.game.shape_of(s.floor), "group", -3); };
    cases["Shape.color"] =
        make_case(green, 1, [](Stage& s) { return s.draw().figures.at(0).paint.fill == green; });
    cases["Shape.border"] =
        make_case(green, 1, [](Stage& s) { return s.draw().figures.at(0).paint.border == green; });
    cases["Shape.visible"] = make_case(false, 1, [](Stage& s) { return s.draw().figures.empty(); });
    return cases;
}

namespace {

/// A chain between the body and the floor, whose segments get surfaces of their own.
void add_segment_cases(Cases& cases) {
    const auto on_chain = [](Stage& s) {
        s.other = s.game.make("Body", s.world, {{"type", "static"}});
        s.game.make("Chain", s.other, {{"points", List{Vec2(-20, 0), Vec2(-9, 0), Vec2(20, 0)}}});
        s.game.set(s.body, "position", Vec2(0, 0.5));
        s.game.set(s.game.shape_of(s.floor), "mask", 0);
    };
    const double same = std::numeric_limits<double>::infinity();
    const auto add = [&](const char* name, List value, int steps, auto effect) -> Case& {
        Case& one = cases[name] = make_case(std::move(value), steps, effect);
        one.prepare = on_chain;
        one.subject = [](Stage& s) { return s.game.shape_of(s.other); };
        return one;
    };
    add("Chain.segment_friction", {same, 0.0}, 30, [](Stage& s) {
        return s.game.x(s.body) > 0.1;
    }).prepare = [on_chain](Stage& s) {
        on_chain(s);
        s.game.set(s.body, "force", Vec2(3, 0));
    };
    add("Chain.segment_restitution", {same, 1.0}, 120, bounced).then = drop;
    Case& rolling = add("Chain.segment_rolling_resistance", {same, 0.5}, 120,
                        [](Stage& s) { return s.game.x(s.body) < 1.5; });
    rolling.shape = "Circle";
    rolling.then = roll;
    add("Chain.segment_surface_speed", {same, 2.0}, 60,
        [](Stage& s) { return std::fabs(s.game.x(s.body)) > 0.5; });
    add("Chain.segment_material", {-1, 7}, 1, [](Stage& s) {
        const auto contacts = s.game.physics.body(s.body).contacts();
        return !contacts.empty() && contacts[0].material_a + contacts[0].material_b == 7;
    });
}

}  // namespace

Cases form_cases() {
    const auto rises_to = [](double height) {
        return [height](Stage& s) { return s.game.y(s.body) > height; };
    };
    const auto sinks_to = [](double height) {
        return [height](Stage& s) { return s.game.y(s.body) < height; };
    };
    Cases cases;
    cases["Circle.radius"] = of("Circle", make_case(0.8, 60, rises_to(0.75)));
    const auto has_line = [](Stage& s) {
        const auto is_line = [](const Figure& figure) { return figure.kind == "line"; };
        return std::ranges::any_of(s.draw().figures, is_line);
    };
    cases["Circle.orientation_mark"] = of("Circle", make_case(true, 1, has_line));
    cases["Ellipse.orientation_mark"] = of("Ellipse", make_case(true, 1, has_line));
    cases["Circle.center"] = of("Circle", make_case(Vec2(0, 0.3), 30, sinks_to(0.3)));
    cases["Box.width"] = make_case(
        3, 30, [](Stage& s) { return s.load() > 28 && aabb_width(s) == Approx(3).margin(0.01); });
    cases["Box.height"] = make_case(2, 60, rises_to(0.95));
    cases["Box.center"] = make_case(Vec2(0, 0.3), 30, sinks_to(0.3));
    cases["Box.angle"] = make_case(0.785, 15, rises_to(0.6));
    cases["Box.rounding"] = make_case(0.3, 30, [](Stage& s) {
        const Picture picture = s.draw();
        return picture.figures.at(0).size == Approx(0.3) && s.load() < 9.5;
    });
    cases["Segment.from"] = of("Segment", make_case(Vec2(-0.5, -0.5), 60, rises_to(0.2)));
    cases["Segment.to"] = of("Segment", make_case(Vec2(0.5, -0.5), 60, rises_to(0.2)));
    cases["Capsule.from"] = of("Capsule", make_case(Vec2(-0.25, -0.5), 15, rises_to(0.35)));
    cases["Capsule.to"] = of("Capsule", make_case(Vec2(0.25, -0.5), 15, rises_to(0.35)));
    cases["Capsule.radius"] = of("Capsule", make_case(0.6, 60, rises_to(0.55)));
    const List tall = {Vec2(-0.5, -0.9), Vec2(0.5, -0.9), Vec2(0, 0.5)};
    cases["Polygon.vertices"] = of("Polygon", make_case(tall, 60, rises_to(0.8)));
    cases["Polygon.rounding"] = of("Polygon", make_case(0.3, 60, rises_to(0.75)));
    cases["Ellipse.radius_x"] =
        of("Ellipse",
           make_case(0.9, 1, [](Stage& s) { return aabb_width(s) == Approx(1.8).margin(0.01); }));
    cases["Ellipse.radius_y"] = of("Ellipse", make_case(0.4, 60, rises_to(0.35)));
    cases["Ellipse.center"] = of("Ellipse", make_case(Vec2(0, 0.2), 30, sinks_to(0.1)));
    cases["Ellipse.angle"] = of("Ellipse", make_case(1.5707963, 15, rises_to(0.35)));
    cases["Concave.vertices"] =
        of("Concave", make_case(List{Vec2(-0.5, -0.9), Vec2(0.5, -0.9), Vec2(0.5, 0.5),
                                     Vec2(0, -0.5), Vec2(-0.5, 0.5)},
                                60, rises_to(0.8)));
    // A segment is solid on its left: one from right to left stands on a body below it.
    const List sole = {Vec2(0.5, -0.5), Vec2(-0.5, -0.5), Vec2(0, 0.5)};
    const List stilts = {Vec2(0.5, -0.9), Vec2(-0.5, -0.9), Vec2(0, 0.5)};
    const auto stand = [sole](Stage& s) { s.game.set(s.shape, "points", sole); };
    Case& points = cases["Chain.points"] = of("Chain", make_case(stilts, 60, rises_to(0.8)));
    points.prepare = stand;
    Case& closed = cases["Chain.closed"] =
        of("Chain", make_case(true, 1, [](Stage& s) { return s.draw().figures.size() == 3; }));
    closed.prepare = stand;
    add_segment_cases(cases);
    return cases;
}

}  // namespace fettle::physics_module::testing
