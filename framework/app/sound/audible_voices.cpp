// The audible voices of the tree, in the form that the mixer takes.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include <fettle/property/pose.h>

#include <sound/audio_state.h>

namespace fettle::app {

using property::Handle;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

/// The loudness in the far ear of a sound from the side, as a share of that in the near one.
double far_side(double pan) {
    return std::cos(std::min(1.0, pan) * std::numbers::pi / 2);
}

}  // namespace

/// The place of a voice; nothing if it sounds the same everywhere.
std::optional<Vec2> Audio::State::place(Handle voice, Handle source) const {
    if (const Value own = value(voice, *of_voice.position); own.is(Type::vec2)) return own.vec2();
    const Value offset = value(source, *of_source.position);
    const auto above = property::place_below(tree, tree.parent(source), false, 1);
    if (!offset.is(Type::vec2) && !above) return {};
    const Vec2 at = offset.is(Type::vec2) ? offset.vec2() : Vec2(0, 0);
    return above ? (*above)(at) : at;
}

Handle Audio::State::bus_of(Handle source) const {
    const Handle bus = tree.child(buses, sources[tree.row(source)].bus);
    return bus && tree.class_of(bus).is_a(*classes.bus) ? bus : Handle{};
}

bool Audio::State::ignores_pause(Handle voice) const {
    if (!value(voice, *of_voice.pauses).boolean()) return true;
    const Handle source = source_of(voice), bus = source ? bus_of(source) : Handle{};
    return bus && !value(bus, *of_bus.pauses).boolean();
}

double Audio::State::bus_loudness(Handle source) const {
    const Handle bus = bus_of(source);
    if (!bus) return 1;
    return value(bus, *of_bus.muted).boolean() ? 0 : number(bus, *of_bus.volume);
}

Stereo Audio::State::loudness(Handle voice, Handle source) const {
    if (audio.muted) return {0, 0};
    double level = audio.volume * bus_loudness(source) * number(source, *of_source.volume) *
                   number(voice, *of_voice.volume) * number(voice, *of_voice.fade);
    double left = 1, right = 1;
    if (const std::optional<Vec2> at = place(voice, source)) {
        // As it is seen: a listener that turns has other things on the right.
        const Vec2 offset = property::Transform::turned(-view.angle).direction(*at - view.center);
        const double range = number(source, *of_source.range);
        const double near = std::max(0.0, 1 - offset.length() / range);
        level *= near * near;
        // At the edge of the picture, half as loud in the far ear, also if it can be heard from
        // much farther away.
        const double pan = offset.x / std::min(range, 0.75 * view.width());
        (pan > 0 ? left : right) = far_side(std::abs(pan));
    }
    return {static_cast<float>(level * left), static_cast<float>(level * right)};
}

std::vector<AudibleVoice> Audio::State::audible_voices(bool halted) const {
    const bool paused = clock.paused && !clock.step_once;
    const double rate = paused ? 1 : clock.scale;
    std::vector<AudibleVoice> all;
    // Many voices often have one source.
    std::unordered_map<std::uint32_t, SynthParameters> known;
    for (const Handle voice : by_age()) {
        const Handle source = source_of(voice);
        if (!source || value(voice, *of_voice.over).boolean()) continue;
        const bool frozen = halted || (paused && !(at_present() && ignores_pause(voice)));
        const bool plays = !frozen && value(voice, *of_voice.playing).boolean();
        AudibleVoice one{
            .id = voice.key(),
            .time = number(voice, *of_voice.time),
            .rate = plays ? number(voice, *of_voice.pitch) * number(source, *of_source.pitch) * rate
                          : 0,
            .loudness = loudness(voice, source),
            .loops = value(source, *of_source.loop).boolean()};
        if (tree.class_of(source).is_a(*classes.synth)) {
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
