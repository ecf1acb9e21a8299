#pragma once
// An image file, or the frames of several images in one file.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/media.h>
#include <fettle/property/picture.h>
#include <fettle/property/value.h>

namespace fettle::visuals {

/// A frame of a sheet.
struct Frame : property::PictureFrame {
    double seconds = 0;  // 0: not given
};

/// A named part of the frames, which is played by itself.
struct Animation {
    std::string name;
    std::vector<std::size_t> frames;  // in the order of playing
};

/// Frames of the same size, counted row by row. Lengths in pixels.
struct FrameGrid {
    std::int64_t columns = 1, rows = 1;
    double margin = 0, spacing = 0;  // around all frames; between two of them
    property::Vec2 size{0, 0};       // of a frame

    /// As many frames as columns and rows say.
    static FrameGrid divided(const property::Picture& picture, std::int64_t columns,
                             std::int64_t rows, double margin = 0, double spacing = 0);
    /// As many frames of that size as there is room for, at least one.
    static FrameGrid filled(const property::Picture& picture, const property::Vec2& size,
                            double margin, double spacing);
    property::PictureFrame at(std::size_t index) const;
};

struct Sheet {
    property::Picture picture{};
    std::string image{};        // name of the file with the pixels
    bool found = false;         // false: the picture is the checkerboard
    std::vector<Frame> frames;  // of a sheet that was exported; empty for an image file
    std::vector<Animation> animations;

    /// The image as one frame.
    Frame whole() const { return {FrameGrid::divided(picture, 1, 1).at(0)}; }
    /// Nullptr if there is none.
    const Animation* animation(std::string_view name) const;
};

/// A JSON file as Aseprite exports it.
struct Export {
    std::string image;  // file name, beside the JSON file
    std::vector<Frame> frames;
    std::vector<Animation> animations;
};

/// Throws std::runtime_error with the reason.
Export read_export(std::string_view json);

}  // namespace fettle::visuals
