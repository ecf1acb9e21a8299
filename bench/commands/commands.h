#pragma once
// What `fettle-bench` can do. Each command returns an exit status: 0, or 1 when something it checks
// on the way is wrong.

#include <string>
#include <vector>

namespace fettle::bench {

struct OutputOptions {
    bool json = false;  // a line a result instead of a table
    std::string svg;    // also draw the table into this file
};

struct ScenesOptions {
    std::vector<std::string> scenes;   // none: all that are run by default
    std::vector<std::string> engines;  // none: all
    int threads = 1;
    int runs = 3;
    int steps = 0;                // 0: as the scene says
    bool processor_time = false;  // instead of wall time: for a machine that others use too
    OutputOptions output;
};
int run_scenes(const ScenesOptions& options);

struct ThreadsOptions {
    std::vector<std::string> scenes;  // none: all
    int threads = 2;
    int runs = 3;
    int steps = 0;  // 0: as the scene says
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

/// The steps of one way of hosting, to be counted by callgrind.
struct HostedStepsOptions {
    std::string engine = "hosted";
    double watched = 0;  // share of positions, 0 to 1
    int bodies = 10000;
    int steps = 3;
};
int run_hosted_steps(const HostedStepsOptions& options);

struct PastOptions {
    int bodies = 10000;
    int seconds = 60;  // that are simulated
    bool json = false;
};
int run_past(const PastOptions& options);

struct TreeOptions {
    int repetitions = 7;
    std::string only;  // rows whose name has this in it, and what they are compared with
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
    std::string plots;  // a folder for curves, as SVG and as numbers
};
int run_solvers(const SolversOptions& options);

}  // namespace fettle::bench
