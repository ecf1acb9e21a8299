#include <sound/mixer.h>

#include <algorithm>
#include <cmath>

namespace fettle::app {

namespace {

constexpr double frame_time = 1.0 / Mixer::rate;
/// Loudness follows a change with this time constant, so that nothing clicks.
constexpr float loudness_step = 1.0f / (0.003f * Mixer::rate);
constexpr float inaudible = 1e-4f;
/// If a voice ends in the tree and less than this time is left of it, it is played to its end: the
/// sound device is a little behind the tree.
constexpr double longest_tail = 0.15;  // s

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
    if (state.samples == nullptr && state.file == nullptr) {
        const auto level = static_cast<float>(generator.next(state.synth, speed * frame_time));
        return {level, level};
    }
    if (state.samples == nullptr && reader == nullptr)
        reader = std::make_unique<SoundReader>(state.file);
    const unsigned file_rate = state.samples ? state.samples->rate : state.file->rate();
    const double at = position * file_rate;
    const auto index = static_cast<std::uint64_t>(at);
    const auto share = static_cast<float>(at - std::floor(at));
    // A sound that begins again goes from its last frame to its first one.
    const std::uint64_t frames = state.samples ? state.samples->frames() : state.file->frames();
    const bool turns = state.loops && index + 1 == frames;
    if (state.samples != nullptr)
        return between(state.samples->frame(index), state.samples->frame(turns ? 0 : index + 1),
                       share);
    const Stereo first = reader->frame(index);
    return between(first, turns ? reader->first_frame() : reader->frame(index + 1), share);
}

void Mixer::Playing::advance() {
    position += speed * frame_time;
    if (position < state.duration || !state.loops || state.duration <= 0) return;
    position = std::fmod(position, state.duration);
    generator = {};
}

void Mixer::Playing::add_to(std::span<float> mix) {
    const bool pauses = state.rate <= 0;
    const Stereo target = released || pauses ? Stereo{0, 0} : state.loudness;
    for (std::size_t i = 0; i + 1 < mix.size() && !over(); i += 2) {
        if ((released || pauses) && silent(loudness)) break;
        loudness = between(loudness, target, loudness_step);
        const Stereo level = sample();
        mix[i] += level.left * loudness.left;
        mix[i + 1] += level.right * loudness.right;
        advance();
    }
}

Mixer::Playing Mixer::begun(AudibleVoice state) {
    Playing voice;
    // A voice that has just begun is a step old. It is played from its beginning, because that is
    // often the loudest part.
    const bool new_one = state.time < 0.1 * std::max(1.0, state.rate);
    // A synth computes all samples up to its position, so the position is at most the end.
    const double time = state.loops && state.duration > 0 ? std::fmod(state.time, state.duration)
                                                          : std::min(state.time, state.duration);
    voice.position = new_one ? 0 : time;
    if (new_one && state.rate > 0) voice.loudness = state.loudness;
    if (state.rate > 0) voice.speed = state.rate;
    if (state.samples == nullptr && state.file == nullptr)
        voice.generator.go_to(state.synth, voice.position);
    voice.state = std::move(state);
    return voice;
}

void Mixer::release(Playing& voice) {
    const double left = (voice.state.duration - voice.position) / voice.speed;
    const bool ends = !voice.state.loops && voice.state.rate > 0 && left < longest_tail;
    voice.state.id = 0;
    voice.released = !ends;
}

bool Mixer::far_off(const Playing& voice, const AudibleVoice& to) {
    double off = std::abs(to.time - voice.position);
    if (to.loops && to.duration > 0) off = std::min(off, std::abs(to.duration - off));
    return off > tolerance * std::max(1.0, to.rate);
}

void Mixer::adapt(Playing& voice, const AudibleVoice& to) {
    voice.state = to;
    if (to.rate > 0) voice.speed = to.rate;
}

/// Takes over the voices that sound now.
void Mixer::exchange() {
    std::optional<std::vector<AudibleVoice>> next;
    {
        const std::lock_guard lock(mutex_);
        next.swap(next_);
    }
    if (!next) return;
    for (Playing& voice : playing_) {
        if (voice.state.id == 0) continue;
        const auto to = std::ranges::find(*next, voice.state.id, &AudibleVoice::id);
        const bool same =
            to != next->end() && to->samples == voice.state.samples && to->file == voice.state.file;
        if (same && !far_off(voice, *to)) {
            adapt(voice, *to);
        } else if (same && voice.state.rate <= 0 && silent(voice.loudness)) {
            voice = begun(*to);
        } else {
            release(voice);
            // One that jumps must not go on to its end.
            if (to != next->end()) voice.released = true;
        }
    }
    for (AudibleVoice& state : *next)
        if (std::ranges::none_of(playing_,
                                 [&](const Playing& voice) { return voice.state.id == state.id; }))
            playing_.push_back(begun(std::move(state)));
}

void Mixer::set_voices(std::vector<AudibleVoice> all) {
    const std::lock_guard lock(mutex_);
    next_ = std::move(all);
}

void Mixer::fill(std::span<std::int16_t> out) {
    exchange();
    mix_.assign(out.size(), 0.0f);
    for (Playing& voice : playing_) voice.add_to(mix_);
    std::erase_if(playing_, [](const Playing& voice) {
        return voice.state.id == 0 && (voice.over() || silent(voice.loudness));
    });
    std::ranges::transform(mix_, out.begin(), [](float level) {
        return static_cast<std::int16_t>(std::lround(32767 * limited(level)));
    });
}

}  // namespace fettle::app
