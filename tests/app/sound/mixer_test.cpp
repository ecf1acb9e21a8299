// The output of the mixer, measured without a device.

#include <catch.h>

#include <atomic>
#include <thread>

#include <sound/mixer.h>

#include "sound_measures.h"

namespace mixer_test {

using namespace fettle::app;
using namespace sound_measures;

namespace {

/// A second of 300 Hz, then one of 900 Hz.
std::string two_tones() {
    return wave_file(2, 1, 22050,
                     [](unsigned, double t) { return 0.5 * sine(t < 1 ? 300 : 900, t); });
}

AudibleVoice sound(const std::string& bytes, std::uint64_t id = 1) {
    const SoundFile file(bytes);
    return {.id = id, .samples = file.samples(), .duration = file.duration()};
}

AudibleVoice music(const std::string& bytes, std::uint64_t id = 1) {
    const auto file = std::make_shared<const SoundFile>(bytes);
    return {.id = id, .file = file, .duration = file->duration()};
}

}  // namespace

TEST_CASE("a voice sounds at its pitch and its level and ends") {
    for (const AudibleVoice& heard :
         {sound(tone_file(440, 0.5)), music(tone_file(440, 0.5)), sound(tone_file(440, 0.5, 8000)),
          music(tone_file(440, 0.5, 48000))}) {
        Mixer mixer;
        mixer.set_voices({heard});
        const Signal all = mixed(mixer, 1);
        CHECK(frequency(all.part(0.1, 0.4).left) == Approx(440).margin(1));
        CHECK(level(all.part(0.1, 0.4).left) == Approx(0.5 / std::sqrt(2)).margin(0.01));
        CHECK(length(all.left) == Approx(0.5).margin(0.01));
        CHECK(all.left == all.right);
    }
}

TEST_CASE("a voice of twice the rate is an octave higher and half as long") {
    Mixer mixer;
    AudibleVoice heard = sound(tone_file(440, 0.5));
    heard.rate = 2;
    mixer.set_voices({heard});
    const Signal all = mixed(mixer, 1);
    CHECK(frequency(all.part(0.05, 0.2).left) == Approx(880).margin(2));
    CHECK(length(all.left) == Approx(0.25).margin(0.01));
}

TEST_CASE("the left and right loudness of a voice and the channels of a sound are kept apart") {
    Mixer mixer;
    AudibleVoice heard = sound(tone_file(440, 1));
    heard.loudness = {0.5f, 0.1f};
    mixer.set_voices({heard});
    const Signal all = mixed(mixer, 0.5);
    CHECK(level(all.left) == Approx(5 * level(all.right)).epsilon(0.02));
    const std::string stereo = wave_file(
        1, 2, rate, [](unsigned c, double t) { return 0.5 * sine(c == 0 ? 300 : 700, t); });
    Mixer both;
    both.set_voices({sound(stereo)});
    const Signal two = mixed(both, 0.5);
    CHECK(frequency(two.left) == Approx(300).margin(1));
    CHECK(frequency(two.right) == Approx(700).margin(1));
}

TEST_CASE("a voice that loops goes on and stays in time") {
    for (AudibleVoice heard : {sound(tone_file(440, 0.1)), music(tone_file(440, 0.1))}) {
        Mixer mixer;
        heard.loops = true;
        for (int i = 0; i < 60; ++i) {
            heard.time = std::fmod(i / 60.0, 0.1);
            mixer.set_voices({heard});
            CHECK(level(mixed(mixer, 1.0 / 60).left) > 0.2);
        }
        CHECK(mixer.size() == 1);
    }
}

TEST_CASE("a voice that pauses is silent and goes on where it was") {
    Mixer mixer;
    AudibleVoice heard = sound(two_tones());
    mixer.set_voices({heard});
    (void)mixed(mixer, 0.5);
    heard.time = 0.5;
    heard.rate = 0;
    mixer.set_voices({heard});
    (void)mixed(mixer, 0.1);
    CHECK(level(mixed(mixer, 2).left) == 0);
    heard.rate = 1;
    mixer.set_voices({heard});
    const Signal rest = mixed(mixer, 2);
    CHECK(frequency(rest.part(0.05, 0.4).left) == Approx(300).margin(1));
    CHECK(frequency(rest.part(0.6, 1.3).left) == Approx(900).margin(2));
    CHECK(length(rest.left) == Approx(1.5).margin(0.05));
}

TEST_CASE("a voice moves to another time when the game does and ignores small differences") {
    for (AudibleVoice heard : {sound(two_tones()), music(two_tones())}) {
        Mixer mixer;
        mixer.set_voices({heard});
        (void)mixed(mixer, 0.5);
        heard.time = 0.45;  // less than the tolerance for the clock of the device
        mixer.set_voices({heard});
        const Signal same = mixed(mixer, 0.3);
        CHECK(frequency(same.left) == Approx(300).margin(1));
        heard.time = 1.5;
        mixer.set_voices({heard});
        CHECK(frequency(mixed(mixer, 0.3).part(0.05, 0.3).left) == Approx(900).margin(2));
        heard.time = 0.2;  // back
        mixer.set_voices({heard});
        const Signal back = mixed(mixer, 3);
        CHECK(frequency(back.part(0.05, 0.7).left) == Approx(300).margin(1));
        CHECK(length(back.left) == Approx(1.8).margin(0.05));
        CHECK(mixer.size() == 1);
    }
}

TEST_CASE("a voice that has ended in the tree fades or plays its last moment") {
    Mixer mixer;
    mixer.set_voices({sound(tone_file(440, 1))});
    (void)mixed(mixer, 0.3);
    mixer.set_voices({});
    CHECK(length(mixed(mixer, 0.5).left) < 0.03);
    CHECK(mixer.size() == 0);
    mixer.set_voices({sound(tone_file(440, 1))});
    (void)mixed(mixer, 0.9);
    mixer.set_voices({});
    CHECK(length(mixed(mixer, 0.5).left) == Approx(0.1).margin(0.02));
    CHECK(mixer.size() == 0);
}

TEST_CASE("parameters of a synth change while it sounds") {
    Mixer mixer;
    AudibleVoice heard{.id = 1};
    heard.synth.wave = Wave::sine;
    heard.synth.sustain = heard.duration = 5;
    mixer.set_voices({heard});
    CHECK(frequency(mixed(mixer, 0.3).left) == Approx(440).margin(1));
    heard.synth.frequency = 1000;
    heard.time = 0.3;
    mixer.set_voices({heard});
    CHECK(frequency(mixed(mixer, 0.3).part(0.01, 0.3).left) == Approx(1000).margin(2));
}

TEST_CASE("many loud voices are limited and never wrap around") {
    Mixer mixer;
    std::vector<AudibleVoice> all;
    for (std::uint64_t id = 1; id <= 64; ++id) all.push_back(sound(tone_file(440, 1), id));
    mixer.set_voices(all);
    const Signal out = mixed(mixer, 0.3);
    CHECK(*std::ranges::max_element(out.left) <= 1);
    CHECK(*std::ranges::max_element(out.left) > 0.9);
    // A sine that is bent at the top crosses zero as often as before.
    CHECK(frequency(out.left) == Approx(440).margin(1));
}

TEST_CASE("the sounds to be heard change while another thread makes the samples") {
    Mixer mixer;
    std::atomic<bool> done = false;
    std::thread device([&] {
        std::vector<std::int16_t> chunk(256);
        while (!done) mixer.fill(chunk);
    });
    const AudibleVoice file = music(two_tones()), samples = sound(two_tones(), 2);
    for (int i = 0; i < 2000; ++i) {
        std::vector<AudibleVoice> all;
        if (i % 3 != 0) all.push_back(file);
        if (i % 5 != 0) all.push_back(samples);
        if (i % 7 != 0) all.push_back({.id = 3 + std::uint64_t(i % 4), .duration = 0.3});
        for (AudibleVoice& heard : all) heard.time = (i % 100) * 0.02;
        mixer.set_voices(std::move(all));
    }
    done = true;
    device.join();
    CHECK(mixer.size() < 100);
}

TEST_CASE("a sound that loops has no gap where it begins again") {
    // A constant level: a gap would be a drop of it.
    const std::string hum = wave_file(0.1, 1, 8000, [](unsigned, double) { return 0.5; });
    for (AudibleVoice heard : {sound(hum), music(hum)}) {
        Mixer mixer;
        heard.loops = true;
        mixer.set_voices({heard});
        const Signal all = mixed(mixer, 0.5);
        const auto quietest = std::min_element(all.left.begin() + 1000, all.left.end());
        CHECK(*quietest > 0.45f);
    }
}

}  // namespace mixer_test
