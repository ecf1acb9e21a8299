// What is to be heard: the voices in the tree as the mixer takes them.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include <sound/audio_state.h>

namespace fettle::app {

using property::Handle;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

/// The end on the far side of a sound that is heard from the side, as a part of the near one.
double far_side(double pan) {
    return std::cos(std::min(1.0, pan) * std::numbers::pi / 2);
}

Vec2 turned(const Vec2& v, double angle) {
    return {v.x() * std::cos(angle) - v.y() * std::sin(angle),
            v.x() * std::sin(angle) + v.y() * std::cos(angle)};
}

}  // namespace

/// Where a voice is heard from; nothing if it is heard everywhere the same. Positions of bodies are
/// positions in the world, those of other instances are relative to the instance above.
std::optional<Vec2> Audio::State::place(Handle voice, Handle source) const {
    if (const Value own = value(voice, *of_voice.position); own.is(Type::vec2)) return own.vec2();
    const Value offset = value(source, *of_source.position);
    Vec2 at = offset.is(Type::vec2) ? offset.vec2() : Vec2(0, 0);
    bool placed = offset.is(Type::vec2);
    const property::Class* body = tree.find_class("Body");
    for (Handle up = tree.parent(source); up; up = tree.parent(up)) {
        const property::Class& of = tree.class_of(up);
        const Property* position = of.property("position");
        if (position == nullptr || position->type != Type::vec2) continue;
        const Value there = value(up, *position);
        if (!there.is(Type::vec2)) continue;
        const Property* angle = of.property("angle");
        const bool turns = angle != nullptr && angle->type == Type::number;
        at = there.vec2() + turned(at, turns ? number(up, *angle) : 0);
        placed = true;
        if (body != nullptr && of.is_a(*body)) break;
    }
    if (!placed) return {};
    return at;
}

double Audio::State::bus_loudness(Handle source) const {
    const Handle bus = tree.child(buses, sources[tree.row(source)].bus);
    if (!bus || !tree.class_of(bus).is_a(*bus_class)) return 1;
    return value(bus, *bus_muted).boolean() ? 0 : number(bus, *bus_volume);
}

Stereo Audio::State::loudness(Handle voice, Handle source) const {
    if (audio.muted) return {0, 0};
    double level = audio.volume * bus_loudness(source) * number(source, *of_source.volume) *
                   number(voice, *of_voice.volume) * number(voice, *of_voice.fade);
    double left = 1, right = 1;
    if (const std::optional<Vec2> at = place(voice, source)) {
        const Vec2 offset = *at - view.center;
        const double range = number(source, *of_source.range);
        const double near = std::max(0.0, 1 - offset.norm() / range);
        level *= near * near;
        const double pan = offset.x() / range;
        (pan > 0 ? left : right) = far_side(std::abs(pan));
    }
    return {static_cast<float>(level * left), static_cast<float>(level * right)};
}

std::vector<Heard> Audio::State::heard(bool halted) const {
    const bool stands = halted || (clock.paused && !clock.step_once);
    std::vector<Heard> all;
    // Many voices often have one source.
    std::unordered_map<std::uint32_t, SynthParameters> known;
    for (const Handle voice : by_age()) {
        const Handle source = source_of(voice);
        if (!source || value(voice, *of_voice.over).boolean()) continue;
        const bool plays = !stands && value(voice, *of_voice.playing).boolean();
        Heard one{.id = std::uint64_t{voice.generation} << 32 | voice.index,
                  .time = number(voice, *of_voice.time),
                  .rate = plays ? number(voice, *of_voice.pitch) *
                                      number(source, *of_source.pitch) * clock.scale
                                : 0,
                  .loudness = loudness(voice, source),
                  .loops = value(source, *of_source.loop).boolean()};
        if (tree.class_of(source).is_a(*synth_class)) {
            const auto [found, is_new] = known.try_emplace(source.index);
            if (is_new) found->second = synth_parameters(source);
            one.synth = found->second;
            one.duration = one.synth.duration();
        } else if (const auto& file = sources[tree.row(source)].sound; file != nullptr) {
            one.duration = file->duration();
            if (is_music(source))
                one.file = file;
            else
                one.samples = file->samples();
        }
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace fettle::app
