#include <emitters/particles.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fettle/property/split_mix.h>

namespace fettle::visuals {

using property::Transform;
using property::Vec2;

namespace {

Transform between(const Transform& a, const Transform& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.origin + t * (b.origin - a.origin)};
}

Vec2 point_in(EmitterShape shape, const Vec2& area, double r, double s) {
    const double angle = 2 * std::numbers::pi * r;
    const Vec2 round = 0.5 * area.times(Vec2(std::cos(angle), std::sin(angle)));
    switch (shape) {
        case EmitterShape::box:
            return area.times(Vec2(r - 0.5, s - 0.5));
        case EmitterShape::circle:
            return std::sqrt(s) * round;
        case EmitterShape::ring:
            return round;
        case EmitterShape::point:
            break;
    }
    return {0, 0};
}

void move(Particle& p, const Vec2& push, float kept, float dt) {
    p.velocity_x = (p.velocity_x + static_cast<float>(push.x)) * kept;
    p.velocity_y = (p.velocity_y + static_cast<float>(push.y)) * kept;
    p.x += p.velocity_x * dt;
    p.y += p.velocity_y * dt;
    p.age += dt;
}

}  // namespace

std::array<double, 6> random_numbers(std::uint64_t seed, std::uint64_t number) {
    std::array<double, 6> all{};
    const std::uint64_t begin = property::split_mix(property::split_mix(seed) ^ number);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<double>(property::split_mix(begin + i) >> 11) * 0x1p-53;
    return all;
}

Particle new_particle(const Birth& birth, const Motion& motion, std::uint64_t number, double moment,
                      double dt) {
    const auto r = random_numbers(birth.seed, number);
    const auto varied = [&](double value, double random) {
        return value * (1 + birth.randomness * (2 * random - 1));
    };
    const Transform place = between(birth.from, birth.to, moment);
    const Vec2 at = place(point_in(birth.shape, birth.area, r[0], r[1]));
    const double turn = birth.spread * (r[2] - 0.5) * (birth.on_screen ? -1 : 1);
    const Vec2 velocity =
        varied(birth.speed, r[3]) * place.direction(Vec2(std::cos(turn), std::sin(turn)));
    Particle p;
    p.x = static_cast<float>(at.x);
    p.y = static_cast<float>(at.y);
    p.velocity_x = static_cast<float>(velocity.x);
    p.velocity_y = static_cast<float>(velocity.y);
    p.lifetime = static_cast<float>(std::max(1e-3, varied(birth.lifetime, r[4])));
    p.size = static_cast<float>(varied(1, r[5]));
    if (birth.turns) p.angle = static_cast<float>(2 * std::numbers::pi * (r[1] - 0.5));
    const double since = (1 - moment) * dt;
    move(p, motion.gravity * since, static_cast<float>(1 / (1 + motion.damping * since)),
         static_cast<float>(since));
    return p;
}

void advance(std::vector<Particle>& particles, const Motion& motion, double dt) {
    const Vec2 push = motion.gravity * dt;
    const auto kept = static_cast<float>(1 / (1 + motion.damping * dt));
    const auto step = static_cast<float>(dt);
    std::size_t alive = 0;
    for (const Particle& before : particles) {
        Particle p = before;
        move(p, push, kept, step);
        if (p.age < p.lifetime) particles[alive++] = p;
    }
    particles.resize(alive);
}

bool is_valid(const Particle& p) {
    for (const float x : {p.x, p.y, p.velocity_x, p.velocity_y, p.age, p.lifetime, p.angle, p.size})
        if (!std::isfinite(x)) return false;
    return p.lifetime > 0 && p.age >= 0;
}

}  // namespace fettle::visuals
