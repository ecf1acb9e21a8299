// `fettle-bench growth`: time and memory per body in worlds with a thousand to a hundred thousand
// bodies.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/commands.h"
#include "engines/fettle_engine.h"
#include "measure/simulation.h"
#include "measure/timing.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

const Bound body_bytes_bound = below(1024);   // for a sleeping body with one shape
constexpr std::size_t steps_in_all = 220000;  // divided by the number of bodies
constexpr std::size_t least_steps = 4;

/// Worlds of one kind, from the smallest to the largest.
struct Series {
    std::string name;
    std::vector<Scene> scenes;
    int settling_steps = 0;  // until the bodies rest
    Bound bound;             // time per body divided by that in the first world
};

struct TimeRow {
    std::size_t bodies = 0;
    std::vector<double> us;  // per body and step, by run
    // Wall time per body and step by stage, µs; mean of all runs.
    double narrow = 0, solve = 0, finish = 0, other = 0;
    int steps = 0;
};

void add_stages(const physics::StepStatistics& step, TimeRow& row) {
    row.narrow += static_cast<double>(step.narrow_ms);
    row.solve += static_cast<double>(step.solve_ms);
    row.finish += static_cast<double>(step.finish_ms);
    row.other +=
        static_cast<double>(step.total_ms - step.narrow_ms - step.solve_ms - step.finish_ms);
    ++row.steps;
}

/// Pyramids of 55 bodies: many small islands.
Series pyramids() {
    Series series{"many_pyramids", {}, 30, at_most(1.5)};
    for (const int count : {18, 182, 1818}) series.scenes.push_back(pyramids_of(count));
    return series;
}

/// Boxes that lie in one bin: one island.
Series piles() {
    Series series{"pile", {}, 300, at_most(1.3)};
    for (const auto& [columns, rows] : {std::pair{50, 20}, {160, 63}, {500, 200}})
        series.scenes.push_back(pile_of(columns, rows));
    return series;
}

/// Runs all worlds in turns, so that a disturbance affects all of them.
std::vector<TimeRow> time_rows(const Series& series, int runs, Progress& progress) {
    std::vector<TimeRow> rows(series.scenes.size());
    std::vector<std::unique_ptr<Engine>> worlds;
    progress.begin(series.name);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        worlds.push_back(make_fettle(series.scenes[k]));
        measured_steps(*worlds[k], series.settling_steps);
        rows[k].bodies = fettle_world(*worlds[k]).statistics().awake_bodies;
    }
    for (int run = 0; run < runs; ++run) {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            TimeRow& row = rows[k];
            const std::size_t steps = std::max(least_steps, steps_in_all / row.bodies);
            const ThreadClock clock;
            for (std::size_t i = 0; i < steps; ++i) {
                worlds[k]->step();
                add_stages(fettle_world(*worlds[k]).statistics(), row);
            }
            row.us.push_back(1e3 * clock.elapsed_ms() / static_cast<double>(steps * row.bodies));
        }
        progress.add(1);
    }
    for (TimeRow& row : rows) {
        const double share = 1e3 / row.steps / static_cast<double>(row.bodies);
        for (double* stage : {&row.narrow, &row.solve, &row.finish, &row.other}) *stage *= share;
    }
    return rows;
}

/// Sleeping bodies, and the memory of their world by purpose.
struct Sleepers {
    double bodies = 0;
    std::vector<physics::MemoryShare> memory;
};

Sleepers sleepers_of(Scene scene) {
    scene.sleeping = true;
    const std::unique_ptr<Engine> engine = make_fettle(scene);
    measured_steps(*engine, 100);
    const physics::World& world = fettle_world(*engine);
    if (world.statistics().awake_bodies > 0)
        throw std::runtime_error(scene.name + ": boxes that rest do not sleep");
    return {static_cast<double>(scene.bodies.size()), world.memory()};
}

/// Boxes that rest on the ground without touching each other.
Scene row_of(int count) {
    Scene scene{.name = "row"};
    scene.bodies.push_back(fixed_box({0, -1}, {2.0f * static_cast<float>(count), 1}));
    for (int i = 0; i < count; ++i)
        scene.bodies.push_back(dynamic_box({2.0f * static_cast<float>(i - count / 2), 0.5f}, 0.5f));
    return scene;
}

void print_times(const Series& series, const std::vector<TimeRow>& rows,
                 const OutputOptions& output, Verdict& verdict) {
    Table table({series.name, "us a body and step", "of the first", "bound", "narrow", "solve",
                 "finish", "other"});
    const double first = median(rows.front().us);
    for (const TimeRow& row : rows) {
        const double us = median(row.us), growth = us / first;
        const Bound bound = &row == &rows.front() ? Bound{} : series.bound;
        if (output.json)
            std::cout << json_line({{"scene", series.name},
                                    {"bodies", static_cast<long long>(row.bodies)},
                                    {"us", us},
                                    {"growth", growth},
                                    {"at_most", bound ? JsonField(bound.value) : JsonField()}})
                      << "\n";
        table.add({std::to_string(row.bodies), figure(us),
                   verdict.mark(series.name + " of " + std::to_string(row.bodies), growth, bound,
                                figure(growth), "of the time a body takes in the first world"),
                   bound.text(), figure(row.narrow), figure(row.solve), figure(row.finish),
                   figure(row.other)});
    }
    if (!output.json) std::cout << table.text() << "\n";
}

/// Prints bytes per body by purpose. Reserved memory is included.
void print_memory(const Sleepers& row, const Sleepers& pyramids, const OutputOptions& output,
                  Verdict& verdict) {
    Table table(
        {"a sleeping body", "on the ground", "with room", "bound", "in a pyramid", "with room"});
    std::array<double, 4> all = {};
    const auto add = [&](const char* purpose, const std::array<double, 4>& bytes,
                         const Bound& bound) {
        if (output.json)
            std::cout << json_line({{"memory", purpose},
                                    {"on_ground", bytes[0]},
                                    {"on_ground_with_room", bytes[1]},
                                    {"at_most", bound ? JsonField(bound.value) : JsonField()},
                                    {"in_pyramid", bytes[2]},
                                    {"in_pyramid_with_room", bytes[3]}})
                      << "\n";
        table.add({purpose, figure(bytes[0]),
                   verdict.mark("a sleeping body", bytes[1], bound, figure(bytes[1], 4), "bytes"),
                   bound.text(), figure(bytes[2], 4), figure(bytes[3], 4)});
    };
    for (std::size_t i = 0; i < row.memory.size(); ++i) {
        const auto of = [](std::size_t bytes, const Sleepers& sleepers) {
            return static_cast<double>(bytes) / sleepers.bodies;
        };
        const std::array bytes = {of(row.memory[i].used, row), of(row.memory[i].reserved, row),
                                  of(pyramids.memory[i].used, pyramids),
                                  of(pyramids.memory[i].reserved, pyramids)};
        for (std::size_t k = 0; k < all.size(); ++k) all[k] += bytes[k];
        if (bytes[1] > 0.1) add(row.memory[i].purpose, bytes, {});
    }
    add("in all", all, body_bytes_bound);
    if (!output.json) std::cout << table.text();
}

}  // namespace

int run_growth(const GrowthOptions& options) {
    Verdict verdict("growth");
    for (const Series& series : {pyramids(), piles()}) {
        std::vector<TimeRow> rows;
        {
            Progress progress(options.runs);
            rows = time_rows(series, options.runs, progress);
        }
        print_times(series, rows, options.output, verdict);
    }
    print_memory(sleepers_of(row_of(20000)), sleepers_of(pyramids_of(364)), options.output,
                 verdict);
    verdict.print(options.output.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
