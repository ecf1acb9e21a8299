#include <observed/drawn_past.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fettle/property/drawing.h>

namespace fettle::console {

using property::Handle;
using property::Transform;
using property::Vec2;

namespace {

Transform back_of(const Pose& pose) {
    Transform back = Transform::turned(-pose.angle);
    back.origin = -back.direction(pose.position);
    return back;
}

/// Neither numbers of pixels nor places differ by more than can be seen.
struct Likeness {
    double apart;
    bool points(const Vec2& a, const Vec2& b) const {
        return std::abs(a.x - b.x) <= apart && std::abs(a.y - b.y) <= apart;
    }
    bool maps(const Transform& a, const Transform& b) const {
        return points(a.x, b.x) && points(a.y, b.y) && points(a.origin, b.origin);
    }
    static bool colors(const property::Color& a, const property::Color& b) {
        return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
    }
    bool figures(const Figure& a, const Figure& b) const {
        const auto same_points = [this](const Vec2& p, const Vec2& q) { return points(p, q); };
        return a.kind == b.kind && a.smooth == b.smooth && a.blend == b.blend &&
               a.opacity == b.opacity && a.picture == b.picture && maps(a.map, b.map) &&
               std::abs(a.rounding - b.rounding) <= apart && colors(a.paint.fill, b.paint.fill) &&
               colors(a.paint.border, b.paint.border) &&
               a.paint.border_width == b.paint.border_width && a.area.left == b.area.left &&
               a.area.top == b.area.top && a.area.width == b.area.width &&
               a.area.height == b.area.height &&
               std::ranges::equal(a.points, b.points, same_points);
    }
    bool drawings(const DrawnPast::Drawing& a, const DrawnPast::Drawing& b) const {
        return std::ranges::equal(
            a, b, [this](const Figure& p, const Figure& q) { return figures(p, q); });
    }
};

}  // namespace

/// Keeps figures instead of drawing them. Hidden shapes are among them.
class NotingPainter : public property::Painter, public property::Drawer {
  public:
    NotingPainter(DrawnPast& past, const property::Tree& tree, const std::vector<Pose>& poses,
                  const property::Seen& seen)
        : past_(past), tree_(tree), poses_(poses), seen_(seen) {
        for (std::size_t i = 0; i < poses.size(); ++i)
            numbers_[poses[i].instance.key()] = static_cast<std::uint32_t>(i);
    }

    std::vector<DrawnPast::Item> take() {
        finish();
        return std::move(items_);
    }

    bool draws(const property::Class&) override { return false; }
    void draw(Handle, property::Painter&) override {}
    bool begins(Handle instance) override {
        finish();
        if (on_screen()) return false;
        Handle placed;  // the outermost instance with a position around it
        for (Handle at = instance; at; at = tree_.parent(at))
            if (has_position(tree_, at)) placed = at;
        pose_ = DrawnPast::nowhere;
        back_ = {};
        if (placed) {
            const auto number = numbers_.find(placed.key());
            if (number == numbers_.end()) return false;
            pose_ = number->second;
            back_ = back_of(poses_[pose_]);
        }
        instance_ = instance;
        return true;
    }

    property::Seen seen() const override { return seen_; }
    double pixels_per_unit() const override {
        const double wide = seen_.upper.x - seen_.lower.x;
        return wide > 0 && seen_.screen.x > 0 ? seen_.screen.x / wide * transform().scale()
                                              : transform().scale();
    }
    void circle(const Vec2& center, double radius, const property::Paint& paint) override {
        // A circle that turns looks the same.
        const Transform to = map();
        const double across = to.x.x * to.y.x + to.x.y * to.y.y, even = to.x.length();
        constexpr double tiny = 1e-5;
        if (std::abs(across) > tiny * even * even || std::abs(to.y.length() - even) > tiny * even)
            return ellipse(center, {radius, radius}, 0, paint);
        add(Figure::Kind::round, paint).map =
            Transform::moved(to(center)) * Transform::scaled({radius * even, radius * even});
    }
    void ellipse(const Vec2& center, const Vec2& radii, double angle,
                 const property::Paint& paint) override {
        Figure& made = add(Figure::Kind::round, paint);
        made.map = map() * Transform::placed(center, angle) * Transform::scaled(radii);
    }
    void polygon(std::span<const Vec2> vertices, double rounding,
                 const property::Paint& paint) override {
        Figure& made = add(Figure::Kind::polygon, paint);
        const Transform to = map();
        for (const Vec2& each : vertices) made.points.push_back(to(each));
        if (to.area() < 0) std::ranges::reverse(made.points);
        made.rounding = rounding * to.scale();
    }
    void line(const Vec2& from, const Vec2& to, property::Color color, float width) override {
        Figure& made =
            add(Figure::Kind::line, {.fill = {0, 0, 0, 0}, .border = color, .border_width = width});
        made.points = {map()(from), map()(to)};
    }
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const Vec2& lower, const Vec2& upper, property::Color tint, bool smooth) override {
        auto kept = past_.keep(picture);
        if (kept == nullptr) {
            const std::array<Vec2, 4> corners{lower, Vec2(upper.x, lower.y), upper,
                                              Vec2(lower.x, upper.y)};
            return polygon(corners, 0, {.fill = {0, 0, 0, 0}, .border = {0, 0, 0, 0}});
        }
        Figure& made = add(Figure::Kind::picture, {.fill = tint, .border = {0, 0, 0, 0}});
        made.map = map() * Transform::moved(lower) * Transform::scaled(upper - lower);
        made.smooth = smooth;
        made.picture = std::move(kept);
        made.area = area;
    }
    void point(const Vec2&, property::Color, float) override {}
    void text(const Vec2&, std::string_view, double, property::Color,
              property::TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(property::Overlay overlay) const override {
        return overlay == property::Overlay::shapes;
    }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }

  private:
    Transform map() const { return back_ * transform(); }
    Figure& add(Figure::Kind kind, const property::Paint& paint) {
        Figure& made = figures_.emplace_back();
        made.kind = kind;
        made.paint = paint;
        made.opacity = state().opacity;
        made.blend = state().blend;
        return made;
    }
    /// Ends the drawing of an instance.
    void finish() {
        if (figures_.empty()) return;
        const std::size_t time = times_[instance_.key()]++;
        const std::uint32_t drawing =
            past_.keep(instance_.key(), time, std::exchange(figures_, {}));
        items_.push_back({pose_, drawing});
    }

    DrawnPast& past_;
    const property::Tree& tree_;
    const std::vector<Pose>& poses_;
    property::Seen seen_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;  // of poses
    std::unordered_map<std::uint64_t, std::size_t> times_;      // that an instance was drawn
    Handle instance_;                                           // that draws now
    std::uint32_t pose_ = DrawnPast::nowhere;
    Transform back_{};  // into the coordinates of its pose
    DrawnPast::Drawing figures_;
    std::vector<DrawnPast::Item> items_;
};

DrawnPast::Items DrawnPast::note(const property::Tree& tree, const std::vector<Pose>& poses,
                                 const property::Seen& seen) {
    NotingPainter painter(*this, tree, poses, seen);
    constexpr double least = 0.02;  // px
    apart_ = least / painter.pixels_per_unit();
    const property::DrawingPart part(property::DrawingPart::Part::instances);
    tree.draw(tree.root(), painter, 1, &painter);
    std::vector<Item> items = painter.take();
    if (items_ == nullptr || *items_ != items)
        items_ = std::make_shared<const std::vector<Item>>(std::move(items));
    return items_;
}

std::uint32_t DrawnPast::keep(std::uint64_t instance, std::size_t time, Drawing drawing) {
    std::vector<std::uint32_t>& last = last_[instance];
    if (time < last.size() && (full() || Likeness{apart_}.drawings(drawings_[last[time]], drawing)))
        return last[time];
    if (full()) return 0;
    figures_ += drawing.size();
    drawings_.push_back(std::move(drawing));
    const auto number = static_cast<std::uint32_t>(drawings_.size() - 1);
    if (time < last.size())
        last[time] = number;
    else
        last.push_back(number);
    return number;
}

/// The game may change or drop its picture, so this is a copy; null if there are too many.
std::shared_ptr<const property::Picture> DrawnPast::keep(const property::Picture& picture) {
    const auto known = pictures_.find(picture.version());
    if (known != pictures_.end()) return known->second;
    if (bytes_ + picture.rgba().size() > most_bytes) return nullptr;
    bytes_ += picture.rgba().size();
    auto copy =
        std::make_shared<property::Picture>(picture.width(), picture.height(), picture.rgba());
    if (picture.on_pixels()) copy->keep_on_pixels();
    pictures_.emplace(picture.version(), copy);
    return copy;
}

bool DrawnPast::same(const Item& a, const Item& b) const {
    return a.drawing == b.drawing || Likeness{apart_}.drawings(drawing(a), drawing(b));
}

void draw_figures(property::Painter& painter, const DrawnPast::Drawing& figures, bool hidden_too) {
    for (const Figure& each : figures) {
        if (each.hidden() && !hidden_too) continue;
        painter.push(each.map);
        painter.fade(each.opacity);
        painter.blend(each.blend);
        switch (each.kind) {
            case Figure::Kind::round:
                painter.circle({0, 0}, 1, each.paint);
                break;
            case Figure::Kind::polygon:
                painter.polygon(each.points, each.rounding, each.paint);
                break;
            case Figure::Kind::line:
                painter.line(each.points[0], each.points[1], each.paint.border,
                             each.paint.border_width);
                break;
            case Figure::Kind::picture:
                painter.picture(*each.picture, each.area, {0, 0}, {1, 1}, each.paint.fill,
                                each.smooth);
                break;
        }
        painter.pop();
    }
}

}  // namespace fettle::console
