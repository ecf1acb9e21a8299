#include <sound/mixer.h>

#include <algorithm>
#include <cmath>

namespace fettle::app {

namespace {

constexpr double frame_time = 1.0 / Mixer::rate;
/// Loudness follows a change with this time constant, so that nothing clicks.
constexpr float loudness_step = 1.0f / (0.003f * Mixer::rate);
constexpr float inaudible = 1e-4f;
/// A voice that ends in the tree while this much of it is left plays to its end: the device is a
/// little behind the tree.
constexpr double rest = 0.15;  // s

/// Leaves quiet sounds as they are and bends loud ones, so that many voices are not cut off.
float limited(float level) {
    constexpr float straight = 0.8f, above = 1 - straight;
    const float size = std::abs(level);
    if (size <= straight) return level;
    return std::copysign(straight + above * std::tanh((size - straight) / above), level);
}

Stereo between(const Stereo& a, const Stereo& b, float share) {
    return {a.left + (b.left - a.left) * share, a.right + (b.right - a.right) * share};
}

bool silent(const Stereo& loudness) {
    return loudness.left < inaudible && loudness.right < inaudible;
}

}  // namespace

Stereo Mixer::Playing::sample() {
    if (heard.samples == nullptr && heard.file == nullptr) {
        const auto level = static_cast<float>(generator.next(heard.synth, speed * frame_time));
        return {level, level};
    }
    if (heard.samples == nullptr && reader == nullptr)
        reader = std::make_unique<SoundReader>(heard.file);
    const unsigned file_rate = heard.samples ? heard.samples->rate : heard.file->rate();
    const double at = position * file_rate;
    const auto index = static_cast<std::uint64_t>(at);
    const auto share = static_cast<float>(at - std::floor(at));
    if (heard.samples != nullptr)
        return between(heard.samples->frame(index), heard.samples->frame(index + 1), share);
    const Stereo first = reader->frame(index);
    return between(first, reader->frame(index + 1), share);
}

void Mixer::Playing::advance() {
    position += speed * frame_time;
    if (position < heard.duration || !heard.loops || heard.duration <= 0) return;
    position = std::fmod(position, heard.duration);
    generator = {};
}

void Mixer::Playing::add_to(std::span<float> mix) {
    const bool pauses = heard.rate <= 0;
    const Stereo target = released || pauses ? Stereo{0, 0} : heard.loudness;
    for (std::size_t i = 0; i + 1 < mix.size() && !over(); i += 2) {
        if ((released || pauses) && silent(loudness)) break;
        loudness = between(loudness, target, loudness_step);
        const Stereo level = sample();
        mix[i] += level.left * loudness.left;
        mix[i + 1] += level.right * loudness.right;
        advance();
    }
}

Mixer::Playing Mixer::begun(Heard heard) {
    Playing voice;
    // A voice that has just begun is a step old. It sounds from its beginning, which is loud often.
    const bool new_one = heard.time < 0.1 * std::max(1.0, heard.rate);
    voice.position = new_one ? 0 : heard.time;
    if (new_one && heard.rate > 0) voice.loudness = heard.loudness;
    if (heard.rate > 0) voice.speed = heard.rate;
    if (heard.samples == nullptr && heard.file == nullptr)
        voice.generator.go_to(heard.synth, voice.position);
    voice.heard = std::move(heard);
    return voice;
}

void Mixer::release(Playing& voice) {
    const double left = (voice.heard.duration - voice.position) / voice.speed;
    const bool ends = !voice.heard.loops && voice.heard.rate > 0 && left < rest;
    voice.heard.id = 0;
    voice.released = !ends;
}

bool Mixer::far_off(const Playing& voice, const Heard& to) {
    double off = std::abs(to.time - voice.position);
    if (to.loops && to.duration > 0) off = std::min(off, std::abs(to.duration - off));
    return off > tolerance * std::max(1.0, to.rate);
}

void Mixer::adapt(Playing& voice, const Heard& to) {
    voice.heard = to;
    if (to.rate > 0) voice.speed = to.rate;
}

/// Takes over the sounds to be heard now.
void Mixer::exchange() {
    std::optional<std::vector<Heard>> next;
    {
        const std::lock_guard lock(mutex_);
        next.swap(next_);
    }
    if (!next) return;
    for (Playing& voice : playing_) {
        if (voice.heard.id == 0) continue;
        const auto to = std::ranges::find(*next, voice.heard.id, &Heard::id);
        const bool same =
            to != next->end() && to->samples == voice.heard.samples && to->file == voice.heard.file;
        if (same && !far_off(voice, *to)) {
            adapt(voice, *to);
        } else if (same && voice.heard.rate <= 0 && silent(voice.loudness)) {
            voice = begun(*to);
        } else {
            release(voice);
            // One that jumps must not go on to its end.
            if (to != next->end()) voice.released = true;
        }
    }
    for (Heard& heard : *next)
        if (std::ranges::none_of(playing_,
                                 [&](const Playing& voice) { return voice.heard.id == heard.id; }))
            playing_.push_back(begun(std::move(heard)));
}

void Mixer::hear(std::vector<Heard> all) {
    const std::lock_guard lock(mutex_);
    next_ = std::move(all);
}

void Mixer::fill(std::span<std::int16_t> out) {
    exchange();
    mix_.assign(out.size(), 0.0f);
    for (Playing& voice : playing_) voice.add_to(mix_);
    std::erase_if(playing_, [](const Playing& voice) {
        return voice.heard.id == 0 && (voice.over() || silent(voice.loudness));
    });
    std::ranges::transform(mix_, out.begin(), [](float level) {
        return static_cast<std::int16_t>(std::lround(32767 * limited(level)));
    });
}

}  // namespace fettle::app
