// `fettle-bench growth`: time and memory per body in worlds with a thousand to a hundred thousand
// bodies.
// and in memory.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

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

// Time per body in the last world divided by that in the first.
const Bound growth_bound = at_most(1.5);
const Bound body_bytes_bound = below(1024);             // for a sleeping body with one shape
constexpr int steps_in_all = 40000;                     // divided by the number of pyramids
constexpr int settling_steps = 30;                      // steps until the pyramids have settled
constexpr std::array pyramid_counts = {18, 182, 1818};  // pyramids of 55 bodies

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

/// Runs all worlds in turns, so that a disturbance affects all of them.
std::vector<TimeRow> time_rows(const GrowthOptions& options, Progress& progress) {
    std::vector<TimeRow> rows(pyramid_counts.size());
    std::vector<std::unique_ptr<Engine>> worlds;
    progress.begin("pyramids");
    for (std::size_t k = 0; k < pyramid_counts.size(); ++k) {
        worlds.push_back(make_fettle(pyramids_of(pyramid_counts[k])));
        rows[k].bodies = static_cast<std::size_t>(pyramid_counts[k]) * 55;
        measured_steps(*worlds[k], settling_steps);
    }
    for (int run = 0; run < options.runs; ++run) {
        for (std::size_t k = 0; k < pyramid_counts.size(); ++k) {
            TimeRow& row = rows[k];
            const int steps = std::max(4, steps_in_all / 10 / pyramid_counts[k]);
            const ThreadClock clock;
            for (int i = 0; i < steps; ++i) {
                worlds[k]->step();
                add_stages(fettle_world(*worlds[k]).statistics(), row);
            }
            row.us.push_back(1e3 * clock.elapsed_ms() / steps / static_cast<double>(row.bodies));
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

void print_times(const std::vector<TimeRow>& rows, const OutputOptions& output, Verdict& verdict) {
    Table table({"bodies", "us a body and step", "of the first", "bound", "narrow", "solve",
                 "finish", "other"});
    const double first = median(rows.front().us);
    for (const TimeRow& row : rows) {
        const double us = median(row.us), growth = us / first;
        const Bound bound = &row == &rows.front() ? Bound{} : growth_bound;
        if (output.json)
            std::cout << json_line({{"scene", "many_pyramids"},
                                    {"bodies", static_cast<long long>(row.bodies)},
                                    {"us", us},
                                    {"growth", growth},
                                    {"at_most", bound ? JsonField(bound.value) : JsonField()}})
                      << "\n";
        table.add({std::to_string(row.bodies), figure(us),
                   verdict.look(std::to_string(row.bodies) + " bodies", growth, bound,
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
                   verdict.look("a sleeping body", bytes[1], bound, figure(bytes[1], 4), "bytes"),
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
    std::vector<TimeRow> rows;
    {
        Progress progress(options.runs);
        rows = time_rows(options, progress);
    }
    Verdict verdict("growth");
    print_times(rows, options.output, verdict);
    print_memory(sleepers_of(row_of(20000)), sleepers_of(pyramids_of(364)), options.output,
                 verdict);
    verdict.print(options.output.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
