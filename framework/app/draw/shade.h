#pragma once
// The texture of a gradient, and the texel of each pixel. A texture is exact in triangles of any
// shape; colors at their corners are not.

#include <map>
#include <string>

#include <fettle/property/painter.h>

#include <sfml/sfml.h>

namespace fettle::app {

class Shade {
  public:
    /// `placed`: with points in pixels. `across`: px, the point beside `from`, as far away as `to`
    /// before any transform. False if the gradient has no extent, and nothing can be drawn.
    bool begin(const property::Gradient& placed, const property::Vec2& across);
    void end() { texture_ = nullptr; }
    /// Whether `begin` may free textures. Triangles that use them must be drawn before.
    bool full() const { return known_.size() >= most_known; }
    /// Null if no gradient is drawn.
    const sf::Texture* texture() const { return texture_; }
    sf::Vector2f texel(sf::Vector2f pixel) const;

  private:
    static constexpr std::size_t most_known = 64;

    const sf::Texture* texture_ = nullptr;
    // texel = origin + x * pixel.x + y * pixel.y
    property::Vec2 origin_{0, 0}, x_{0, 0}, y_{0, 0};
    std::map<std::string, sf::Texture> known_{};
};

}  // namespace fettle::app
