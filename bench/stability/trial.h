#pragma once
// Trials: small scenes with a known result, and figures for the error of an engine.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engines/engine.h"
#include "report/bounds.h"

namespace fettle::bench {

struct Figure {
    std::string name;
    double value = 0;
    std::string unit{};
    Bound bound{};
};

struct Trial {
    std::string_view name;
    /// Empty if the engine cannot represent the scene.
    std::vector<Figure> (*run)(const EngineKind& kind);
};

std::span<const Trial> trials();
/// Throws std::invalid_argument with a list of the names if no trial has this name.
const Trial& trial_named(std::string_view name);

// Standing.
std::vector<Figure> stack_trial(const EngineKind& kind);
std::vector<Figure> card_house_trial(const EngineKind& kind);
std::vector<Figure> arch_trial(const EngineKind& kind);
std::vector<Figure> domino_trial(const EngineKind& kind);
std::vector<Figure> overload_trial(const EngineKind& kind);
std::vector<Figure> chain_trial(const EngineKind& kind);

// Pushing apart and hitting.
std::vector<Figure> confined_trial(const EngineKind& kind);
std::vector<Figure> overlap_trial(const EngineKind& kind);
std::vector<Figure> bullets_trial(const EngineKind& kind);
std::vector<Figure> elastic_trial(const EngineKind& kind);

// Sliding and rolling.
std::vector<Figure> tiles_trial(const EngineKind& kind);
std::vector<Figure> rolling_trial(const EngineKind& kind);
std::vector<Figure> sliding_trial(const EngineKind& kind);

// Chains and ellipses.
std::vector<Figure> seams_trial(const EngineKind& kind);
std::vector<Figure> ellipse_trial(const EngineKind& kind);

// Scenes that the comparison of the solvers uses as well.
/// A stack of boxes of one meter, sleeping disabled.
Scene stack_of(int boxes);
/// Thirty links of half a meter hang straight down, with a ball of one meter at the end.
/// `mass_ratio`: mass of the ball divided by that of a link.
Scene chain_under(double mass_ratio);

/// Root mean square of the bodies' speeds, m/s, over `steps` steps, which this function makes.
double rms_speed(Engine& engine, std::span<const std::size_t> bodies, int steps);
/// Indices of the dynamic bodies of a scene.
std::vector<std::size_t> dynamic_bodies(const Scene& scene);
void run_for(Engine& engine, double seconds);

}  // namespace fettle::bench
