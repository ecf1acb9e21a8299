#include "stability/trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace fettle::bench {

std::span<const Trial> trials() {
    static const std::array<Trial, 15> all = {{
        {"stack", stack_trial},
        {"card_house", card_house_trial},
        {"arch", arch_trial},
        {"domino", domino_trial},
        {"overload", overload_trial},
        {"chain", chain_trial},
        {"confined", confined_trial},
        {"overlap", overlap_trial},
        {"bullets", bullets_trial},
        {"tiles", tiles_trial},
        {"rolling", rolling_trial},
        {"sliding", sliding_trial},
        {"elastic", elastic_trial},
        {"seams", seams_trial},
        {"ellipse", ellipse_trial},
    }};
    return all;
}

const Trial& trial_named(std::string_view name) {
    const auto all = trials();
    const auto found = std::ranges::find(all, name, &Trial::name);
    if (found != all.end()) return *found;
    std::string names;
    for (const Trial& trial : all) names += (names.empty() ? "" : ", ") + std::string(trial.name);
    throw std::invalid_argument("no stability scene is called \"" + std::string(name) +
                                "\"; there are " + names);
}

double rms_speed(Engine& engine, std::span<const std::size_t> bodies, int steps) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        engine.step();
        for (const std::size_t body : bodies) {
            const Point v = engine.motion(body).velocity;
            sum += static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y;
        }
    }
    return std::sqrt(sum / (static_cast<double>(bodies.size()) * steps));
}

std::vector<std::size_t> dynamic_bodies(const Scene& scene) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].motion == Motion::dynamic) found.push_back(i);
    }
    return found;
}

void run_for(Engine& engine, double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(time_step)));
    for (int i = 0; i < steps; ++i) engine.step();
}

}  // namespace fettle::bench
