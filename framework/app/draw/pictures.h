#pragma once
// Pictures as textures. Small ones share large textures, so that many of them are drawn in one
// batch.

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include <fettle/property/picture.h>

#include <draw/atlas.h>
#include <draw/quad_raster.h>
#include <sfml/sfml.h>

namespace fettle::app {

class Pictures {
  public:
    struct Place {
        const sf::Texture* texture = nullptr;  // null: there is no room on the graphics card
        float left = 0, top = 0;               // texels, of the top left pixel of the picture
    };
    enum class Kind : std::uint8_t { sharp, smooth, sharp_multiplied, smooth_multiplied };

    /// From now on, the texels of pages are also kept in memory.
    void keep_texels() { keeps_texels_ = true; }
    /// Those of a page; without `rgba` if they are not kept, or for any other texture.
    TexelRows texels(const sf::Texture& texture) const;
    /// Copies the picture into a texture unless that was done before. `is_premultiplied`: colors
    /// are multiplied by their opacity.
    Place place(const property::Picture& picture, bool smooth, bool is_premultiplied);
    /// Whether the texture has the white patch of the atlas, so that figures without a texture can
    /// be drawn with it.
    bool has_white(const sf::Texture* texture) const;
    /// Frees textures of pictures that were not drawn for a while. Places are valid until then.
    void begin_frame();

  private:
    struct Page {
        Kind kind;
        std::unique_ptr<sf::Texture> texture;
        unsigned x = 0, y = 0, height = 0;   // of the shelf that is being filled
        std::vector<std::uint8_t> texels{};  // the rows that are in use, if they are kept
    };
    struct Entry {
        std::uint64_t version = 0;
        std::uint64_t used = 0;              // frame
        std::unique_ptr<sf::Texture> own{};  // null: on a page
        Place place{};
    };
    struct Key {
        const property::Picture* picture = nullptr;
        Kind kind = Kind::sharp;
        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            return std::hash<const void*>()(key.picture) * 4 + static_cast<std::size_t>(key.kind);
        }
    };
    Entry& entry_of(const Key& key);
    std::optional<Place> put_on_page(const property::Picture& picture, Kind kind);
    std::optional<Place> put(Page& page, const property::Picture& picture) const;
    void write(Page& page, const std::vector<std::uint8_t>& rgba, unsigned width, unsigned height,
               unsigned x, unsigned y) const;
    Page* add_page(Kind kind);

    std::unordered_map<Key, Entry, Hash> entries_;
    Key last_key_{};
    Entry* last_ = nullptr;  // of last_key_: many sprites in a row have one picture
    std::vector<std::unique_ptr<Page>> pages_;
    std::uint64_t frame_ = 0;
    bool pages_are_full_ = false;
    bool keeps_texels_ = false;
};

}  // namespace fettle::app
