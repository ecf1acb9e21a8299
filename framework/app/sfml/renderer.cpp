#include <string_view>

#include <sfml/sfml.h>

namespace fettle::app::sfml {

bool renders_in_software() {
    constexpr unsigned renderer = 0x1F01;  // GL_RENDERER
    const auto get = reinterpret_cast<const unsigned char* (*)(unsigned)>(
        sf::Context::getFunction("glGetString"));
    const unsigned char* const text = get == nullptr ? nullptr : get(renderer);
    if (text == nullptr) return false;
    const std::string_view name(reinterpret_cast<const char*>(text));
    for (const char* known : {"llvmpipe", "softpipe", "swr", "SwiftShader", "Software"})
        if (name.find(known) != std::string_view::npos) return true;
    return false;
}

}  // namespace fettle::app::sfml
