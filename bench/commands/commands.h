#pragma once
// The subcommands of `fettle-bench`. Each returns an exit status: 0, or 1 if a check during the run
// failed.

#include <cstdint>
#include <string>
#include <vector>

namespace fettle::bench {

struct OutputOptions {
    bool json = false;  // one line per result instead of a table
    std::string svg;    // also draw the table into this file
};

struct ScenesOptions {
    std::vector<std::string> scenes;   // empty: all that run by default
    std::vector<std::string> engines;  // empty: all
    int threads = 1;
    int runs = 3;
    int steps = 0;                // 0: the scene's own number
    bool processor_time = false;  // instead of wall time; for machines with other load
    OutputOptions output;
};
int run_scenes(const ScenesOptions& options);

struct ThreadsOptions {
    std::vector<std::string> scenes;  // empty: all
    int threads = 2;
    int runs = 3;
    int steps = 0;  // 0: the scene's own number
    bool json = false;
};
int run_threads(const ThreadsOptions& options);

struct HostingOptions {
    int bodies = 10000;
    int pairs = 30;
    int steps_a_pair = 4;
    bool instructions = true;
    OutputOptions output;
};
int run_hosting(const HostingOptions& options);

/// Options of the steps that callgrind counts.
struct HostedStepsOptions {
    std::string engine = "hosted";
    double watched = 0;  // share of positions, 0 to 1
    int bodies = 10000;
    int steps = 3;
};
int run_hosted_steps(const HostedStepsOptions& options);

struct PastOptions {
    int bodies = 10000;
    int seconds = 60;  // simulated time
    bool json = false;
};
int run_past(const PastOptions& options);

struct ConsoleOptions {
    std::vector<int> bodies = {10000, 100000};
    int frames = 120;
    bool json = false;
};
int run_console(const ConsoleOptions& options);

struct GamesOptions {
    std::string only;  // rows with this text in their names; empty: all
    bool json = false;
};
int run_games(const GamesOptions& options);

struct TreeOptions {
    int repetitions = 7;
    std::string only;  // only rows with this text, and those they are compared with
    OutputOptions output;
};
int run_tree(const TreeOptions& options);

struct StabilityOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> engines;
    OutputOptions output;
};
int run_stability(const StabilityOptions& options);

struct ShapesOptions {
    int runs = 5;
    bool json = false;
};
int run_shapes(const ShapesOptions& options);

struct GrowthOptions {
    int runs = 9;
    OutputOptions output;
};
int run_growth(const GrowthOptions& options);

struct SolversOptions {
    std::vector<std::string> scenes;
    bool json = false;
    std::string plots;  // folder for the curves as SVG and as numbers
};
int run_solvers(const SolversOptions& options);

struct WildOptions {
    std::uint64_t seed = 1;
    int count = 200;
    double seconds = 0;                   // wall time after which no world begins; 0: no limit
    std::vector<std::string> invariants;  // empty: all
    std::vector<std::string> engines;     // engines that run the worlds, too
    int minimized = 3;                    // findings of each invariant that are minimized
    bool json = false;
};
int run_wild(const WildOptions& options);

}  // namespace fettle::bench
