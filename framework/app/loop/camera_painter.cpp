#include <loop/camera_painter.h>

namespace fettle::app {

using property::Color;
using property::Transform;
using property::Vec2;

namespace {

/// The transform that maps points as the function `map` does. It is computed from the points around
/// `from`, whose numbers are the smallest, so that the least precision is lost.
template <class Map>
Transform transform_of(const Vec2& from, double unit, Map map) {
    const Vec2 to = map(from);
    Transform made;
    made.x = (map(from + Vec2(unit, 0)) - to) / unit;
    made.y = (map(from + Vec2(0, unit)) - to) / unit;
    made.origin = to - made.direction(from);
    return made;
}

}  // namespace

CameraPainter::CameraPainter(Painter& inner, const View& view, const CameraPicture& camera)
    : inner_(inner), camera_(true) {
    seen_ = {camera.view.center, camera.view.lower(), camera.view.upper(), camera.view.screen};
    // From pixels, because the viewport is upright on the screen however the view is turned.
    inner_.push(transform_of(0.5 * view.screen, view.screen.y,
                             [&](const Vec2& pixel) { return view.to_world(pixel); }));
    inner_.clip(camera.lower, camera.upper);
    inner_.push(transform_of(camera.view.center, camera.view.height, [&](const Vec2& point) {
        return camera.lower + camera.view.to_screen(point);
    }));
}

CameraPainter::~CameraPainter() {
    while (inner_.pushed() > pushed_before_) inner_.pop();
}

void CameraPainter::push(const Transform& transform) {
    Painter::push(transform);
    inner_.push(transform);
}

void CameraPainter::pop() {
    if (pushed() == 0) return;
    Painter::pop();
    inner_.pop();
}

void CameraPainter::fade(float opacity) {
    Painter::fade(opacity);
    inner_.fade(opacity);
}

void CameraPainter::blend(property::Blend mode) {
    Painter::blend(mode);
    inner_.blend(mode);
}

void CameraPainter::clip(const Vec2& lower, const Vec2& upper) {
    inner_.clip(lower, upper);
}

void CameraPainter::begin_screen() {
    push_screen();
    inner_.begin_screen();
}

bool CameraPainter::sees(const Vec2& lower, const Vec2& upper) const {
    if (!draws()) return false;
    if (camera_ && transform().is_identity() &&
        (upper.x < seen_.lower.x || upper.y < seen_.lower.y || lower.x > seen_.upper.x ||
         lower.y > seen_.upper.y))
        return false;
    return inner_.sees(lower, upper);
}

void CameraPainter::picture(const property::Picture& picture, const property::PictureArea& area,
                            const Vec2& lower, const Vec2& upper, Color tint, bool smooth) {
    if (draws()) inner_.picture(picture, area, lower, upper, tint, smooth);
}

void CameraPainter::circle(const Vec2& center, double radius, const property::Paint& paint) {
    if (draws()) inner_.circle(center, radius, paint);
}

void CameraPainter::ellipse(const Vec2& center, const Vec2& radii, double angle,
                            const property::Paint& paint) {
    if (draws()) inner_.ellipse(center, radii, angle, paint);
}

void CameraPainter::polygon(std::span<const Vec2> vertices, double rounding,
                            const property::Paint& paint) {
    if (draws()) inner_.polygon(vertices, rounding, paint);
}

void CameraPainter::line(const Vec2& from, const Vec2& to, Color color, float width) {
    if (draws()) inner_.line(from, to, color, width);
}

void CameraPainter::point(const Vec2& position, Color color, float size) {
    if (draws()) inner_.point(position, color, size);
}

void CameraPainter::text(const Vec2& position, std::string_view text, double height, Color color,
                         property::TextAlign align) {
    if (draws()) inner_.text(position, text, height, color, align);
}

}  // namespace fettle::app
