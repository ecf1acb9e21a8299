#include <emitters/emitters.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <fettle/property/pose.h>

#include <properties/properties.h>

namespace fettle::visuals {

using property::Handle;
using property::Transform;
using property::Vec2;

namespace {

constexpr int dot_size = 32;  // px

/// Greatest number of particles of all emitters together; a step moves them in some milliseconds.
constexpr std::size_t most_in_game = 500'000;

/// A white disc with a soft edge.
std::vector<std::uint8_t> dot_pixels() {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(dot_size * dot_size * 4);
    for (int y = 0; y < dot_size; ++y)
        for (int x = 0; x < dot_size; ++x) {
            const double middle = 0.5 * (dot_size - 1);
            const double far = std::hypot(x - middle, y - middle) / (0.5 * dot_size);
            const double opacity = std::clamp(4 * (1 - far), 0.0, 1.0);
            rgba.insert(rgba.end(), {255, 255, 255, static_cast<std::uint8_t>(255 * opacity)});
        }
    return rgba;
}

}  // namespace

Emitters::Emitters(Images& images) : images_(images) {
    dot_.replace(dot_size, dot_size, dot_pixels());
}

property::Row Emitters::add(Handle self) {
    auto row = static_cast<property::Row>(rows_.size());
    if (free_.empty()) {
        rows_.emplace_back();
    } else {
        row = free_.back();
        free_.pop_back();
    }
    rows_[row].state.self = self;
    return row;
}

/// Whether it is in a layer on the screen, so that its coordinates are pixels, y down.
bool Emitters::on_screen(Handle self) const {
    for (Handle up = tree_->parent(self); up; up = tree_->parent(up)) {
        const property::Class& of = tree_->class_of(up);
        if (of.lifecycle().begin_below == nullptr) continue;
        const property::Property* const space = of.property("space");
        if (space != nullptr && tree_->peek(up, *space) == property::Value("screen")) return true;
    }
    return false;
}

Motion Emitters::motion_of(const Row& row) const {
    const Reader read(*tree_, row.state.self);
    return {read.vec2(of_.gravity), read.number(of_.damping)};
}

Birth Emitters::birth_of(const Row& row, const Transform& now, bool on_screen) const {
    const Reader read(*tree_, row.state.self);
    Birth birth;
    birth.to = now;
    birth.from = row.state.placed ? row.state.at : now;
    birth.shape =
        static_cast<EmitterShape>(of_.shape->enumerator_index(read.value(of_.shape).text()));
    birth.area = read.vec2(of_.area);
    birth.lifetime = read.number(of_.lifetime);
    birth.speed = read.number(of_.speed);
    birth.spread = read.number(of_.spread);
    birth.randomness = read.number(of_.randomness);
    birth.turns = read.number(of_.rotation) != 0;
    birth.on_screen = on_screen;
    birth.seed = static_cast<std::uint64_t>(read.value(of_.seed).integer());
    return birth;
}

void Emitters::advance(Row& row, double dt) {
    State& state = row.state;
    const Reader read(*tree_, state.self);
    const Motion motion = motion_of(row);
    visuals::advance(row.particles, motion, dt);
    state.last_dt = dt;
    const bool screen = on_screen(state.self);
    // Particles that move with the emitter are in its coordinates.
    const bool in_world = read.value(of_.space).text() == "world";
    Transform now;
    if (in_world) now = property::place_below(*tree_, state.self, screen, 1).value_or(Transform());
    const bool playing = read.flag(of_.playing);
    std::size_t at_once = std::exchange(state.wanted, 0);
    double due = 0;
    if (!playing) {
        state.burst = false;
        state.owed = 0;
    } else {
        if (!std::exchange(state.burst, true))
            at_once += static_cast<std::size_t>(read.value(of_.burst).integer());
        due = read.number(of_.rate) * dt;
    }
    auto limit = static_cast<std::size_t>(read.value(of_.limit).integer());
    if (row.particles.size() > limit) row.particles.resize(limit);
    limit = std::min(limit, row.particles.size() + most_in_game - std::min(most_in_game, all_));
    const std::size_t before_births = row.particles.size();
    if (at_once > 0 || due > 0) {
        const Birth birth = birth_of(row, now, screen);
        // As many particles begin in this step as `owed` has whole numbers; the fraction is kept.
        const double before = state.owed;
        state.owed += due;
        for (double n = 1; n <= state.owed; ++n) {
            const double moment = due > 0 ? std::clamp((n - before) / due, 0.0, 1.0) : 1;
            if (row.particles.size() < limit)
                row.particles.push_back(new_particle(birth, motion, state.born++, moment, dt));
            else
                break;
        }
        state.owed -= std::floor(state.owed);
        for (; at_once > 0 && row.particles.size() < limit; --at_once)
            row.particles.push_back(new_particle(birth, motion, state.born++, 1, dt));
    }
    all_ += row.particles.size() - before_births;
    state.at = now;
    state.placed = in_world;
    const bool was_busy = std::exchange(state.busy, !row.particles.empty());
    if (was_busy && !state.busy && (!playing || read.number(of_.rate) == 0))
        ended_.push_back(state.self);
}

void Emitters::step(double dt) {
    ended_.clear();
    all_ = 0;
    for (const Row& row : rows_) all_ += row.particles.size();
    for (Row& row : rows_) {
        if (!row.state.self) continue;
        (void)sheet_of(row);  // reports a missing file also if nothing is drawn
        // A detached emitter is not in the game yet.
        if (tree_->parent(row.state.self))
            advance(row, dt);
        else
            row.state.placed = false;  // it may come back at another place
    }
}

void Emitters::report() {
    for (const Handle self : std::exchange(ended_, {}))
        if (tree_->alive(self) && tree_->listens(self, *finished_))
            tree_->emit(self, *finished_, {});
}

std::uint64_t Emitters::hash() const {
    std::uint64_t hash = 0;
    const auto mix = [&hash](std::uint64_t bits) { hash = (hash ^ bits) * 0x9e3779b97f4a7c15u; };
    // In the order of the tree: after a restore, they may be in other rows.
    const property::Class& emitter = tree_->class_named("Emitter");
    tree_->each_below(tree_->root(), [&](Handle instance) {
        if (!tree_->class_of(instance).is_a(emitter)) return;
        const Row& row = rows_[tree_->row(instance)];
        mix(row.state.born);
        for (const Particle& p : row.particles) {
            std::uint64_t words[sizeof(Particle) / 8];
            std::memcpy(words, &p, sizeof p);
            for (const std::uint64_t word : words) mix(word);
        }
    });
    return hash;
}

}  // namespace fettle::visuals
