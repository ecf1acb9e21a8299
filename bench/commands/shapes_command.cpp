// `fettle-bench shapes`: the cost of contacts and queries by the number of corners of a shape.

#include <fettle/physics/physics.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "commands/commands.h"
#include "measure/timing.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"

namespace fettle::bench {
namespace {

constexpr int pairs = 100;

/// A regular polygon with half a meter from center to corner; with 0 corners, an ellipse of the
/// same size.
physics::Geometry regular_polygon(int corners) {
    if (corners == 0) return physics::Ellipse{.radius_x = 0.5f, .radius_y = 0.499f};
    physics::Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        polygon.vertices.push_back(
            {static_cast<float>(0.5 * std::cos(angle)), static_cast<float>(0.5 * std::sin(angle))});
    }
    return polygon;
}

/// Nanoseconds per step for one shape that spins on `ground`, so that another part of its rim
/// touches in every step. `height`: of the top of the ground, m.
double spinning_ns(const physics::Geometry& form, const physics::Geometry& ground, float height) {
    physics::World world({.sleeping = false, .continuous = false});
    for (int i = 0; i < pairs; ++i) {
        const float x = 4 * static_cast<float>(i);
        world.create_body({.type = physics::BodyType::static_body, .position = {x, 0}})
            .add(ground, {.friction = 0});
        world
            .create_body({.position = {x, height + 0.5f},
                          .angle = static_cast<float>(i),
                          .angular_velocity = 2,
                          .locked_x = true})
            .add(form, {.friction = 0});
    }
    constexpr int steps = 200;
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    const ThreadClock clock;
    for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
    return 1e6 * clock.elapsed_ms() / (steps * pairs);
}

/// A hundred static bodies, 3 m apart in rows of ten.
struct Field {
    physics::World world;
    std::vector<physics::Shape> shapes;

    explicit Field(const physics::Geometry& form) {
        for (int i = 0; i < pairs; ++i) {
            physics::Body body = world.create_body({.type = physics::BodyType::static_body,
                                                    .position = place(i),
                                                    .angle = static_cast<float>(i)});
            shapes.push_back(body.add(form));
        }
    }
    static physics::Vec2 place(int i) {
        return {3 * static_cast<float>(i % 10), 3 * static_cast<float>(i / 10)};
    }
};

/// Nanoseconds for the distance between two shapes of a `Field`.
double distance_between(const physics::Geometry& form) {
    const Field field(form);
    const auto& shapes = field.shapes;
    float sum = 0;
    const ThreadClock clock;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t k = i + 1; k < shapes.size(); ++k)
            sum += physics::distance(shapes[i], shapes[k]).distance;
    const double elapsed = clock.elapsed_ms();
    if (!(sum > 0)) throw std::runtime_error("no distance between shapes that are apart");
    return 1e6 * elapsed / (pairs * (pairs - 1) / 2.0);
}

/// Nanoseconds for a query about one shape of a `Field`. `query` gets the center of the shape
/// and a unit vector to a point beside it, and returns whether the query found the shape.
template <class Query>
double query_ns(const physics::Geometry& form, Query&& query) {
    Field field(form);
    constexpr int rounds = 20;
    int found = 0;
    const ThreadClock clock;
    for (int round = 0; round < rounds; ++round) {
        const float angle = static_cast<float>(round);
        const physics::Vec2 beside(std::cos(angle), std::sin(angle));
        for (int i = 0; i < pairs; ++i)
            found += query(field.world, Field::place(i), beside) ? 1 : 0;
    }
    const double elapsed = clock.elapsed_ms();
    if (found != rounds * pairs) throw std::runtime_error("a query did not find its shape");
    return 1e6 * elapsed / (rounds * pairs);
}

double ray(const physics::Geometry& form) {
    return query_ns(
        form, [](physics::World& world, const physics::Vec2& center, const physics::Vec2& beside) {
            return world.cast_ray(center + beside, center).has_value();
        });
}
double point(const physics::Geometry& form) {
    return query_ns(
        form, [](physics::World& world, const physics::Vec2& center, const physics::Vec2& beside) {
            return !world.query_point(center + 0.3f * beside).empty();
        });
}
double closest(const physics::Geometry& form) {
    return query_ns(
        form, [](physics::World& world, const physics::Vec2& center, const physics::Vec2& beside) {
            return world.closest(center + beside, 1.0f).has_value();
        });
}
/// Casts a box against the shape.
double shape_cast(const physics::Geometry& form) {
    physics::World world;
    const physics::Shape box =
        world.create_body({}).add(physics::Box{.width = 0.2f, .height = 0.1f});
    return query_ns(form, [&](physics::World& searched, const physics::Vec2& center,
                              const physics::Vec2& beside) {
        box.body().set_position(center + beside);
        return searched.cast_shape(box, -beside).has_value();
    });
}

/// Grounds on which a shape spins; the top of each is at a height of half a meter.
const physics::Geometry box = physics::Box{.width = 3, .height = 1};
const physics::Geometry round_hill = physics::Ellipse{.radius_x = 1, .radius_y = 0.5f};
const physics::Geometry bent_chain = physics::Chain{{{-2, 0.5f}, {0.01f, 0.5f}, {2, 0.5f}}};
const physics::Geometry concave =
    physics::Concave{{{1, 0.5f}, {-1, 0.5f}, {-1, -0.5f}, {0, 0.2f}, {1, -0.5f}}};

struct Column {
    const char* title;
    double (*measure)(const physics::Geometry& form);
};
const Column columns[] = {
    {"on a box", [](const auto& form) { return spinning_ns(form, box, 0.5f); }},
    {"on another", [](const auto& form) { return spinning_ns(form, form, 0.5f); }},
    {"ellipse", [](const auto& form) { return spinning_ns(form, round_hill, 0.5f); }},
    {"chain", [](const auto& form) { return spinning_ns(form, bent_chain, 0.5f); }},
    {"concave", [](const auto& form) { return spinning_ns(form, concave, 0.5f); }},
    {"distance", distance_between},
    {"ray", ray},
    {"point", point},
    {"closest", closest},
    {"shape cast", shape_cast},
};

struct ShapeRow {
    int corners;
    std::vector<double> values;  ///< one per column
};

template <class Measure>
double median_of(int runs, Measure&& measure) {
    std::vector<double> values;
    for (int i = 0; i < runs; ++i) values.push_back(measure());
    return median(std::move(values));
}

ShapeRow measure(int corners, int runs) {
    const physics::Geometry form = regular_polygon(corners);
    ShapeRow row{corners, {}};
    for (const Column& column : columns)
        row.values.push_back(median_of(runs, [&] { return column.measure(form); }));
    return row;
}

std::string name_of(const ShapeRow& row) {
    return row.corners == 0 ? "ellipse" : std::to_string(row.corners);
}

}  // namespace

int run_shapes(const ShapesOptions& options) {
    std::vector<ShapeRow> rows;
    {
        const std::vector<int> sizes = {4, 8, 9, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 0};
        Progress progress(static_cast<double>(sizes.size()));
        for (int corners : sizes) {
            progress.begin(std::to_string(corners) + " corners");
            rows.push_back(measure(corners, options.runs));
            progress.add(1);
        }
    }
    std::vector<std::string> titles = {"corners"};
    for (const Column& column : columns) titles.emplace_back(column.title);
    Table table(titles);
    for (const ShapeRow& row : rows) {
        if (options.json) {
            for (std::size_t i = 0; i < row.values.size(); ++i)
                std::cout << json_line({{"corners", name_of(row)},
                                        {"what", columns[i].title},
                                        {"ns", row.values[i]}})
                          << "\n";
            continue;
        }
        std::vector<std::string> cells = {name_of(row)};
        for (const double value : row.values) cells.push_back(figure(value));
        table.add(cells);
    }
    if (!options.json)
        std::cout
            << "Nanoseconds of a step, by the ground on which the shape spins; and of a query.\n\n"
            << table.text();
    return 0;
}

}  // namespace fettle::bench
