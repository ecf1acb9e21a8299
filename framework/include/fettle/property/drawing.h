#pragma once
// Which moment the picture shows that is being drawn.

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// A picture is being drawn on this thread while it lives.
class Drawing {
  public:
    /// `alpha`: how far the moment is between the last two steps, 0 to 1.
    explicit Drawing(double alpha);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// Of the picture that is being drawn; 1, the last step, while none is. So what scripts compute
    /// with it outside of `draw` depends on no frame.
    static double alpha();

  private:
    double before_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
