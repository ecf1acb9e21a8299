#include <look/game_pictures.h>

#include <algorithm>

#include <look/imgui_compat.h>

namespace fettle::console {

namespace {

constexpr std::uint32_t largest_side = 4096;  // px, which every graphics driver can draw
constexpr int longest_idle = 120;             // frames

/// Numbers of pictures begin here; textures of a surface are counted from 1.
constexpr app::Surface::Texture first_number = 1u << 31;

}  // namespace

bool GamePictures::fits(const property::Picture& picture) {
    return picture.width() > 0 && picture.height() > 0 &&
           std::max(picture.width(), picture.height()) <= largest_side;
}

ImTextureID GamePictures::number(const property::Picture& picture) {
    Known& known = known_[picture.version()];
    if (known.picture == nullptr) {
        known.picture = &picture;
        known.number = first_number + static_cast<app::Surface::Texture>(numbered_.size());
        known.idle = 0;
        numbered_.push_back(&known);
    }
    return compat::texture_id(known.number);
}

std::optional<app::Surface::Texture> GamePictures::texture(app::Surface& surface,
                                                           ImTextureID number) {
    const app::Surface::Texture given = compat::surface_texture(number);
    if (given < first_number || given - first_number >= numbered_.size()) return std::nullopt;
    Known& known = *numbered_[given - first_number];
    if (known.texture == 0) {
        const property::Picture& picture = *known.picture;
        known.texture =
            surface.create_texture(picture.width(), picture.height(), picture.rgba().data());
    }
    return known.texture;
}

void GamePictures::change_surface() {
    for (auto& [version, known] : known_) known.texture = 0;
}

void GamePictures::end_frame(app::Surface& surface) {
    numbered_.clear();
    for (auto at = known_.begin(); at != known_.end();) {
        Known& known = at->second;
        known.picture = nullptr;
        if (++known.idle <= longest_idle) {
            ++at;
            continue;
        }
        if (known.texture != 0) surface.destroy_texture(known.texture);
        at = known_.erase(at);
    }
}

}  // namespace fettle::console
