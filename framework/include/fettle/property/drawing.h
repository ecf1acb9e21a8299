#pragma once
// The moment between two steps that is being drawn.

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// While it lives, this thread draws a picture.
class Drawing {
  public:
    /// `alpha`: position of the moment between the last two steps, 0 to 1.
    explicit Drawing(double alpha);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// The value for the current picture. Outside of drawing it is 1, the last step, so that the
    /// results of scripts outside of `draw` do not depend on frames.
    static double alpha();

  private:
    double before_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
