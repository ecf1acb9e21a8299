// `fettle-bench shapes`: what a contact costs by the number of vertices.

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

/// A regular polygon, half a metre from center to corner; of no corners: an ellipse as large.
physics::Geometry rounded(int corners) {
    if (corners == 0) return physics::Ellipse{.radius_x = 0.5f, .radius_y = 0.499f};
    physics::Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        polygon.vertices.push_back(
            {static_cast<float>(0.5 * std::cos(angle)), static_cast<float>(0.5 * std::sin(angle))});
    }
    return polygon;
}

/// Nanoseconds that one of them costs in a step while it spins on `ground`, whose top is at
/// `height`: another part of the rim touches in every step.
double spinning(const physics::Geometry& form, const physics::Geometry& ground, float height) {
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

/// Nanoseconds of the distance between two of them.
double distance_between(const physics::Geometry& form) {
    physics::World world;
    std::vector<physics::Shape> shapes;
    for (int i = 0; i < pairs; ++i) {
        physics::Body body = world.create_body(
            {.type = physics::BodyType::static_body,
             .position = {3 * static_cast<float>(i % 10), 3 * static_cast<float>(i / 10)},
             .angle = static_cast<float>(i)});
        shapes.push_back(body.add(form));
    }
    float sum = 0;
    const ThreadClock clock;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t k = i + 1; k < shapes.size(); ++k)
            sum += physics::distance(shapes[i], shapes[k]).distance;
    const double elapsed = clock.elapsed_ms();
    if (!(sum > 0)) throw std::runtime_error("no distance between shapes that are apart");
    return 1e6 * elapsed / (pairs * (pairs - 1) / 2.0);
}

struct Row {
    int corners;
    double on_box, on_itself, distance;
};

template <class Measure>
double median_of(int runs, Measure&& measure) {
    std::vector<double> values;
    for (int i = 0; i < runs; ++i) values.push_back(measure());
    return median(std::move(values));
}

Row measure(int corners, int runs) {
    const physics::Geometry form = rounded(corners);
    const physics::Geometry box = physics::Box{.width = 3, .height = 1};
    return {corners, median_of(runs, [&] { return spinning(form, box, 0.5f); }),
            median_of(runs, [&] { return spinning(form, form, 0.5f); }),
            median_of(runs, [&] { return distance_between(form); })};
}

std::string name_of(const Row& row) {
    return row.corners == 0 ? "ellipse" : std::to_string(row.corners);
}

}  // namespace

int run_shapes(const ShapesOptions& options) {
    std::vector<Row> rows;
    {
        const std::vector<int> sizes = {4, 8, 9, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 0};
        Progress progress(static_cast<double>(sizes.size()));
        for (int corners : sizes) {
            progress.begin(std::to_string(corners) + " corners");
            rows.push_back(measure(corners, options.runs));
            progress.add(1);
        }
    }
    Table table({"corners", "step on a box, ns", "step on another, ns", "distance, ns"});
    for (const Row& row : rows) {
        if (options.json) {
            std::cout << json_line({{"corners", name_of(row)},
                                    {"on_box_ns", row.on_box},
                                    {"on_itself_ns", row.on_itself},
                                    {"distance_ns", row.distance}})
                      << "\n";
            continue;
        }
        table.add({name_of(row), figure(row.on_box), figure(row.on_itself), figure(row.distance)});
    }
    if (!options.json) std::cout << table.text();
    return 0;
}

}  // namespace fettle::bench
