#pragma once
// The moment between two steps that is being drawn.

#include <cstdint>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Class;
class Painter;

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
    /// Whether this thread draws a picture now. Modules in files of their own cannot ask this.
    static bool underway();

  private:
    double before_;
    bool outer_;
};

/// While it lives, this thread draws only a part of each tree: the instances without the marks over
/// them (the overlays of a world), or the marks alone.
class DrawingPart {
  public:
    enum class Part : std::uint8_t { all, instances, marks };
    explicit DrawingPart(Part part);
    ~DrawingPart();
    DrawingPart(const DrawingPart&) = delete;
    DrawingPart& operator=(const DrawingPart&) = delete;

  private:
    Part before_;
};

/// Draws instances in addition to the draw functions of their classes: the functions `draw` of
/// scripts. An instance that both draw is drawn by its class first.
class Drawer {
  public:
    virtual ~Drawer() = default;
    virtual bool draws(const Class& of) = 0;
    /// Called before an instance is drawn, by its class or by `draw`. Returns false if it shall not
    /// be drawn.
    virtual bool begins(Handle instance) {
        (void)instance;
        return true;
    }
    virtual void draw(Handle instance, Painter& painter) = 0;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
