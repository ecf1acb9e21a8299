#pragma once
// A game that is played with a pointer and keys, as a person plays it, and whose frames are written
// as files. Nothing depends on the clock: two runs write the same frames.

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fettle/app/screen.h>

#include <session/session.h>

namespace fettle::pictures {

/// Frames a second of the moving picture.
constexpr int rate = 20;

/// Whether only the last frame is kept, in this file, not all of them in a folder.
bool is_picture(const std::filesystem::path& frames);

class Play {
  public:
    /// Runs a game in a picture of this size; `prepare` is Lua that runs before its second step.
    /// Each frame becomes a file of the folder `frames`; none does if that is the name of a
    /// picture. If `frames` is empty, nothing is drawn.
    Play(const std::filesystem::path& game, const std::string& prepare, unsigned width,
         unsigned height, std::filesystem::path frames);

    /// The functions below throw std::runtime_error when the game raises an error.

    /// The game goes on, in real time of the picture.
    void wait(double seconds);
    /// The pointer moves there, in pixels from the upper left corner.
    void move(float x, float y, double seconds);
    void press();
    void release();
    void click(float x, float y, double seconds);
    /// Presses and releases a key.
    void key(const std::string& name);
    /// Types ASCII text, two characters a frame.
    void type(std::string_view text);

    /// Throws std::runtime_error unless the expression of Lua is true.
    void expect(const std::string& expression);
    int frames() const { return frame_; }
    /// The frame that was drawn last.
    void save(const std::filesystem::path& picture) { screen_->save(picture); }

  private:
    void frame();
    void send(app::EventKind kind, const std::string& name = {}, char32_t character = 0);
    void draw_pointer();

    std::string error_;  // of the game
    program::RunOptions options_;
    program::Session session_;
    std::unique_ptr<app::Screen> screen_;
    std::filesystem::path folder_;
    float x_, y_;
    bool pressed_ = false;
    int frame_ = 0;
};

}  // namespace fettle::pictures
