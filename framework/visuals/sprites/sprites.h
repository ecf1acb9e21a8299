#pragma once
// The class Sprite: a picture, or a frame of a sheet that moves on with simulation time.

#include <cstdint>
#include <memory>
#include <vector>

#include <fettle/module/rows.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <images/images.h>
#include <properties/properties.h>

namespace fettle::visuals {

class Sprites {
  public:
    explicit Sprites(Images& images) : images_(images) {}
    void define(property::Tree& tree);
    void step(double dt);
    /// Emits `finished` for the animations that ended in the step.
    void report();
    /// Of the sprites in the tree, in its order: a restore gives them other rows.
    std::uint64_t hash() const;

  private:
    /// The data of a sprite that the tree does not store, since the simulation changes it.
    struct Row {
        property::Handle self{};  // null: the row is free
        std::int64_t frame = 0;   // within the animation, from 0
        double elapsed = 0;       // s, since the frame began
        // The image that was used last.
        property::Value name{};
        std::shared_ptr<const Sheet> sheet{};
    };
    struct Properties {
        const property::Property *image, *size, *origin, *flip_x, *flip_y, *tint, *columns, *rows,
            *animation, *frames_per_second, *loop, *playing, *blend, *visible, *smooth,
            *pixels_per_unit, *frame_size, *margin, *spacing;
    };
    /// The frames that are played: those of an animation, or all.
    struct Playing {
        const Animation* animation = nullptr;  // of an exported sheet
        std::int64_t first = 0, count = 1;     // otherwise, in the sheet
    };

    std::vector<property::Property> picture_properties();
    std::vector<property::Property> frame_properties();
    std::vector<property::Property> look_properties();
    std::vector<property::Property> derived_properties();
    // `read`: the properties of the sprite of the row.
    const Sheet* sheet(Row& row, const Reader& read);
    std::int64_t frames_in(const Sheet& sheet, const Reader& read) const;
    FrameGrid grid(const Sheet& sheet, const Reader& read) const;
    Playing playing(const Row& row, const Sheet& sheet, const Reader& read) const;
    Frame frame(const Row& row, const Reader& read) const;
    double seconds_of(const Row& row, const Sheet& sheet, const Playing& playing,
                      const Reader& read) const;
    void advance(Row& row, double dt);
    void draw(Row& row, property::Painter& painter, double alpha);
    property::Vec2 size_of(const Frame& frame, bool on_screen, const Reader& read) const;

    Images& images_;
    property::Tree* tree_ = nullptr;
    Properties of_{};
    const property::Event* finished_ = nullptr;
    module::Rows<Row> rows_;
    std::vector<property::Handle> ended_;
};

}  // namespace fettle::visuals
