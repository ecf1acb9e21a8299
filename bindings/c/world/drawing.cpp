#include <fettle/physics_c/drawing.h>

#include <calls/members.h>

namespace fettle::physics_c {

using namespace physics;

/// All members but the functions.
template <class InC, class Each>
void each_member(InC& c, DebugDrawOptions& options, const Each& each) {
    each(c.shapes, options.shapes);
    each(c.joints, options.joints);
    each(c.contacts, options.contacts);
    each(c.boxes, options.boxes);
    each(c.centers, options.centers);
    each(c.fraction, options.fraction);
    each(c.has_region, c.region, options.region);
}

namespace {

/// Draws with the functions of a caller. Null functions draw nothing.
class HostDraw : public DebugDraw {
  public:
    HostDraw(const fettle_world* world, const fettle_debug_draw& draw)
        : world_(world), draw_(draw) {}

    void polygon(std::span<const Position> points, bool closed, uint32_t color) override {
        if (draw_.polygon == nullptr) return;
        placed_.clear();
        for (const Position& p : points) placed_.push_back(converted(p));
        draw_.polygon(draw_.user, placed_.data(), uint32_t(placed_.size()), closed, color);
    }
    void circle(const Position& center, float radius, float angle, uint32_t color) override {
        if (draw_.circle != nullptr)
            draw_.circle(draw_.user, converted(center), radius, angle, color);
    }
    void segment(const Position& from, const Position& to, uint32_t color) override {
        if (draw_.segment != nullptr)
            draw_.segment(draw_.user, converted(from), converted(to), color);
    }
    void point(const Position& at, uint32_t color) override {
        if (draw_.point != nullptr) draw_.point(draw_.user, converted(at), color);
    }

    uint32_t color_of(const Body& body, const Shape& shape) const override {
        if (draw_.color_of == nullptr) return DebugDraw::color_of(body, shape);
        return draw_.color_of(draw_.user, world_, converted(body), converted(shape));
    }

  private:
    const fettle_world* world_;
    const fettle_debug_draw& draw_;
    std::vector<fettle_position> placed_;
};

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_debug_draw_init(fettle_debug_draw* draw, size_t size) {
    return init_as<fettle::physics::DebugDrawOptions>(__func__, draw, size);
}

fettle_code fettle_world_draw(fettle_world* world, const fettle_debug_draw* draw) {
    return guarded(__func__, [&] {
        const fettle::physics::World& drawn = live(world);
        const fettle_debug_draw& how = needed("draw", draw);
        const auto options = from_c<fettle::physics::DebugDrawOptions>(how);
        const Visiting visiting(*world);
        HostDraw pen(world, how);
        drawn.draw(pen, options);
    });
}
