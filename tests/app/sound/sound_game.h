#pragma once
// A game with sounds, and without a device.

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/app/loop.h>
#include <fettle/property/storage/assets.h>
#include <fettle/property/storage/game_files.h>

#include <sound/audio_state.h>

#include "sound_measures.h"
#include "temporary_folder.h"

namespace sound_game {

using namespace fettle;
using namespace fettle::app;
using sound_measures::tone_file;

inline script::Options seeded() {
    script::Options options;
    options.seed = 3;
    return options;
}

struct SoundGame {
    TemporaryFolder folder;
    property::GameFiles files;
    property::Assets assets{files, folder.path};
    property::Tree tree;
    Services services{tree, &assets};
    script::Runtime runtime{tree, seeded()};
    Loop loop{tree, runtime, services};
    std::string printed, errors;

    SoundGame() {
        runtime.on_print([this](std::string_view text) {
            printed += (printed.empty() ? "" : " ") + std::string(text);
        });
        runtime.on_error([this](const script::ScriptError& error) { errors += error.message; });
        write("hit.wav", tone_file(440, 0.25));
        write("song.wav", tone_file(220, 2));
    }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder.path / name, std::ios::binary) << bytes;
    }
    void run(std::string_view chunk) { runtime.run(chunk, "test"); }
    void turns(int count) {
        for (int i = 0; i < count; ++i) loop.turn();
    }
    std::string print(const std::string& expression) {
        printed.clear();
        run("print(" + expression + ")");
        return printed;
    }
    std::string error(const std::string& chunk) {
        errors.clear();
        run(chunk);
        return errors;
    }
    std::vector<AudibleVoice> heard() { return services.audio.state().audible_voices(false); }
};

}  // namespace sound_game
