#pragma once
// The particles of an emitter.

#include <array>
#include <cstdint>
#include <vector>

#include <fettle/property/transform.h>
#include <fettle/property/value.h>

namespace fettle::visuals {

/// Only numbers: a snapshot copies the particles as bytes.
struct Particle {
    float x = 0, y = 0;
    float velocity_x = 0, velocity_y = 0;  // per second
    float age = 0, lifetime = 1;           // s
    float angle = 0;                       // rad, when it began
    float size = 1;                        // factor
};

/// How particles move, the same for all of them.
struct Motion {
    property::Vec2 gravity{0, 0};
    double damping = 0;  // 1/s
};

enum class EmitterShape : std::uint8_t { point, circle, ring, box };

/// How new particles begin.
struct Birth {
    property::Transform from{}, to{};  // place of the emitter at the beginning and end of a step
    EmitterShape shape = EmitterShape::point;
    property::Vec2 area{0, 0};
    double lifetime = 1, speed = 0, spread = 0, randomness = 0;
    bool turns = false;      // begins at a random angle
    bool on_screen = false;  // y down
    std::uint64_t seed = 0;
};

/// Six numbers from 0 to 1 of the particle with that number; the same for the same seed.
std::array<double, 6> random_numbers(std::uint64_t seed, std::uint64_t number);

/// The particle with that number. It begins at `moment` of the step, 0 to 1, and has moved since.
Particle new_particle(const Birth& birth, const Motion& motion, std::uint64_t number, double moment,
                      double dt);

/// Moves all particles, and removes those at the end of their life. The others keep their order.
void advance(std::vector<Particle>& particles, const Motion& motion, double dt);

/// False if it could not be a particle.
bool is_valid(const Particle& particle);

}  // namespace fettle::visuals
