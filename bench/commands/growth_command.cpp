// `fettle-bench growth`: what a body costs in worlds of a thousand to a hundred thousand, in time
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
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

constexpr double most_growth = 1.5;  // of the time a body takes, from the first world to the last
constexpr double most_bytes = 1024;  // of a sleeping body with a shape
constexpr int steps_in_all = 40000;  // over the number of pyramids: each world gets as much time
constexpr int warm_up = 30;          // steps: the pyramids have settled
constexpr std::array sizes = {18, 182, 1818};  // pyramids of 55 bodies

struct TimeRow {
    std::size_t bodies = 0;
    std::vector<double> us;  // a body and step, by run
    // Wall time a body and step by stage, µs; the mean of all runs.
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

/// All worlds side by side, in turns: a noisy moment meets all of them.
std::vector<TimeRow> time_rows(const GrowthOptions& options, Progress& progress) {
    std::vector<TimeRow> rows(sizes.size());
    std::vector<std::unique_ptr<Engine>> worlds;
    progress.begin("pyramids");
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        worlds.push_back(make_fettle(pyramids_of(sizes[k])));
        rows[k].bodies = static_cast<std::size_t>(sizes[k]) * 55;
        measured_steps(*worlds[k], warm_up);
    }
    for (int run = 0; run < options.runs; ++run) {
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            TimeRow& row = rows[k];
            const int steps = std::max(4, steps_in_all / 10 / sizes[k]);
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

/// Bytes a body that sleeps with a box that rests on the ground, by purpose: what is there, and the
/// room for more included.
std::vector<physics::MemoryShare> sleeping(int bodies) {
    physics::World world;
    physics::Body ground = world.create_body({.type = physics::BodyType::static_body});
    ground.add(physics::Box{.width = 4.0f * static_cast<float>(bodies), .height = 1});
    for (int i = 0; i < bodies; ++i)
        world.create_body({.position = {2.0f * static_cast<float>(i - bodies / 2), 1}})
            .add(physics::Box{});
    for (int i = 0; i < 100; ++i) world.step(time_step);
    if (world.statistics().awake_bodies > 0)
        throw std::runtime_error("boxes that rest on the ground do not sleep");
    return world.memory();
}

void print_times(const std::vector<TimeRow>& rows, const OutputOptions& output) {
    Table table({"bodies", "us a body and step", "of the first", "at most", "narrow", "solve",
                 "finish", "other"});
    const double first = median(rows.front().us);
    for (const TimeRow& row : rows) {
        const double us = median(row.us), growth = us / first;
        const double bound = &row == &rows.front() ? 1 : most_growth;
        if (output.json)
            std::cout << json_line({{"scene", "many_pyramids"},
                                    {"bodies", static_cast<long long>(row.bodies)},
                                    {"us", us},
                                    {"growth", growth},
                                    {"at_most", bound}})
                      << "\n";
        table.add({std::to_string(row.bodies), figure(us), figure(growth), figure(bound),
                   figure(row.narrow), figure(row.solve), figure(row.finish), figure(row.other)});
    }
    if (!output.json) std::cout << table.text() << "\n";
}

void print_memory(int bodies, const std::vector<physics::MemoryShare>& shares,
                  const OutputOptions& output) {
    Table table({"a sleeping body of " + std::to_string(bodies), "bytes", "with room", "at most"});
    physics::MemoryShare all = {.purpose = "in all"};
    const auto add = [&](const physics::MemoryShare& share, const std::string& bound) {
        const double used = static_cast<double>(share.used) / bodies;
        const double reserved = static_cast<double>(share.reserved) / bodies;
        if (output.json)
            std::cout << json_line({{"memory", share.purpose},
                                    {"bodies", static_cast<long long>(bodies)},
                                    {"bytes", used},
                                    {"with_room", reserved},
                                    {"at_most", bound.empty() ? JsonField() : most_bytes}})
                      << "\n";
        table.add({share.purpose, figure(used), figure(reserved), bound});
    };
    for (const physics::MemoryShare& share : shares) {
        all.used += share.used;
        all.reserved += share.reserved;
        if (share.reserved >= static_cast<std::size_t>(bodies) / 2) add(share, "");
    }
    add(all, figure(most_bytes, 4));
    if (!output.json) std::cout << table.text();
}

}  // namespace

int run_growth(const GrowthOptions& options) {
    constexpr int sleepers = 20000;
    std::vector<TimeRow> rows;
    {
        Progress progress(options.runs);
        rows = time_rows(options, progress);
    }
    print_times(rows, options.output);
    print_memory(sleepers, sleeping(sleepers), options.output);
    return 0;
}

}  // namespace fettle::bench
