#pragma once
// What instances drew at moments of the past: figures relative to the places of those instances. A
// drawing that is the same at many moments is kept once.

#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::console {

/// Whether the instance has a position of its own.
bool has_position(const property::Tree& tree, property::Handle instance);

/// Where an instance was.
struct Pose {
    property::Handle instance;
    property::Vec2 position{0, 0};  // m
    double angle = 0;               // rad
    property::Transform map() const { return property::Transform::placed(position, angle); }
};

/// A circle, a polygon, a line or a picture.
struct Figure {
    enum class Kind : std::uint8_t { round, polygon, line, picture };
    Kind kind = Kind::round;
    bool smooth = false;        // of a picture
    property::Transform map{};  // of the unit circle, or of the box from (0, 0) to (1, 1)
    std::vector<property::Vec2> points{};  // of a polygon or a line
    double rounding = 0;                   // m
    property::Paint paint{};               // a picture has its tint as the fill
    float opacity = 1;
    property::Blend blend = property::Blend::normal;
    std::shared_ptr<const property::Picture> picture{};
    property::PictureArea area{};

    /// A figure that is hidden is drawn by painters of outlines only.
    bool hidden() const { return paint.fill.a <= 0 && paint.border.a <= 0; }
};

class DrawnPast {
  public:
    static constexpr std::uint32_t nowhere = 0xffffffff;
    /// What one instance drew.
    struct Item {
        std::uint32_t pose = nowhere;  // index of the pose around it
        std::uint32_t drawing = 0;
        friend bool operator==(const Item&, const Item&) = default;
    };
    using Items = std::shared_ptr<const std::vector<Item>>;  // in the order of drawing
    using Drawing = std::vector<Figure>;

    /// What the instances of the tree draw now, but not what is on the screen. `poses`: of the
    /// topmost instances with a position. After `most_figures`, each instance keeps the last
    /// drawing that it has. After `most_bytes` of pictures, others are hidden boxes.
    Items note(const property::Tree& tree, const std::vector<Pose>& poses,
               const property::Seen& seen);
    const Drawing& drawing(const Item& item) const { return drawings_[item.drawing]; }
    /// Whether it looks the same as far as can be seen.
    bool same(const Item& a, const Item& b) const;
    /// Whether `most_figures` was reached.
    bool full() const { return figures_ >= most_figures; }

    static inline std::size_t most_figures = 300'000;
    static constexpr std::size_t most_bytes = 256u << 20;

  private:
    friend class NotingPainter;
    std::uint32_t keep(std::uint64_t instance, std::size_t time, Drawing drawing);
    std::shared_ptr<const property::Picture> keep(const property::Picture& picture);

    std::vector<Drawing> drawings_{1};  // the first one is empty
    std::size_t figures_ = 0, bytes_ = 0;
    double apart_ = 0;  // m; nearer points look the same
    // The last drawing of each instance, for each time that it is drawn for one picture.
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> last_;
    std::map<std::uint64_t, std::shared_ptr<const property::Picture>> pictures_;  // by version
    Items items_;  // of the last moment
};

/// Draws figures with a painter. Their places are relative to its transform.
void draw_figures(property::Painter& painter, const DrawnPast::Drawing& figures, bool hidden_too);

}  // namespace fettle::console
