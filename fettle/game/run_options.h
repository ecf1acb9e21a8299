#pragma once
// The options of a run, from the command line or from a test.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <game/test_driver.h>

namespace fettle::program {

struct RunOptions {
    std::filesystem::path game{};  // empty: the gallery
    bool headless = false;
    std::optional<std::int64_t> steps{};
    std::vector<std::string> evals{};
    std::vector<std::pair<std::uint64_t, std::string>> at{};       // step, chunk
    std::vector<std::pair<std::uint64_t, std::string>> console{};  // step, command
    std::optional<std::uint64_t> budget{};  // ms; limit of each call into the scripts
    bool sandbox = false;                   // the game is not trusted
    std::optional<std::uint64_t> memory{};  // MB; limit of what the scripts may use
    std::optional<std::uint64_t> seed{};    // of random(); none: that of game.json, else 0
    bool listen = false;                    // terminals may attach from the beginning
    bool developer = false;  // has the console also if the game has it for developers only
    std::vector<std::string> modules{};  // files or names, in addition to the game's manifest
    std::filesystem::path screenshot{};
    bool hash = false;
    std::filesystem::path record{};    // recording to write; empty: none
    std::filesystem::path replay{};    // recording to play instead of a new run; empty: none
    std::optional<bool> reload{};      // given on the command line
    bool follow = false;               // read files again that change while the game runs
    bool isolated = false;             // reads and writes no store, no saves and no tweaks
    std::optional<TestChoice> test{};  // the run is this test
};

}  // namespace fettle::program
