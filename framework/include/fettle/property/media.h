#pragma once
// Images and written text for code that draws without instances, such as `draw(pen)` of scripts.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/painter.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The user of a file, as a path ("world.hero.look.image"), with which an error message begins.
/// Called only for such a message.
using FileUser = std::function<std::string()>;

struct TextStyle {
    std::string font = "sans";  // or "bold", "mono", a font file of the game
    double size = 0.5;          // in the units of the painter
    Color color{1, 1, 1, 1};
    TextAlign align = TextAlign::middle;
    double wrap = 0;  // greatest width of a line of several words, in these units; 0: no limit
    Color outline{0, 0, 0, 0};  // around the letters; transparent: none
};

/// A frame of an image: columns and rows of equal frames, or those of an Aseprite export.
struct ImageFrame {
    std::int64_t columns = 1, rows = 1;
    std::int64_t frame = 1;  // from 1, row by row; counted again from the first beyond the last
};

/// Where a frame is in its picture. A tool may have cut off the transparent pixels around it.
struct PictureFrame {
    PictureArea area{};
    Vec2 offset{0, 0};  // px, of the area in the uncut frame, y down
    Vec2 size{0, 0};    // px, of the uncut frame
};

class Media {
  public:
    virtual ~Media() = default;
    /// An image file of the game; a checkerboard if it is missing. The picture lives as long as the
    /// game.
    virtual const Picture& picture(const FileUser& user, const std::string& name) = 0;
    /// The part of that picture that a frame is.
    virtual PictureFrame frame(const FileUser& user, const std::string& name,
                               const ImageFrame& frame) = 0;
    /// Loads a font, so that a message about it names this user and not the first text in it.
    virtual void load_font(const FileUser& user, const std::string& font) = 0;
    /// Whether pictures that are enlarged are smooth by default.
    virtual bool smooth() const = 0;
    /// Width of the longest line, and height of all lines.
    virtual Vec2 text_size(std::string_view text, const TextStyle& style) = 0;
    /// Where a caret stands in a text of one line: before each character and at the end, from the
    /// left end of the text. They descend where the text runs from right to left.
    virtual std::vector<double> carets(std::string_view text, const TextStyle& style) = 0;
    /// Whether the first paragraph of a text, up to its first line break, runs from right to left:
    /// its first letter with a direction decides that.
    virtual bool right_to_left(std::string_view text) = 0;
    /// `position`: in the middle of the height, at the beginning, middle or end of each line.
    virtual void text(Painter& painter, const Vec2& position, std::string_view text,
                      const TextStyle& style) = 0;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
