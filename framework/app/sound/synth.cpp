#include <sound/synth.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fettle::app {

namespace {

constexpr double sample_time = 1.0 / 44100;  // s
constexpr int control_interval = 16;         // samples between two updates of slow parameters
constexpr std::size_t longest_delay = 4096;  // samples
constexpr double noise_values = 32;          // random values in one period
constexpr double no_low_pass = 20000;        // Hz, from here on the filter is off
constexpr double lowest_kept = 10;  // Hz; removes the constant part of a square with `duty` != 0.5

using P = SynthParameters;

constexpr std::array numbers_of_synth{
    SynthNumber{"attack", &P::attack, {0, 10}, "s", 0, "How long the sound takes to become loud."},
    SynthNumber{"sustain", &P::sustain, {0, 10}, "s", 0, "How long it stays loud."},
    SynthNumber{"decay", &P::decay, {0, 10}, "s", 0, "How long it takes to end."},
    SynthNumber{"punch",
                &P::punch,
                {0, 1},
                "",
                0.2,
                "How much louder it is at the beginning of `sustain`: 1 is twice as loud."},
    SynthNumber{"frequency", &P::frequency, {1, 20000}, "Hz", 0, "The pitch at the beginning."},
    SynthNumber{"slide",
                &P::slide,
                {-100, 100},
                "1/s",
                1,
                "Octaves a second by which the pitch rises, or falls if negative."},
    SynthNumber{"slide_change",
                &P::slide_change,
                {-1000, 1000},
                "1/s²",
                2,
                "How fast `slide` itself changes, in octaves a second each second."},
    SynthNumber{"vibrato",
                &P::vibrato,
                {0, 24},
                "",
                0.5,
                "How far the pitch swings to either side, in semitones."},
    SynthNumber{"vibrato_rate", &P::vibrato_rate, {0, 200}, "Hz", 0, "How often it swings."},
    SynthNumber{"arpeggio",
                &P::arpeggio,
                {-48, 48},
                "",
                2,
                "Semitones by which the pitch jumps at `arpeggio_time`."},
    SynthNumber{"arpeggio_time", &P::arpeggio_time, {0, 10}, "s", 0, "When the pitch jumps."},
    SynthNumber{"retrigger",
                &P::retrigger,
                {0, 10},
                "s",
                0,
                "After this time slides and arpeggio begin again, again and again. 0: never."},
    SynthNumber{"duty",
                &P::duty,
                {0.01, 0.99},
                "",
                0.1,
                "The part of a period in which a square wave is high. Other waves have none."},
    SynthNumber{
        "duty_slide", &P::duty_slide, {-100, 100}, "1/s", 0.3, "How much `duty` grows a second."},
    SynthNumber{"flanger",
                &P::flanger,
                {0, 50},
                "ms",
                0.5,
                "The sound is heard a second time, with this delay. 0: once."},
    SynthNumber{
        "flanger_slide", &P::flanger_slide, {-1000, 1000}, "ms/s", 2, "How fast that delay grows."},
    SynthNumber{"low_pass",
                &P::low_pass,
                {20, no_low_pass},
                "Hz",
                0,
                "Higher tones than this are weakened, which sounds dull. 20000: none."},
    SynthNumber{"low_pass_slide",
                &P::low_pass_slide,
                {-100, 100},
                "1/s",
                1,
                "Octaves a second by which `low_pass` rises."},
    SynthNumber{
        "resonance", &P::resonance, {0, 1}, "", 0.1, "How much tones at `low_pass` stand out."},
    SynthNumber{"high_pass",
                &P::high_pass,
                {0, 20000},
                "Hz",
                0,
                "Lower tones than this are weakened, which sounds thin. 0: none."},
    SynthNumber{"high_pass_slide",
                &P::high_pass_slide,
                {-100, 100},
                "1/s",
                1,
                "Octaves a second by which `high_pass` rises."},
};

/// The same number for the same arguments, -1 to 1, with no visible order.
double noise(std::int64_t seed, std::uint64_t index) {
    std::uint64_t z = static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + index;
    z = (z ^ (z >> 32)) * 0xd6e8feb86659fd93u;
    z = (z ^ (z >> 32)) * 0xd6e8feb86659fd93u;
    z ^= z >> 32;
    return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

/// Rounds the step of a wave at phase 0 over the two samples around it, so that it has hardly any
/// tones above half the sample rate (Välimäki and Huovilainen 2007, "Antialiasing oscillators in
/// subtractive synthesis": polynomial band-limited steps). `d`: phase of one sample.
double smooth_step(double phase, double d) {
    if (phase < d) {
        const double t = phase / d;
        return 2 * t - t * t - 1;
    }
    if (phase > 1 - d) {
        const double t = (phase - 1) / d;
        return t * t + 2 * t + 1;
    }
    return 0;
}

/// `phase`, 0 to 2, within one period. Faster than `std::floor`, a function call on most machines.
double wrapped(double phase) {
    return phase >= 1 ? phase - 1 : phase;
}

}  // namespace

std::span<const SynthNumber> synth_numbers() {
    return numbers_of_synth;
}

/// Computes the slowly changing values: frequency, duty and the filters.
void Generator::control(const SynthParameters& p, double dt) {
    const double since = p.retrigger > 0 ? std::fmod(time_, p.retrigger) : time_;
    const double turn = 2 * std::numbers::pi * time_;
    double octaves = p.slide * since + p.slide_change * since * since / 2;
    octaves += p.vibrato / 12 * std::sin(turn * p.vibrato_rate);
    if (since >= p.arpeggio_time) octaves += p.arpeggio / 12;
    frequency_ = std::clamp(p.frequency * std::exp2(std::clamp(octaves, -60.0, 60.0)), 1.0, 2e4);
    duty_ = std::clamp(p.duty + p.duty_slide * since, 0.01, 0.99);

    const auto moved = [&](double from, double slide) {
        return from * std::exp2(std::clamp(slide * time_, -60.0, 60.0));
    };
    const double low = moved(p.low_pass, p.low_pass_slide);
    low_.on = low < no_low_pass;
    low_.g = std::tan(std::numbers::pi * std::min(low * dt, 0.45));
    low_.k = 2 - 1.9 * p.resonance;
    low_.a = 1 / (1 + low_.g * (low_.g + low_.k));
    const double high = std::clamp(moved(p.high_pass, p.high_pass_slide), lowest_kept, 2e4);
    high_.a = 1 / (1 + 2 * std::numbers::pi * high * dt);

    const double delay = std::clamp(p.flanger + p.flanger_slide * time_, 0.0, 50.0) / 1000 / dt;
    behind_ = p.flanger > 0 ? static_cast<std::size_t>(std::min(delay, longest_delay - 1.0)) : 0;
    if (behind_ > 0 && delay_.empty()) delay_.resize(longest_delay);
}

double Generator::oscillator(const SynthParameters& p, double dt) {
    const double d = std::min(frequency_ * dt, 0.5);
    double sample = 0;
    switch (p.wave) {
        case Wave::square:
            sample = (phase_ < duty_ ? 1 : -1) + smooth_step(phase_, d) -
                     smooth_step(wrapped(phase_ + 1 - duty_), d);
            break;
        case Wave::saw:
            sample = 2 * phase_ - 1 - smooth_step(phase_, d);
            break;
        case Wave::sine:
            sample = std::sin(2 * std::numbers::pi * phase_);
            break;
        case Wave::triangle:
            sample = 1 - 4 * std::abs(wrapped(phase_ + 0.25) - 0.5);
            break;
        case Wave::noise:
            sample = noise(p.seed, static_cast<std::uint64_t>(noise_phase_));
            break;
    }
    phase_ = wrapped(phase_ + d);
    noise_phase_ += noise_values * d;
    return sample;
}

/// A state variable filter in the form of Zavalishin ("The Art of VA Filter Design", 2012), then a
/// filter of first order.
double Generator::filtered(double sample) {
    if (low_.on) {
        const double v3 = sample - low_.second;
        const double v1 = low_.a * (low_.first + low_.g * v3);
        const double v2 = low_.second + low_.g * v1;
        low_.first = 2 * v1 - low_.first;
        low_.second = 2 * v2 - low_.second;
        sample = v2;
    }
    high_.out = high_.a * (high_.out + sample - high_.in);
    high_.in = sample;
    return high_.out;
}

double Generator::flanged(double sample) {
    if (delay_.empty()) return sample;
    at_ = (at_ + 1) % longest_delay;
    delay_[at_] = static_cast<float>(sample);
    if (behind_ == 0) return sample;
    return 0.5 * (sample + double{delay_[(at_ + longest_delay - behind_) % longest_delay]});
}

double Generator::envelope(const SynthParameters& p) const {
    if (time_ < p.attack) return time_ / p.attack;
    const double held = time_ - p.attack;
    if (held < p.sustain) return 1 + p.punch * (1 - held / p.sustain);
    const double left = p.duration() - time_;
    return left > 0 && p.decay > 0 ? std::min(1.0, left / p.decay) : 0;
}

double Generator::next(const SynthParameters& parameters, double dt) {
    if (until_control_ == 0) {
        control(parameters, dt);
        until_control_ = control_interval;
    }
    --until_control_;
    const double sample = envelope(parameters) * flanged(filtered(oscillator(parameters, dt)));
    time_ += dt;
    return sample;
}

void Generator::go_to(const SynthParameters& parameters, double seconds) {
    if (seconds < time_) *this = {};
    while (time_ + sample_time <= seconds) (void)next(parameters, sample_time);
}

std::vector<std::array<double, 2>> wave_form(const SynthParameters& parameters,
                                             std::size_t columns) {
    std::vector<std::array<double, 2>> all(columns, {0, 0});
    Generator generator;
    const double duration = parameters.duration();
    while (generator.time() < duration) {
        const auto column =
            static_cast<std::size_t>(generator.time() / duration * static_cast<double>(columns));
        const double sample = generator.next(parameters, sample_time);
        auto& [low, high] = all[std::min(column, columns - 1)];
        low = std::min(low, sample);
        high = std::max(high, sample);
    }
    return all;
}

}  // namespace fettle::app
