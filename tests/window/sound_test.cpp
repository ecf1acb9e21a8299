// Sound of a game in a window, without a sound card.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "catch.h"
#include "game_window.h"
#include "temporary_folder.h"

namespace sound_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;

namespace {

/// Two notes, and a word when each is over.
constexpr const char* script = R"(
    local blip = Synth { wave = "sine", frequency = 600, sustain = 0.3, decay = 0 }
    blip:on("finished", function() print("over") end)
    function key_pressed() blip:play() end
    function start() print("ready") end
)";

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

/// The settings of OpenAL Soft, which SFML 2 uses.
class Settings {
  public:
    explicit Settings(const std::string& drivers) {
        std::ofstream(folder_.path / "conf")
            << "[general]\nfrequency = 44100\nchannels = stereo\nsample-type = int16\n"
            << "[wave]\nfile = " << written().string() << "\n";
        ::setenv("ALSOFT_DRIVERS", drivers.c_str(), 1);
        ::setenv("ALSOFT_CONF", (folder_.path / "conf").c_str(), 1);
    }
    ~Settings() {
        ::unsetenv("ALSOFT_DRIVERS");
        ::unsetenv("ALSOFT_CONF");
    }
    std::filesystem::path written() const { return folder_.path / "out.wav"; }

  private:
    TemporaryFolder folder_;
};

std::string played(const Settings& settings) {
    const TemporaryFolder game;
    std::ofstream(game.path / "main.lua") << script;
    GameWindow window(game.path);
    REQUIRE(window.prints("ready"));
    CHECK_FALSE(std::filesystem::exists(settings.written()));
    window.key("a");
    const auto overs = [&](std::size_t n) {
        return window.eventually([&] { return count(window.printed(), "over") >= n; });
    };
    CHECK(overs(1));
    window.key("b");
    CHECK(overs(2));
    CHECK(window.asked_to_end() >= 0);
    return window.printed();
}

bool skipped() {
    const std::string missing = missing_tools();
    if (!missing.empty()) std::cout << "SKIPPED: " << missing << " not found\n";
    return !missing.empty();
}

}  // namespace

TEST_CASE("a game without a sound device says so once and its voices end") {
    if (skipped()) return;
    const std::string printed = played(Settings("none of them"));
    INFO(printed);
    CHECK(count(printed, "there is no sound device") == 1);
    CHECK(count(printed, "ALSA") + count(printed, "AL lib") == 0);
}

TEST_CASE("a game in a window is heard") {
    if (skipped()) return;
    if (std::string(FETTLE_SFML) == "3") {
        std::cout << "SKIPPED: SFML 3 plays without OpenAL, whose writer of files listens here\n";
        return;
    }
    const Settings settings("wave");
    const std::string printed = played(settings);
    INFO(printed);
    CHECK(count(printed, "there is no sound device") == 0);
    std::ifstream file(settings.written(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    REQUIRE(bytes.size() > 44100);
    // Both notes: 0.6 s of samples that are not silent.
    std::size_t loud = 0;
    for (std::size_t i = 100; i + 4 <= bytes.size(); i += 4)
        loud += std::abs(static_cast<signed char>(bytes[i + 1])) > 8 ? 1 : 0;
    CHECK(loud > 0.3 * 44100);
}

}  // namespace sound_test
