// The ground of worlds: every kind of static support.

#include <functional>

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

constexpr float half_width = 20;  // m

Chain line(float step, float roughness, Random& random) {
    Chain chain;
    for (float x = -half_width; x < half_width + step / 2; x += step)
        chain.points.emplace_back(x, roughness > 0 ? random.number(-roughness, 0) : 0.0f);
    return chain;
}

/// Holds bodies in: floor, walls and, if closed, a ceiling.
Chain bin() {
    return {.points = {{-half_width, 0}, {half_width, 0}, {half_width, 30}, {-half_width, 30}},
            .closed = true};
}

void random_row(Sketch& sketch, float step, const std::function<Geometry(float x)>& part) {
    BodyPlan ground{.def = {.type = BodyType::static_body}};
    const ShapeDef surface = sketch.ground_surface();
    for (float x = -half_width; x < half_width; x += step)
        ground.shapes.push_back({part(x), surface});
    sketch.add(std::move(ground));
}

/// A landscape that is solid down to its base.
Concave terrain(Random& random) {
    Concave drawn{{{half_width, -5}}};
    for (float x = half_width; x > -half_width - 1; x -= 4)
        drawn.vertices.emplace_back(x, random.number(-1.5f, 0));
    drawn.vertices.emplace_back(-half_width, -5.0f);
    return drawn;
}

void random_floor(Sketch& sketch) {
    Random& random = sketch.random;
    switch (random.whole(0, sketch.calm ? 8 : 11)) {
        case 0:
            sketch.fixed({0, 0}, line(10, 0, random));
            break;
        case 1:
            sketch.fixed({0, 0}, line(0.25f, 0, random));
            break;
        case 2:
            sketch.fixed({0, -0.5f}, Box{.width = 2 * half_width, .height = 1});
            break;
        case 3:
            sketch.fixed({0, -0.025f}, Box{.width = 2 * half_width, .height = 0.05f});
            break;
        case 4:
            random_row(sketch, 1, [](float x) {
                return Box{.width = 1, .height = 1, .center = {x + 0.5f, -0.5f}};
            });
            break;
        case 5:
            sketch.plan.def.bounds = Aabb{{-half_width, 0}, {half_width, 30}};
            break;
        case 6:
            random_row(sketch, 1, [](float x) {
                return Segment{{x, -0.05f}, {x + 1, -0.05f}, 0.05f};
            });
            break;
        case 7:
            sketch.fixed({0, 0}, bin());
            break;
        case 8:
            sketch.fixed({0, 0}, Segment{{-half_width, 0}, {half_width, 0}});
            break;
        case 9:
            sketch.fixed({0, 0}, terrain(random));
            break;
        case 10:
            sketch.fixed({0, 0}, line(2, 1.2f, random));
            break;
        default:  // round stones
            random_row(sketch, 1.5f, [](float x) {
                return Circle{.radius = 1, .center = {x, -1}};
            });
    }
}

}  // namespace

void random_ground(Sketch& sketch) {
    random_floor(sketch);
    if (sketch.random.chance(0.5)) {
        for (const float side : {-1.0f, 1.0f})
            sketch.fixed({side * (half_width + 0.5f), 14}, Box{.width = 1, .height = 30});
    }
    for (int i = sketch.random.whole(0, 2); i > 0 && !sketch.calm; --i) {  // platforms
        const Vec2 place{sketch.random.number(-12, 12), sketch.random.number(3, 8)};
        const float width = sketch.random.number(1, 5);
        const int kind = sketch.random.whole(0, 2);
        const int platform =
            kind == 0   ? sketch.fixed(place, Box{.width = width, .height = 0.2f})
            : kind == 1 ? sketch.fixed(place, Chain{.points = {{-width / 2, 0}, {width / 2, 0}}})
                        : sketch.fixed(place, Segment{{-width / 2, 0}, {width / 2, 0}, 0.1f});
        if (sketch.random.chance(0.4))
            sketch.body(platform).def.angle = sketch.random.number(-0.6f, 0.6f);
    }
}

}  // namespace fettle::bench::wild
