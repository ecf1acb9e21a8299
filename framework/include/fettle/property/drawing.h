#pragma once
// The moment of the picture that is being drawn.

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

    /// Of the current picture; 1, the last step, outside of drawing. So the results of scripts
    /// outside of `draw` do not depend on frames.
    static double alpha();

  private:
    double before_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
