#include <fettle/physics_c/drawing.h>

#include <calls/calls.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

/// Draws with the functions of a caller. Null functions draw nothing.
class Pen : public DebugDraw {
  public:
    explicit Pen(const fettle_debug_draw& draw) : draw_(draw) {}

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

  private:
    const fettle_debug_draw& draw_;
    std::vector<fettle_position> placed_;
};

DebugDrawOptions options_of(const fettle_debug_draw& draw) {
    DebugDrawOptions options;
    options.shapes = flag(draw.shapes);
    options.joints = flag(draw.joints);
    options.contacts = flag(draw.contacts);
    options.boxes = flag(draw.boxes);
    options.centers = flag(draw.centers);
    options.fraction = draw.fraction;
    if (flag(draw.has_region)) options.region = box_of(draw.region);
    return options;
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_debug_draw_init(fettle_debug_draw* draw, size_t size) {
    fettle_debug_draw defaults{};
    defaults.shapes = true;
    defaults.joints = true;
    defaults.fraction = 1.0f;
    return init(__func__, draw, size, defaults);
}

fettle_code fettle_world_draw(fettle_world* world, const fettle_debug_draw* draw) {
    return guarded(__func__, [&] {
        const fettle::physics::World& drawn = live(world);
        const fettle_debug_draw& how = needed("draw", draw);
        check_size(how.size, sizeof how);
        const Visiting visiting(*world);
        Pen pen(how);
        drawn.draw(pen, options_of(how));
    });
}
