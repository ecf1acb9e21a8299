#include "play.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "games/undrawn_screen.h"

namespace fettle::pictures {

namespace {

program::RunOptions options_for(const std::filesystem::path& game, const std::string& prepare) {
    program::RunOptions options;
    options.game = game;
    options.headless = true;  // commands that were typed in other runs are not read
    options.isolated = true;
    options.at = {{2, prepare}};
    return options;
}

}  // namespace

bool is_picture(const std::filesystem::path& frames) {
    return frames.extension() == ".png";
}

namespace {

std::unique_ptr<app::Screen> screen_for(const std::filesystem::path& frames, unsigned width,
                                        unsigned height) {
    if (frames.empty()) return std::make_unique<bench::UndrawnScreen>(width, height);
    return app::make_picture(width, height);
}

}  // namespace

Play::Play(const std::filesystem::path& game, const std::string& prepare, unsigned width,
           unsigned height, std::filesystem::path frames)
    : options_(options_for(game, prepare)),
      session_(options_, nullptr,
               [this](const script::ScriptError& error) { error_ = error.message; }),
      screen_(screen_for(frames, width, height)),
      folder_(std::move(frames)),
      x_(static_cast<float>(width) / 2),
      y_(static_cast<float>(height) / 2) {
    if (is_picture(folder_)) folder_.clear();
    if (!folder_.empty()) std::filesystem::create_directories(folder_);
    session_.on_output([](std::string_view) {});
    session_.set_screen({static_cast<double>(width), static_cast<double>(height)});
    session_.start();
}

void Play::frame() {
    constexpr int steps = 60 / rate;
    for (int i = 0; i < steps; ++i) session_.loop().frame(1.0 / 60);
    if (!error_.empty()) throw std::runtime_error(error_);
    screen_->keep_frame();
    session_.loop().draw(*screen_, 1.0 / rate);
    draw_pointer();
    screen_->present();
    std::string number = std::to_string(frame_++);
    if (folder_.empty()) return;
    number.insert(0, 4 - number.size(), '0');
    screen_->save(folder_ / (number + ".png"));
}

void Play::wait(double seconds) {
    for (int i = 0; i < std::lround(seconds * rate); ++i) frame();
}

void Play::send(app::EventKind kind, const std::string& name, char32_t character) {
    app::InputEvent event;
    event.kind = kind;
    event.name = name;
    event.character = character;
    event.x = x_;
    event.y = y_;
    session_.loop().handle(event);
}

/// Slow at both ends, as a hand moves.
void Play::move(float x, float y, double seconds) {
    const float from_x = x_, from_y = y_;
    const long frames = std::max(1L, std::lround(seconds * rate));
    for (long i = 1; i <= frames; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(frames);
        const float share = t * t * (3 - 2 * t);
        x_ = from_x + (x - from_x) * share;
        y_ = from_y + (y - from_y) * share;
        send(app::EventKind::mouse_moved);
        frame();
    }
}

void Play::press() {
    pressed_ = true;
    send(app::EventKind::mouse_pressed, "left");
    frame();
}

void Play::release() {
    pressed_ = false;
    send(app::EventKind::mouse_released, "left");
    frame();
}

void Play::click(float x, float y, double seconds) {
    move(x, y, seconds);
    press();
    release();
}

void Play::key(const std::string& name) {
    send(app::EventKind::key_pressed, name);
    send(app::EventKind::key_released, name);
    frame();
}

void Play::type(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string name(1, static_cast<char>(std::tolower(text[i])));
        send(app::EventKind::key_pressed, name);
        send(app::EventKind::text, {}, static_cast<char32_t>(text[i]));
        send(app::EventKind::key_released, name);
        if (i % 2 == 1 || i + 1 == text.size()) frame();
    }
}

void Play::expect(const std::string& expression) {
    const std::string chunk = "assert(" + expression + ", \"expected: this is true\")";
    if (!session_.runtime().run(chunk, "session")) throw std::runtime_error(error_);
}

/// An arrow: a dark one, and a smaller bright one over it.
void Play::draw_pointer() {
    struct Corner {
        float x, y;
    };
    constexpr std::array<Corner, 4> arrow = {{{0, 0}, {0, 17}, {5, 12.5f}, {12, 12}}};
    app::Surface& surface = screen_->surface();
    const app::ClipRectangle all{0, 0, surface.width(), surface.height()};
    const auto draw = [&](float scale, float shift, std::uint8_t red, std::uint8_t green,
                          std::uint8_t blue) {
        std::array<app::SurfaceVertex, 4> vertices{};
        for (std::size_t i = 0; i < arrow.size(); ++i)
            vertices[i] = {.x = x_ + shift + arrow[i].x * scale,
                           .y = y_ + 2 * shift + arrow[i].y * scale,
                           .u = 0,
                           .v = 0,
                           .r = red,
                           .g = green,
                           .b = blue,
                           .a = 255};
        constexpr std::array<std::uint16_t, 6> indices = {0, 1, 2, 0, 2, 3};
        surface.triangles(vertices, indices, 0, all);
    };
    draw(1.25f, 0, 20, 20, 20);
    if (pressed_)
        draw(1, 1.2f, 255, 190, 80);
    else
        draw(1, 1.2f, 255, 255, 255);
}

}  // namespace fettle::pictures
