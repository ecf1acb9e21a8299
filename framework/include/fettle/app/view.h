#pragma once
// The view: the visible part of the world, and its scale. In the tree as `view`.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <fettle/app/export.h>
#include <fettle/app/window_state.h>
#include <fettle/property/between_steps.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// Overlays on the picture; `view.show`.
struct Show {
    bool aabbs = false;
    bool contacts = false;
    bool joints = false;
    bool centers = false;
    bool velocities = false;
    bool names = false;
    bool islands = false;
    bool impulses = false;
    bool limits = false;
    bool blame = false;
    bool wires = false;
    bool onion_skins = false;
    bool grid = false;
    bool timings = false;
    bool shapes = false;
    bool overlay(property::Overlay overlay) const;
};

/// How the picture fits into the window. `expand`: all of the window is used. `letterbox`: what is
/// seen has the proportions of the design size, with bars beside it. `pixel`: as letterbox, and
/// each pixel of the design is a whole number of pixels.
enum class Fit : std::uint8_t { expand, letterbox, pixel };

/// World units are meters with y up; screen units are pixels from the top left corner of the
/// picture with y down. The picture fills the window, without the bars of `fit`.
struct View {
    property::Vec2 center{0, 0};  // m, in the middle of the screen
    double height = 20;           // m, visible from bottom to top
    double angle = 0;             // rad, turn of the viewer, counter-clockwise
    property::Color background{0.105f, 0.122f, 0.153f, 1};
    property::Vec2 screen{1280, 800};  // px, size of the window
    WindowState window{};
    Show show{};

    // The followed instance. docs/design/app.md describes how it is followed.
    property::Handle follow{};
    double follow_damping = 0;             // s
    property::Vec2 dead_zone{0, 0};        // m
    std::vector<property::Vec2> limits{};  // lower and upper corner; empty: none
    double shake_amount = 0;               // m
    double shake_length = 0;               // s
    double shake_left = 0;                 // s
    /// One step of the simulation: follows, keeps to the limits.
    void advance(const property::Tree& tree, double dt);
    /// To be called at the beginning and at the end of each step, for pictures between two steps.
    void note_step_begins() { track.step_begins(placement()); }
    void note_step_ended() { track.step_ended(placement()); }
    /// The view as it is drawn between the last two steps.
    View drawn(const property::Tree& tree, double alpha) const;
    /// Whether its center is that of the instance that it follows, at any time.
    bool follows_without_delay(const property::Tree& tree) const;
    /// m, how far something moves at least if it jumps and is not drawn on its way.
    double far() const { return 0.1 * height; }

    // For drawing only.
    double label_scale = 1;  // see Painter::label_scale
    property::Track track{};
    double step_length = 0;  // s, of the last step

    std::string effect{};  // file of a shader; empty: none
    Fit fit = Fit::expand;
    property::Vec2 design{1280, 800};  // px, for letterbox and pixel

    double zoom() const;   // px/m
    double width() const;  // m
    /// px, size of the picture, as far as the window shows it.
    property::Vec2 picture() const;
    /// px, where the top left corner of the picture is in the window: whole pixels.
    property::Vec2 corner() const;
    /// The corners of the box around the visible part of the world.
    property::Vec2 lower() const { return center - reach(); }
    property::Vec2 upper() const { return center + reach(); }
    property::Vec2 reach() const;

    property::Vec2 to_screen(const property::Vec2& world) const;
    /// Pixels from the top left corner of the window.
    property::Vec2 to_window(const property::Vec2& world) const;
    property::Vec2 to_world(const property::Vec2& pixels) const;
    /// `to_window` for many points. Far from the origin it is less exact.
    property::Transform world_to_window() const;

  private:
    void keep_to_limits();
    property::Placement placement() const {
        return {.position = center, .angle = angle, .scale = height};
    }
};

/// Where an instance is, with all instances above it; the position of instances without one is
/// that of their parent.
property::Vec2 world_position(const property::Tree& tree, property::Handle instance);

/// Adds the view to the tree as `view`, with `view.show` and `view.window`. It must outlive all use
/// by the tree.
property::Handle define_view(property::Tree& tree, View& view);

}  // namespace fettle::app

FETTLE_APP_END
