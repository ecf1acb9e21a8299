#pragma once
// A painter that draws a part of what another one draws: only the world, only the instances on the
// screen, or the world as a camera sees it.

#include <fettle/app/view.h>
#include <fettle/property/painter.h>

namespace fettle::app {

/// The view of a camera, and its place on the screen.
struct CameraPicture {
    View view{};                              // its screen is the part below
    property::Vec2 lower{0, 0}, upper{0, 0};  // px, from the top left corner
};

class CameraPainter : public property::Painter {
  public:
    enum class Part : std::uint8_t { world, screen };
    /// Draws `part` as `inner` would.
    CameraPainter(property::Painter& inner, Part part) : inner_(inner), part_(part) {}
    /// Draws the world as the camera sees it. `view`: the view of `inner`.
    CameraPainter(property::Painter& inner, const View& view, const CameraPicture& camera);
    ~CameraPainter() override;
    CameraPainter(const CameraPainter&) = delete;

    void push(const property::Transform& transform) override;
    void pop() override;
    void fade(float opacity) override;
    void blend(property::Blend mode) override;
    void clip(const property::Vec2& lower, const property::Vec2& upper) override;
    void gradient(const property::Gradient& gradient) override { inner_.gradient(gradient); }
    property::Seen seen() const override { return camera_ ? seen_ : inner_.seen(); }
    double pixels_per_unit() const override { return inner_.pixels_per_unit(); }
    double label_scale() const override { return inner_.label_scale(); }
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const property::Vec2& lower, const property::Vec2& upper, property::Color tint,
                 bool smooth) override;
    void circle(const property::Vec2& center, double radius, const property::Paint& paint) override;
    void ellipse(const property::Vec2& center, const property::Vec2& radii, double angle,
                 const property::Paint& paint) override;
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& paint) override;
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override;
    void point(const property::Vec2& position, property::Color color, float size) override;
    void text(const property::Vec2& position, std::string_view text, double height,
              property::Color color, property::TextAlign align) override;
    void part_of(std::uint64_t whole) override { inner_.part_of(whole); }
    bool shows(property::Overlay overlay) const override { return inner_.shows(overlay); }
    bool sees(const property::Vec2& lower, const property::Vec2& upper) const override;
    void begin_screen() override;
    void end_screen() override { pop(); }

  private:
    bool draws() const { return on_screen() == (part_ == Part::screen); }

    property::Painter& inner_;
    Part part_ = Part::world;
    bool camera_ = false;
    property::Seen seen_{};
    std::size_t pushed_before_ = inner_.pushed();
};

}  // namespace fettle::app
