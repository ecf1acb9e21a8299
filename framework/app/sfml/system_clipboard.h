#pragma once
// The system clipboard, accessed with SFML.

#include <string>

#include <fettle/app/layer.h>

#include <sfml/sfml.h>

namespace fettle::app {

class SystemClipboard : public Clipboard {
  public:
    std::string read() override {
        const auto text = sf::Clipboard::getString().toUtf8();
        return {text.begin(), text.end()};
    }
    void write(std::string_view text) override {
        sf::Clipboard::setString(sf::String::fromUtf8(text.begin(), text.end()));
    }
};

}  // namespace fettle::app
