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

struct Sheet {
    property::Picture picture{};
    std::string image{};        // name of the file with the pixels
    bool found = false;         // false: the picture is the checkerboard
    std::vector<Frame> frames;  // of a sheet that was exported; empty for an image file
    std::vector<Animation> animations;

    /// One of equal parts, counted row by row.
    Frame part(std::size_t index, std::int64_t columns, std::int64_t rows) const;
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
