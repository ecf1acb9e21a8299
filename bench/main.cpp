// `fettle-bench`: the costs of Fettle compared with other engines. It is not part of the tests.

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands/commands.h"

namespace {

using namespace fettle::bench;

void add_json(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Print a JSON object a line instead of a table");
}

void add_output(CLI::App& command, OutputOptions& output) {
    add_json(command, output.json);
    command.add_option("--svg", output.svg, "Also draw the table as a chart")->type_name("FILE");
}

void add_scene_names(CLI::App& command, std::vector<std::string>& scenes,
                     const std::string& what = "Only this scene (repeatable)") {
    command.add_option("--scene", scenes, what)->type_name("NAME");
}

void add_runs(CLI::App& command, int& runs) {
    command.add_option("--runs", runs, "Runs; the table has their median")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

void add_steps(CLI::App& command, int& steps) {
    command.add_option("--steps", steps, "Steps instead of the scene's own number")
        ->check(CLI::Range(2, 1000000));
}

void add_scenes(CLI::App& app, ScenesOptions& options) {
    CLI::App* command =
        app.add_subcommand("scenes", "Step time of the same scenes in every engine");
    add_scene_names(*command, options.scenes);
    command->add_option("--engine", options.engines, "Only this engine (repeatable)")
        ->type_name("fettle|hosted|box2d|chipmunk");
    command->add_option("--threads", options.threads, "Threads an engine may use")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    add_runs(*command, options.runs);
    add_steps(*command, options.steps);
    command->add_flag("--processor-time", options.processor_time,
                      "Processor time instead of wall time, for a machine with other load");
    add_output(*command, options.output);
}

void add_threads(CLI::App& app, ThreadsOptions& options) {
    CLI::App* command = app.add_subcommand("threads", "The speedup of a step by several threads");
    add_scene_names(*command, options.scenes);
    command->add_option("--threads", options.threads, "Threads that are compared with one")
        ->check(CLI::Range(2, 64))
        ->capture_default_str();
    add_runs(*command, options.runs);
    add_steps(*command, options.steps);
    add_json(*command, options.json);
}

void add_tree(CLI::App& app, TreeOptions& options) {
    CLI::App* command =
        app.add_subcommand("tree", "The cost of reads and writes in the property tree");
    command
        ->add_option("--repetitions", options.repetitions,
                     "Repetitions; the table has their median")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--only", options.only, "Only rows with this text in their names")
        ->type_name("TEXT");
    add_output(*command, options.output);
}

void add_hosting(CLI::App& app, HostingOptions& options) {
    CLI::App* command = app.add_subcommand(
        "hosting", "The cost of a world in the property tree compared with the bare library");
    command->add_option("--bodies", options.bodies, "Moving bodies, in hundreds")
        ->check(CLI::Range(100, 1000000))
        ->capture_default_str();
    command->add_option("--pairs", options.pairs, "Pairs of timings")
        ->check(CLI::Range(20, 100000))
        ->capture_default_str();
    command->add_option("--steps", options.steps_a_pair, "Steps of each timing")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("!--no-instructions", options.instructions,
                      "Do not count instructions with valgrind");
    add_output(*command, options.output);
}

/// Internal: `hosting` runs this command under valgrind.
void add_hosted_steps(CLI::App& app, HostedStepsOptions& options) {
    CLI::App* command = app.add_subcommand("hosted-steps", "Steps for valgrind to count");
    command->group("");
    command->add_option("--engine", options.engine);
    command->add_option("--watched", options.watched);
    command->add_option("--bodies", options.bodies);
    command->add_option("--steps", options.steps);
}

#ifdef FETTLE_BENCH_GAMES
void add_games(CLI::App& app, GamesOptions& options) {
    CLI::App* command = app.add_subcommand("games", "The cost of games: steps, frames, loading");
    command->add_option("--only", options.only, "Only rows with this text in their names")
        ->type_name("TEXT");
    add_json(*command, options.json);
}
#endif

void add_console(CLI::App& app, ConsoleOptions& options) {
    CLI::App* command =
        app.add_subcommand("console", "The cost of the console in a frame of large games");
    command->add_option("--bodies", options.bodies, "Bodies of a game (repeatable)")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--frames", options.frames, "Frames; the table has their median")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    add_json(*command, options.json);
}

void add_past(CLI::App& app, PastOptions& options) {
    CLI::App* command = app.add_subcommand(
        "past", "The cost of storing the past of a game, and of going back to it");
    command->add_option("--bodies", options.bodies, "Moving bodies, in hundreds")
        ->check(CLI::Range(100, 1000000))
        ->capture_default_str();
    command->add_option("--seconds", options.seconds, "Simulated seconds")
        ->check(CLI::Range(2, 60))
        ->capture_default_str();
    add_json(*command, options.json);
}

void add_stability(CLI::App& app, StabilityOptions& options) {
    CLI::App* command = app.add_subcommand("stability", "How well stacks stand, in every engine");
    add_scene_names(*command, options.scenes);
    command->add_option("--engine", options.engines, "Only this engine (repeatable)")
        ->type_name("fettle|box2d|chipmunk");
    add_output(*command, options.output);
}

void add_shapes(CLI::App& app, ShapesOptions& options) {
    CLI::App* command =
        app.add_subcommand("shapes", "The cost of a contact by the number of vertices");
    add_runs(*command, options.runs);
    add_json(*command, options.json);
}

void add_growth(CLI::App& app, GrowthOptions& options) {
    CLI::App* command = app.add_subcommand(
        "growth", "The cost of a body in small and in large worlds, in time and in memory");
    add_runs(*command, options.runs);
    add_json(*command, options.output.json);
}

void add_solvers(CLI::App& app, SolversOptions& options) {
    CLI::App* command = app.add_subcommand(
        "solvers", "Stability and speed of the three solvers in the same scenes");
    add_scene_names(*command, options.scenes, "Only this stability scene (repeatable)");
    add_json(*command, options.json);
    command->add_option("--plots", options.plots, "Also write curves into this folder")
        ->type_name("DIR");
}

void add_wild(CLI::App& app, WildOptions& options) {
    CLI::App* command =
        app.add_subcommand("wild", "Random worlds, and the invariants that they violate");
    command
        ->add_option("--seed", options.seed,
                     "Seed of the first world; each later world has the next seed")
        ->capture_default_str();
    command->add_option("--count", options.count, "Maximum number of worlds")
        ->check(CLI::Range(1, 1000000000))
        ->capture_default_str();
    command->add_option("--seconds", options.seconds, "No world begins after this time");
    command->add_option("--invariant", options.invariants, "Only this invariant (repeatable)")
        ->type_name("NAME");
    command->add_option("--engine", options.engines, "Try the worlds in this engine as well")
        ->type_name("box2d");
    command
        ->add_option("--minimize", options.minimized,
                     "Findings of each invariant that are minimized")
        ->capture_default_str();
    add_json(*command, options.json);
}

bool has_table(const CLI::App& app, const std::string& name) {
    for (const CLI::App* each : app.get_subcommands({}))
        if (each->get_name() == name) return true;
    return false;
}

}  // namespace

int main(int argc, char** argv) {
#ifndef __OPTIMIZE__
    std::cerr << "fettle-bench was built without optimization, so that its figures would mean "
                 "nothing.\nBuild it with -DCMAKE_BUILD_TYPE=Release, or by ./play --build.\n";
    return 2;
#endif
    CLI::App app("The costs of Fettle compared with engines that Debian has as packages.",
                 "fettle-bench");
    app.require_subcommand(1);
    ScenesOptions scenes;
    TreeOptions tree;
    HostingOptions hosting;
    HostedStepsOptions hosted_steps;
    PastOptions past;
    add_past(app, past);
    ConsoleOptions console;
    add_console(app, console);
#ifdef FETTLE_BENCH_GAMES
    GamesOptions games;
    add_games(app, games);
#endif
    StabilityOptions stability;
    add_scenes(app, scenes);
    ThreadsOptions threads;
    add_threads(app, threads);
    add_tree(app, tree);
    add_hosting(app, hosting);
    add_hosted_steps(app, hosted_steps);
    ShapesOptions shapes;
    add_stability(app, stability);
    add_shapes(app, shapes);
    SolversOptions solvers;
    add_solvers(app, solvers);
    GrowthOptions growth;
    add_growth(app, growth);
    WildOptions wild;
    add_wild(app, wild);
    const std::string command = argc > 1 ? argv[1] : "";
    if (!command.empty() && command[0] != '-' && !has_table(app, command)) {
        std::cerr << "fettle-bench: \"" << command << "\" is not a subcommand; there are";
        for (const CLI::App* each : app.get_subcommands({})) std::cerr << " " << each->get_name();
        std::cerr << "\n";
        return 2;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        if (app.got_subcommand("scenes")) return run_scenes(scenes);
        if (app.got_subcommand("threads")) return run_threads(threads);
#ifdef FETTLE_BENCH_GOOGLE
        if (app.got_subcommand("tree")) return run_tree(tree);
#else
        if (app.got_subcommand("tree"))
            throw std::runtime_error(
                "the costs of the tree are not built in; install libbenchmark-dev and build again");
#endif
        if (app.got_subcommand("hosting")) return run_hosting(hosting);
        if (app.got_subcommand("hosted-steps")) return run_hosted_steps(hosted_steps);
        if (app.got_subcommand("console")) return run_console(console);
        if (app.got_subcommand("past")) return run_past(past);
#ifdef FETTLE_BENCH_GAMES
        if (app.got_subcommand("games")) return run_games(games);
#endif
        if (app.got_subcommand("stability")) return run_stability(stability);
        if (app.got_subcommand("shapes")) return run_shapes(shapes);
        if (app.got_subcommand("growth")) return run_growth(growth);
        if (app.got_subcommand("solvers")) return run_solvers(solvers);
        if (app.got_subcommand("wild")) return run_wild(wild);
    } catch (const std::exception& error) {
        std::cerr << "fettle-bench: " << error.what() << "\n";
        return 2;
    }
    return 0;
}
