#pragma once
// Pictures of the game as textures of the console.

#include <imgui.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <fettle/app/surface.h>
#include <fettle/property/picture.h>

namespace fettle::console {

/// While a frame is built, a picture only gets a number, because there is no surface yet. Its
/// texture is made when the frame is drawn, and destroyed when it was not drawn for a while.
class GamePictures {
  public:
    /// Whether it is small enough for a texture.
    static bool fits(const property::Picture& picture);
    /// A number for the draw list of this frame. The picture must exist until the frame is drawn.
    ImTextureID number(const property::Picture& picture);
    /// The texture for a number of this frame; nothing for other textures.
    std::optional<app::Surface::Texture> texture(app::Surface& surface, ImTextureID number);
    /// The frame is drawn. Destroys textures that are not used any more.
    void end_frame(app::Surface& surface);
    /// The frame is drawn on another surface than the last one, which has no textures yet.
    void change_surface();

  private:
    struct Known {
        const property::Picture* picture = nullptr;  // null: not in this frame
        app::Surface::Texture number = 0;            // in this frame
        app::Surface::Texture texture = 0;           // 0: not made yet
        int idle = 0;                                // frames without it
    };

    std::map<std::uint64_t, Known> known_;  // by the version of the picture
    std::vector<Known*> numbered_;          // in this frame
};

}  // namespace fettle::console
