#pragma once
// Draws the picture of a target again through a shader.

#include <functional>
#include <memory>
#include <string>

#include <fettle/app/effect.h>

#include <sfml/sfml.h>

namespace fettle::app {

class EffectPass {
  public:
    /// `copy`: fills a texture of the size of the target with its picture, and returns whether the
    /// rows of the texture are from the bottom. Returns what is wrong; "" if the effect was drawn.
    /// A shader is compiled once. While new code of a file is in error, its old code is drawn.
    std::string draw(sf::RenderTarget& target, const Effect& effect,
                     const std::function<bool(sf::Texture&)>& copy);

  private:
    std::string compile(const Effect& effect);

    std::string name_, code_;  // of the effect that was compiled last
    std::string problem_;      // why `code_` is not a shader
    std::unique_ptr<sf::Shader> shader_;
    sf::Texture picture_{};
};

}  // namespace fettle::app
