#pragma once
// Where one thing is drawn in pictures between two steps.

#include <limits>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The values that place something.
struct Placement {
    Vec2 position{0, 0};
    double angle = 0;  ///< rad
    double scale = 1;
};

/// The placements of one thing that its pictures between two steps need.
class Track {
  public:
    /// To be called before each step and after it. `seen`: whether the thing is visible; what
    /// appears in a step is not drawn on its way to there.
    void step_begins(const Placement& now, bool seen = true) {
        earlier_ = before_;
        before_ = seen ? now : unknown();
    }
    void step_ended(const Placement& now) { after_ = now; }
    /// Until the next step, the thing is drawn where it is: it is new, or has another parent.
    void forget() { before_ = unknown(); }
    /// Where it is drawn. `now`: its present placement; a value that was written since the step is
    /// drawn as it is. `alpha`: position of the picture between the last two steps, 0 to 1.
    /// A jump is drawn at once: a move that is longer than `far` and does not continue an equally
    /// fast motion.
    Placement drawn(const Placement& now, double alpha, double far) const;
    /// Whether the position has not been written since the last step.
    bool is_left_at(const Vec2& position) const { return after_.position == position; }

  private:
    static Placement unknown() {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return {.position = {none, none}};
    }
    bool jumped(const Vec2& way, double far) const;

    Placement earlier_ = unknown();  // before the step before the last one
    Placement before_ = unknown(), after_ = unknown();
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
