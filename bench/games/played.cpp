#include "games/played.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "measure/timing.h"

namespace fettle::bench {

namespace fs = std::filesystem;

TemporaryGame::TemporaryGame() {
    std::string name = (fs::temp_directory_path() / "fettle-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error(name + ": the folder cannot be made");
    folder_ = name;
}

TemporaryGame::~TemporaryGame() {
    std::error_code error;
    fs::remove_all(folder_, error);
}

void TemporaryGame::write(const std::string& name, const std::string& content) const {
    // A new file takes the place of the old one, as when an editor saves.
    const fs::path beside = folder_ / (name + ".new");
    std::ofstream(beside, std::ios::binary) << content;
    fs::rename(beside, folder_ / name);
}

namespace {

program::RunOptions options_of(const fs::path& game, bool follow) {
    program::RunOptions options;
    options.game = game;
    options.headless = true;
    options.follow = follow;
    options.isolated = !follow;  // an isolated run follows no files
    return options;
}

}  // namespace

Played::Played(const fs::path& game, bool follow)
    : options_(options_of(game, follow)),
      session_(options_, nullptr,
               [this](const script::ScriptError& error) { error_ = error.message; }) {
    session_.on_output([](std::string_view) {});
    session_.start();
    require_no_error();
}

void Played::require_no_error() const {
    if (!error_.empty()) throw std::runtime_error("the game to be measured failed: " + error_);
}

void Played::run(const std::string& code) {
    session_.runtime().run(code, "bench");
    require_no_error();
}

double Played::step_ms(int warm_up, int steps) {
    for (int i = 0; i < warm_up; ++i) session_.loop().turn();
    std::vector<double> all;
    for (int i = 0; i < steps; ++i) {
        const ThreadClock clock;
        session_.loop().turn();
        all.push_back(clock.elapsed_ms());
    }
    require_no_error();
    return median(std::move(all));
}

double Played::frame_ms(app::Screen& screen, int frames) {
    constexpr int warm_up = 5;
    std::vector<double> all;
    for (int i = 0; i < warm_up + frames; ++i) {
        session_.loop().turn();
        const ThreadClock clock;
        session_.loop().draw(screen, 1.0 / 60);
        screen.present();
        if (i >= warm_up) all.push_back(clock.elapsed_ms());
    }
    require_no_error();
    return median(std::move(all));
}

}  // namespace fettle::bench
