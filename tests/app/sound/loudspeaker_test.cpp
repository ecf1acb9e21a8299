// The output of the sound device. OpenAL Soft, on which SFML 2 plays, writes it to a file here, so
// no device is needed.

#include <catch.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

#include <fettle/app/loudspeaker.h>

#include <sfml/sfml_audio.h>

#include "game.h"
#include "sound_measures.h"
#include "temporary_folder.h"

namespace loudspeaker_test {

using namespace fettle::app;
using sound_measures::Signal;

namespace {

/// Reads a WAV file of two channels with 16 bits.
Signal read(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    Signal all;
    const std::size_t data = bytes.find("data");
    if (data == std::string::npos) return all;
    for (std::size_t i = data + 8; i + 4 <= bytes.size(); i += 4) {
        std::int16_t pair[2];
        std::memcpy(pair, bytes.data() + i, sizeof pair);
        all.left.push_back(static_cast<float>(pair[0]) / 32768.0f);
        all.right.push_back(static_cast<float>(pair[1]) / 32768.0f);
    }
    return all;
}

/// Lets real time pass for the game and the device.
void pass(Game& game, Loudspeaker& loudspeaker, double seconds) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    for (Clock::time_point last = begin; last - begin < std::chrono::duration<double>(seconds);) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        const Clock::time_point now = Clock::now();
        game.loop.frame(std::chrono::duration<double>(now - last).count());
        loudspeaker.follow(game.services, game.loop.halted());
        last = now;
    }
}

/// Plays a sound for 0.4 s, then the same muted; returns what the device wrote to the file.
Signal played(const std::filesystem::path& written) {
    std::filesystem::remove(written);
    Game game(R"(
        time.max_steps = 1000
        left = Synth { wave = "sine", frequency = 500, sustain = 0.4, decay = 0, volume = 0.5,
                       position = vec(-20, 0), range = 40 }
    )");
    {
        Loudspeaker loudspeaker;
        loudspeaker.follow(game.services, false);
        CHECK_FALSE(std::filesystem::exists(written));  // nothing has sounded yet
        game.runtime.run("left:play()", "test");
        pass(game, loudspeaker, 1.2);
        CHECK(loudspeaker.consume_problem().empty());
        game.runtime.run("audio.muted = true left:play()", "test");
        pass(game, loudspeaker, 0.3);
    }
    return read(written);
}

}  // namespace

TEST_CASE("the device plays what sounds in the game") {
    if (!fettle::app::sfml::plays_on_openal) return;
    const TemporaryFolder folder;
    const std::filesystem::path written = folder.path / "out.wav", settings = folder.path / "conf";
    std::ofstream(settings) << "[general]\nfrequency = 44100\nchannels = stereo\n"
                            << "sample-type = int16\ndrivers = wave\nhrtf = false\n"
                            << "[wave]\nfile = " << written.string() << "\n";
    // The library reads these once in a process, when the first device is opened.
    ::setenv("ALSOFT_DRIVERS", "wave", 1);
    ::setenv("ALSOFT_CONF", settings.c_str(), 1);
    // A machine that is busy breaks sounds off, so one of several attempts decides.
    Signal all, middle;
    for (int attempt = 0; attempt < 8; ++attempt) {
        all = played(written);
        const auto first = std::find_if(all.left.begin(), all.left.end(),
                                        [](float level) { return std::abs(level) > 0.01f; });
        const double from =
            static_cast<double>(first - all.left.begin()) / sound_measures::rate + 0.05;
        middle = all.part(from, from + 0.25);
        const double length = sound_measures::length(all.left);
        if (length > 0.35 && length < 0.7 &&
            sound_measures::frequency(middle.left) == Approx(500).margin(5))
            break;
    }
    CHECK(all.left.size() > 0.5 * sound_measures::rate);
    CHECK(sound_measures::length(all.left) > 0.35);
    CHECK(sound_measures::length(all.left) < 0.7);
    CHECK(sound_measures::frequency(middle.left) == Approx(500).margin(5));
    // A quarter for half of the range, and the right side is the far one.
    CHECK(sound_measures::level(middle.left) == Approx(0.25 * 0.5 / std::sqrt(2)).epsilon(0.15));
    CHECK(sound_measures::level(middle.right) < 0.8 * sound_measures::level(middle.left));
}

}  // namespace loudspeaker_test
