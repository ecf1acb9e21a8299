// `fettle-bench`: the costs of Fettle compared with other engines. It is not part of the tests.

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/commands.h"

namespace {

using namespace fettle::bench;

/// The command line: each table is a subcommand.
class Tables {
  public:
    Tables() { app_.require_subcommand(1); }

    /// `print` prints the table and returns the exit status.
    template <class Options>
    std::pair<CLI::App*, Options&> add(const char* name, const char* what,
                                       int (*print)(const Options&)) {
        const auto options = std::make_shared<Options>();
        CLI::App* command = app_.add_subcommand(name, what);
        command->callback([this, options, print] { status_ = print(*options); });
        return {command, *options};
    }

    /// Returns the exit status; 2 for wrong arguments or an error.
    int run(int argc, char** argv) {
        const std::string name = argc > 1 ? argv[1] : "";
        if (!name.empty() && name[0] != '-' && !has(name)) {
            std::cerr << "fettle-bench: \"" << name << "\" is not a subcommand; there are";
            for (const CLI::App* each : app_.get_subcommands({}))
                std::cerr << " " << each->get_name();
            std::cerr << "\n";
            return 2;
        }
        try {
            app_.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return app_.exit(error) == 0 ? 0 : 2;
        } catch (const std::exception& error) {
            std::cerr << "fettle-bench: " << error.what() << "\n";
            return 2;
        }
        return status_;
    }

  private:
    bool has(const std::string& name) const {
        for (const CLI::App* each : app_.get_subcommands({}))
            if (each->get_name() == name) return true;
        return false;
    }

    CLI::App app_{"The costs of Fettle compared with engines that Debian has as packages.",
                  "fettle-bench"};
    int status_ = 0;
};

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

void add_scenes(Tables& tables) {
    const auto [command, options] =
        tables.add("scenes", "Step time of the same scenes in every engine", run_scenes);
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

void add_threads(Tables& tables) {
    const auto [command, options] =
        tables.add("threads", "The speedup of a step by several threads", run_threads);
    add_scene_names(*command, options.scenes);
    command->add_option("--threads", options.threads, "Threads that are compared with one")
        ->check(CLI::Range(2, 64))
        ->capture_default_str();
    add_runs(*command, options.runs);
    add_steps(*command, options.steps);
    add_json(*command, options.json);
}

#ifdef FETTLE_BENCH_GOOGLE
constexpr auto print_tree = run_tree;
#else
int print_tree(const TreeOptions&) {
    throw std::runtime_error(
        "the costs of the tree are not built in; install libbenchmark-dev and build again");
}
#endif

void add_tree(Tables& tables) {
    const auto [command, options] =
        tables.add("tree", "The cost of reads and writes in the property tree", print_tree);
    command
        ->add_option("--repetitions", options.repetitions,
                     "Repetitions; the table has their median")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--only", options.only, "Only rows with this text in their names")
        ->type_name("TEXT");
    add_output(*command, options.output);
}

void add_hosting(Tables& tables) {
    const auto [command, options] = tables.add(
        "hosting", "The cost of a world in the property tree compared with the bare library",
        run_hosting);
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
void add_hosted_steps(Tables& tables) {
    const auto [command, options] =
        tables.add("hosted-steps", "Steps for valgrind to count", run_hosted_steps);
    command->group("");
    command->add_option("--engine", options.engine);
    command->add_option("--watched", options.watched);
    command->add_option("--bodies", options.bodies);
    command->add_option("--steps", options.steps);
}

#ifdef FETTLE_BENCH_GAMES
void add_games(Tables& tables) {
    const auto [command, options] =
        tables.add("games", "The cost of games: steps, frames, loading", run_games);
    command->add_option("--only", options.only, "Only rows with this text in their names")
        ->type_name("TEXT");
    add_json(*command, options.json);
}
#endif

void add_console(Tables& tables) {
    const auto [command, options] =
        tables.add("console", "The cost of the console in a frame of large games", run_console);
    command->add_option("--bodies", options.bodies, "Bodies of a game (repeatable)")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--frames", options.frames, "Frames; the table has their median")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    add_json(*command, options.json);
}

void add_past(Tables& tables) {
    const auto [command, options] = tables.add(
        "past", "The cost of storing the past of a game, and of going back to it", run_past);
    command->add_option("--bodies", options.bodies, "Moving bodies, in hundreds")
        ->check(CLI::Range(100, 1000000))
        ->capture_default_str();
    command->add_option("--seconds", options.seconds, "Simulated seconds")
        ->check(CLI::Range(2, 60))
        ->capture_default_str();
    add_json(*command, options.json);
}

void add_stability(Tables& tables) {
    const auto [command, options] =
        tables.add("stability", "How well stacks stand, in every engine", run_stability);
    add_scene_names(*command, options.scenes);
    command->add_option("--engine", options.engines, "Only this engine (repeatable)")
        ->type_name("fettle|box2d|chipmunk");
    add_output(*command, options.output);
}

void add_shapes(Tables& tables) {
    const auto [command, options] =
        tables.add("shapes", "The cost of a contact by the number of vertices", run_shapes);
    add_runs(*command, options.runs);
    add_json(*command, options.json);
}

void add_growth(Tables& tables) {
    const auto [command, options] = tables.add(
        "growth", "The cost of a body in small and in large worlds, in time and in memory",
        run_growth);
    add_runs(*command, options.runs);
    add_json(*command, options.output.json);
}

void add_solvers(Tables& tables) {
    const auto [command, options] = tables.add(
        "solvers", "Stability and speed of the three solvers in the same scenes", run_solvers);
    add_scene_names(*command, options.scenes, "Only this stability scene (repeatable)");
    add_json(*command, options.json);
    command->add_option("--plots", options.plots, "Also write curves into this folder")
        ->type_name("DIR");
}

void add_wild(Tables& tables) {
    const auto [command, options] =
        tables.add("wild", "Random worlds, and the invariants that they violate", run_wild);
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

}  // namespace

int main(int argc, char** argv) {
#ifndef __OPTIMIZE__
    std::cerr << "fettle-bench was built without optimization, so that its figures would mean "
                 "nothing.\nBuild it with -DCMAKE_BUILD_TYPE=Release, or by ./play --build.\n";
    return 2;
#endif
    Tables tables;
    add_past(tables);
    add_console(tables);
#ifdef FETTLE_BENCH_GAMES
    add_games(tables);
#endif
    add_scenes(tables);
    add_threads(tables);
    add_tree(tables);
    add_hosting(tables);
    add_hosted_steps(tables);
    add_stability(tables);
    add_shapes(tables);
    add_solvers(tables);
    add_growth(tables);
    add_wild(tables);
    return tables.run(argc, argv);
}
