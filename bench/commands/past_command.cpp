// `fettle-bench past`: the cost of storing a game's past, and of going back to it.

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "engines/hosted_engine.h"
#include "measure/timing.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

constexpr double mebibyte = 1048576;
constexpr int bounded_bodies = 10000;     // the bounds are for this number
constexpr std::int64_t first_steps = 60;  // steps in which the first keyframe allocates memory

struct Run {
    double first_ms = 0;              // the first keyframe included
    std::vector<double> plain_ms;     // steps without a keyframe, after the warm-up
    std::vector<double> keyframe_ms;  // steps with a keyframe
    double memory = 0;                // bytes
    double kept_s = 0;                // length of the stored past
    std::vector<double> travel_ms;    // travel to moments that are spread over all of it
};

Run measure(const PastOptions& options, Progress& progress) {
    const Scene scene = crowd_of(100, std::max(1, options.bodies / 100));
    HostedEngine engine(scene);
    app::Timeline& past = engine.game().loop.timeline();
    const std::int64_t steps = 60 * std::int64_t{options.seconds};
    Run run;
    for (std::int64_t step = 1; step <= steps; ++step) {
        const std::size_t before = past.keyframes();
        const WallClock clock;
        engine.step();
        const double ms = clock.elapsed_ms();
        if (step == 1)
            run.first_ms = ms;
        else if (past.keyframes() > before)
            run.keyframe_ms.push_back(ms);
        else if (step > first_steps)
            run.plain_ms.push_back(ms);
        progress.add(0.8 / static_cast<double>(steps));
    }
    if (run.keyframe_ms.empty())
        throw std::runtime_error("no keyframe was made: use more --seconds");
    run.memory = static_cast<double>(past.memory());
    const std::uint64_t present = engine.game().loop.hash();
    constexpr int moments = 8;
    const std::int64_t oldest = past.oldest();
    run.kept_s = static_cast<double>(steps - oldest) / 60;
    for (int i = 0; i <= moments; ++i) {  // the last target is the present
        const std::int64_t to = oldest + (steps - oldest) * i / moments;
        const WallClock clock;
        past.go_to(to);
        run.travel_ms.push_back(clock.elapsed_ms());
        progress.add(0.2 / (moments + 1));
    }
    if (engine.game().loop.hash() != present)
        throw std::runtime_error("the state differs after going to the past and back");
    return run;
}

double greatest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

}  // namespace

int run_past(const PastOptions& options) {
    Run run;
    {
        Progress progress(1);
        progress.begin("steps");
        run = measure(options, progress);
    }
    const bool bounded = options.bodies <= bounded_bodies;
    struct Figure {
        const char* name;
        double value;
        const char* unit;
        Bound bound{};
    };
    const Figure figures[] = {
        {"step, median", median(run.plain_ms), "ms"},
        {"step without a keyframe, worst", greatest(run.plain_ms), "ms"},
        {"step with a keyframe, median", median(run.keyframe_ms), "ms"},
        {"step with a keyframe, worst", greatest(run.keyframe_ms), "ms"},
        {"first step, with the first keyframe", run.first_ms, "ms"},
        {"keyframes", static_cast<double>(run.keyframe_ms.size() + 1), ""},
        {"past that is kept", run.kept_s, "s", bounded ? at_least(options.seconds) : Bound{}},
        {"memory of the past", run.memory / mebibyte, "MiB", bounded ? at_most(128) : Bound{}},
        {"going to a moment, median", median(run.travel_ms), "ms"},
        {"going to a moment, longest", greatest(run.travel_ms), "ms"}};
    Verdict verdict("past");
    Table table({"past of " + std::to_string(options.bodies) + " bodies, " +
                     std::to_string(options.seconds) + " s",
                 "", "", "bound"});
    for (const Figure& each : figures) {
        if (options.json)
            std::cout << json_line(
                             {{"name", each.name},
                              {"value", each.value},
                              {"unit", each.unit},
                              {"bound", each.bound ? JsonField(each.bound.value) : JsonField()}})
                      << "\n";
        table.add({each.name,
                   verdict.mark(each.name, each.value, each.bound, figure(each.value), each.unit),
                   each.unit, each.bound.text()});
    }
    if (!options.json) std::cout << table.text();
    verdict.print(options.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
