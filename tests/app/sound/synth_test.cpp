// Sounds from parameters, measured.

#include <catch.h>

#include <cmath>
#include <vector>

#include <sound/synth.h>

#include "sound_measures.h"

namespace synth_test {

using namespace fettle::app;
using sound_measures::frequency;
using sound_measures::level;
using sound_measures::rate;

namespace {

std::vector<float> sound_of(const SynthParameters& parameters) {
    Generator generator;
    std::vector<float> all;
    while (generator.time() < parameters.duration())
        all.push_back(static_cast<float>(generator.next(parameters, 1.0 / rate)));
    return all;
}

std::vector<float> part(const std::vector<float>& all, double from, double to) {
    return {all.begin() + std::ptrdiff_t(from * rate), all.begin() + std::ptrdiff_t(to * rate)};
}

SynthParameters tone(Wave wave, double hertz) {
    SynthParameters p;
    p.wave = wave;
    p.sustain = 1;
    p.decay = 0;
    p.frequency = hertz;
    return p;
}

}  // namespace

TEST_CASE("a wave has its frequency and a known level") {
    const auto check = [](Wave wave, double expected) {
        const auto sound = part(sound_of(tone(wave, 500)), 0.2, 0.9);
        CHECK(frequency(sound) == Approx(500).margin(1));
        CHECK(level(sound) == Approx(expected).margin(0.03));
    };
    check(Wave::square, 1);
    check(Wave::saw, 1 / std::sqrt(3));
    check(Wave::sine, 1 / std::sqrt(2));
    check(Wave::triangle, 1 / std::sqrt(3));
}

TEST_CASE("noise depends on its seed and on nothing else") {
    SynthParameters p = tone(Wave::noise, 300);
    const auto first = sound_of(p);
    CHECK(sound_of(p) == first);
    CHECK(level(first) == Approx(1 / std::sqrt(3)).margin(0.05));
    p.seed = 2;
    CHECK(sound_of(p) != first);
}

TEST_CASE("slide and arpeggio and retrigger move the pitch") {
    SynthParameters p = tone(Wave::sine, 400);
    p.slide = 1;
    auto sound = sound_of(p);
    CHECK(frequency(part(sound, 0.45, 0.55)) == Approx(400 * std::sqrt(2)).epsilon(0.02));
    CHECK(frequency(part(sound, 0.9, 1.0)) == Approx(400 * std::exp2(0.95)).epsilon(0.02));
    p.slide = 0;
    p.arpeggio = 12;
    p.arpeggio_time = 0.5;
    sound = sound_of(p);
    CHECK(frequency(part(sound, 0.1, 0.49)) == Approx(400).margin(2));
    CHECK(frequency(part(sound, 0.51, 0.9)) == Approx(800).margin(3));
    p.arpeggio_time = 0.2;
    p.retrigger = 0.4;
    sound = sound_of(p);
    CHECK(frequency(part(sound, 0.41, 0.59)) == Approx(400).margin(4));
    CHECK(frequency(part(sound, 0.61, 0.79)) == Approx(800).margin(6));
}

TEST_CASE("vibrato swings the pitch to both sides") {
    SynthParameters p = tone(Wave::sine, 1000);
    p.vibrato = 12;
    p.vibrato_rate = 1;
    const auto sound = sound_of(p);
    CHECK(frequency(part(sound, 0.24, 0.26)) == Approx(2000).epsilon(0.02));
    CHECK(frequency(part(sound, 0.74, 0.76)) == Approx(500).epsilon(0.02));
}

TEST_CASE("the envelope rises and stays and falls") {
    SynthParameters p = tone(Wave::sine, 1000);
    p.attack = p.sustain = p.decay = 0.2;
    p.punch = 1;
    const auto sound = sound_of(p);
    CHECK(sound.size() == Approx(0.6 * rate).margin(2));
    const double full = 1 / std::sqrt(2);
    CHECK(level(part(sound, 0.09, 0.11)) == Approx(0.5 * full).margin(0.03));
    CHECK(level(part(sound, 0.2, 0.22)) == Approx(1.95 * full).margin(0.05));
    CHECK(level(part(sound, 0.37, 0.39)) == Approx(1.1 * full).margin(0.05));
    CHECK(level(part(sound, 0.49, 0.51)) == Approx(0.5 * full).margin(0.03));
}

TEST_CASE("filters weaken what is beyond them") {
    const auto filtered = [](double hertz, double low_pass, double high_pass) {
        SynthParameters p = tone(Wave::sine, hertz);
        p.low_pass = low_pass;
        p.high_pass = high_pass;
        p.resonance = 0.3;
        return level(part(sound_of(p), 0.2, 0.9));
    };
    CHECK(filtered(200, 1000, 0) > 0.65);
    CHECK(filtered(8000, 1000, 0) < 0.05);
    CHECK(filtered(8000, 20000, 1000) > 0.6);
    CHECK(filtered(100, 20000, 1000) < 0.1);
}

TEST_CASE("a flanger takes away the tone that its delay turns around") {
    SynthParameters p = tone(Wave::sine, 500);
    p.flanger = 1;  // half a period
    CHECK(level(part(sound_of(p), 0.2, 0.9)) < 0.05);
    p.flanger = 2;  // a whole one
    CHECK(level(part(sound_of(p), 0.2, 0.9)) > 0.65);
}

TEST_CASE("parameters at the ends of their ranges make samples that are numbers") {
    for (const SynthNumber& number : synth_numbers())
        for (const double value : {number.range.min, number.range.max})
            for (const Wave wave : {Wave::square, Wave::saw, Wave::triangle, Wave::noise}) {
                SynthParameters p = tone(wave, 440);
                p.sustain = 0.1;
                p.low_pass = 2000;
                p.flanger = 1;
                p.*number.member = value;
                Generator generator;
                bool finite = true;
                for (int i = 0; i < 5000; ++i)
                    finite &= std::isfinite(generator.next(p, i % 2 == 0 ? 1e-7 : 0.002));
                INFO(number.name << " = " << value);
                CHECK(finite);
            }
}

TEST_CASE("a generator goes to a moment and makes the same samples from there") {
    SynthParameters p = tone(Wave::saw, 300);
    p.slide = 2;
    Generator straight, jumping;
    for (int i = 0; i < 30000; ++i) (void)straight.next(p, 1.0 / rate);
    jumping.go_to(p, 0.9);
    jumping.go_to(p, straight.time() + 1e-9);
    CHECK(jumping.next(p, 1.0 / rate) == Approx(straight.next(p, 1.0 / rate)));
}

TEST_CASE("the wave form has the extremes of each part") {
    SynthParameters p = tone(Wave::sine, 1000);
    p.sustain = 0.5;
    p.decay = 0.5;
    const auto columns = wave_form(p, 10);
    REQUIRE(columns.size() == 10);
    CHECK(columns[1][1] == Approx(1).margin(0.02));
    CHECK(columns[1][0] == Approx(-1).margin(0.02));
    CHECK(columns[9][1] == Approx(0.2).margin(0.02));
}

}  // namespace synth_test
