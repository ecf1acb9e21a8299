// `fettle-bench hosting`: the cost of a world in the property tree compared with the bare library.

#include <malloc.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "commands/commands.h"
#include "engines/engine.h"
#include "engines/hosted_engine.h"
#include "measure/callgrind.h"
#include "measure/event_cost.h"
#include "measure/handle_cost.h"
#include "measure/simulation.h"
#include "measure/timing.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

const Bound bytes_bound = at_most(64);  // per instance
const Bound get_bound = at_most(15);    // ns, of a property by its handle in C
constexpr int warm_up = 30;             // steps until the crowd lies in a heap

/// A way of hosting that is compared with the bare library.
struct Way {
    const char* name;
    double watched;  // share of the positions, 0 to 1
    Bound bound;     // of the ratio
};
const Way ways[] = {{"nothing watched", 0, at_most(1.01)},
                    {"1 % of positions watched", 0.01, at_most(1.02)},
                    {"10 % of positions watched", 0.1, {}},
                    {"all positions watched", 1, at_most(1.25)}};
constexpr std::size_t way_count = std::size(ways);

struct Result {
    std::string name;
    double ratio = 0;
    std::optional<Interval> interval;
    Bound bound{};
    /// The figure that is compared with the bound. Times are noisy, so a time exceeds its bound
    /// only if its whole interval does.
    double judged() const { return interval ? interval->low : ratio; }
};

Scene hosting_scene(int bodies, int steps) {
    Scene scene = crowd_of(100, std::max(1, bodies / 100));
    scene.steps = steps;
    return scene;
}

std::unique_ptr<Engine> hosted(const Scene& scene, double watched) {
    auto engine = std::make_unique<HostedEngine>(scene);
    engine->watch_positions(watched);
    return engine;
}

/// Time of each way divided by the time of the bare library, for each pair. All ways make the same
/// steps in turns; their order rotates.
std::vector<Result> time_ratios(const HostingOptions& options, Progress& progress) {
    const int steps = warm_up + options.pairs * options.steps_a_pair;
    const Scene scene = hosting_scene(options.bodies, steps);
    std::vector<std::unique_ptr<Simulation>> simulations;
    simulations.push_back(std::make_unique<Simulation>(scene, engine_named("fettle")));
    for (const Way& way : ways) {
        simulations.push_back(
            std::make_unique<Simulation>(scene, way.name, hosted(scene, way.watched)));
    }
    for (const auto& simulation : simulations) simulation->advance(warm_up);

    std::vector<std::vector<double>> ratios(way_count);
    for (int pair = 0; pair < options.pairs; ++pair) {
        std::vector<double> ms(simulations.size());
        for (std::size_t k = 0; k < simulations.size(); ++k) {
            const std::size_t i = (k + static_cast<std::size_t>(pair)) % simulations.size();
            ms[i] = simulations[i]->advance(options.steps_a_pair).thread_ms;
        }
        for (std::size_t w = 0; w < way_count; ++w) ratios[w].push_back(ms[w + 1] / ms[0]);
        progress.add(1.0 / options.pairs);
    }
    std::vector<Result> results;
    for (std::size_t w = 0; w < way_count; ++w) {
        if (simulations[w + 1]->hash() != simulations[0]->hash())
            throw std::runtime_error(std::string(ways[w].name) +
                                     ": the hosted world ended in another state than the bare one");
        results.push_back({std::string("time, ") + ways[w].name, median(ratios[w]),
                           median_interval(ratios[w]), ways[w].bound});
    }
    return results;
}

std::optional<std::uint64_t> instructions_of(const std::string& engine, double watched,
                                             int bodies) {
    return count_instructions({"hosted-steps", "--engine", engine, "--watched",
                               std::to_string(watched), "--bodies", std::to_string(bodies)});
}

std::vector<Result> instruction_ratios(const HostingOptions& options, Progress& progress) {
    std::vector<Result> results;
    const auto bare = instructions_of("fettle", 0, options.bodies);
    progress.add(1.0 / (way_count + 1));
    if (!bare) return results;
    for (const Way& way : ways) {
        const auto count = instructions_of("hosted", way.watched, options.bodies);
        progress.add(1.0 / (way_count + 1));
        if (!count) continue;
        results.push_back({std::string("instructions, ") + way.name,
                           static_cast<double>(*count) / static_cast<double>(*bare), std::nullopt,
                           way.bound});
    }
    return results;
}

std::size_t heap_in_use() {
#if defined(__GLIBC__)
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

/// Bytes per instance in the tree in addition to its object in the bare library.
struct Bytes {
    double body = 0;   // without its shape
    double shape = 0;  // in addition to its body
};

/// Bytes of a whole scene in the tree in addition to the bare library. The stored past for
/// rewinding is not counted: it has its own bound (`time.rewind_memory`).
double bytes_over_bare(const Scene& scene) {
    const auto size_of = [&](auto make) {
        const std::size_t before = heap_in_use();
        const std::unique_ptr<Engine> engine = make();
        engine->step();
        return static_cast<double>(heap_in_use() - before);
    };
    const double bare = size_of([&] { return make_fettle(scene); });
    return size_of([&] { return std::make_unique<HostedEngine>(scene, false); }) - bare;
}

Bytes bytes_of(int bodies) {
    const Scene scene = hosting_scene(bodies, 1);
    Scene alone = scene;
    for (SceneBody& body : alone.bodies) body.shapes.clear();
    Scene none = scene;
    none.bodies.clear();
    const auto count = static_cast<double>(scene.bodies.size());
    bytes_over_bare(none);  // allocates what a process needs only once
    const double without = bytes_over_bare(none);
    const double of_bodies = bytes_over_bare(alone);
    const double of_all = bytes_over_bare(scene);
    return {(of_bodies - without) / count, (of_all - of_bodies) / count};
}

Table event_table(const std::vector<EventCost>& costs, bool json) {
    Table table({"an event, of boxes on one floor", "ns, handler in C++", "in Lua"});
    for (const EventCost& cost : costs) {
        if (json)
            std::cout << json_line({{"name", "an event, " + std::to_string(cost.boxes) + " boxes"},
                                    {"ns", cost.ns_native},
                                    {"ns_script", cost.ns_script}})
                      << "\n";
        table.add({std::to_string(cost.boxes), figure(cost.ns_native), figure(cost.ns_script)});
    }
    return table;
}

/// Times are noisy, so a time exceeds its bound only if the fastest one does.
Table handle_table(const std::vector<HandleCost>& costs, Verdict& verdict, bool json) {
    Table table({"a property of a game hosted in C", "ns", "bound"});
    for (const HandleCost& cost : costs) {
        const Bound bound = cost.name.starts_with("get") ? get_bound : Bound{};
        if (json)
            std::cout << json_line({{"name", cost.name},
                                    {"ns", cost.ns},
                                    {"at_most", bound ? JsonField(bound.value) : JsonField()}})
                      << "\n";
        table.add({cost.name, verdict.mark(cost.name, cost.ns_best, bound, figure(cost.ns), "ns"),
                   bound.text()});
    }
    return table;
}

void print(const std::vector<Result>& results, const Bytes& bytes,
           const std::vector<EventCost>& costs, const std::vector<HandleCost>& handles,
           const OutputOptions& output) {
    Verdict verdict("hosting");
    Table table({"hosted over bare", "ratio", "95 % interval", "bound"});
    Chart chart{.title = "Cost of hosting, bare library = 1", .unit = "×", .series = {"hosted"}};
    for (const Result& result : results) {
        const auto& interval = result.interval;
        if (output.json) {
            std::cout << json_line({{"name", result.name},
                                    {"ratio", result.ratio},
                                    {"low", interval ? JsonField(interval->low) : JsonField()},
                                    {"high", interval ? JsonField(interval->high) : JsonField()},
                                    {"at_most",
                                     result.bound ? JsonField(result.bound.value) : JsonField()}})
                      << "\n";
        }
        table.add({result.name,
                   verdict.mark(result.name, result.judged(), result.bound, figure(result.ratio, 5),
                                interval ? "(at least " + figure(interval->low, 5) + ")" : ""),
                   interval ? figure(interval->low, 5) + " to " + figure(interval->high, 5) : "",
                   result.bound.text()});
        chart.groups.push_back({result.name, {result.ratio}});
    }
    const std::pair<const char*, double> sizes[] = {{"a body", bytes.body},
                                                    {"a shape of a body", bytes.shape}};
    Table memory({"memory in the tree beyond the bare library", "bytes", "bound"});
    for (const auto& [name, size] : sizes) {
        if (output.json)
            std::cout << json_line({{"name", std::string("bytes, ") + name},
                                    {"bytes", size},
                                    {"at_most", bytes_bound.value}})
                      << "\n";
        memory.add({name, verdict.mark(name, size, bytes_bound, figure(size), "bytes"),
                    bytes_bound.text()});
    }
    const Table events = event_table(costs, output.json);
    const Table in_c = handle_table(handles, verdict, output.json);
    if (!output.json)
        std::cout << table.text() << "\n"
                  << memory.text() << "\n"
                  << events.text() << "\n"
                  << in_c.text();
    verdict.print(output.json ? std::cerr : std::cout);
    if (!output.svg.empty()) write_svg(chart, output.svg);
}

}  // namespace

int run_hosting(const HostingOptions& options) {
    const Bytes bytes = bytes_of(options.bodies);
    std::vector<Result> results;
    std::vector<EventCost> events;
    {
        const bool count = options.instructions && callgrind_available();
        if (options.instructions && !count)
            std::cerr << "instructions are not counted: valgrind is not installed\n";
        Progress progress(count ? 3 : 2);
        if (count) {
            progress.begin("instructions");
            results = instruction_ratios(options, progress);
        }
        progress.begin("time");
        for (Result& result : time_ratios(options, progress)) results.push_back(std::move(result));
        progress.begin("events");
        events = event_costs([&](double share) { progress.add(share); });
    }
    print(results, bytes, events, handle_costs(), options.output);
    return 0;
}

int run_hosted_steps(const HostedStepsOptions& options) {
    const Scene scene = hosting_scene(options.bodies, 1000);
    const std::unique_ptr<Engine> engine = options.engine == "hosted"
                                               ? hosted(scene, options.watched)
                                               : engine_named(options.engine).make(scene);
    for (int i = 0; i < warm_up; ++i) engine->step();
    measured_steps(*engine, options.steps);
    return 0;
}

}  // namespace fettle::bench
