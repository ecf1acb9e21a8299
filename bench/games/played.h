#pragma once
// A game in a temporary folder, played headless by the code of `fettle run`.

#include <filesystem>
#include <memory>
#include <string>

#include <fettle/app/screen.h>
#include <game/run_options.h>
#include <session/session.h>

namespace fettle::bench {

class TemporaryGame {
  public:
    TemporaryGame();
    ~TemporaryGame();
    TemporaryGame(const TemporaryGame&) = delete;
    void write(const std::string& name, const std::string& content) const;
    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

class Played {
  public:
    /// `follow`: the files are read again when they change. Throws std::runtime_error if the game
    /// has an error.
    explicit Played(const std::filesystem::path& game, bool follow = false);
    program::Session& session() { return session_; }
    /// Runs code in the game. Throws std::runtime_error if it has an error.
    void run(const std::string& code);
    /// Median processor time of a step after `warm_up` steps, ms.
    double step_ms(int warm_up, int steps);
    /// Median processor time to draw a frame, ms.
    double frame_ms(app::Screen& screen, int frames);

  private:
    void require_no_error() const;

    std::string error_;
    program::RunOptions options_;
    program::Session session_;
};

}  // namespace fettle::bench
