#pragma once
// A screen that prepares everything for the graphics driver but sends nothing to it. The time that
// a driver takes depends on the machine; without a graphics card it would be most of the time.

#include <fettle/app/screen.h>

#include <draw/canvas.h>
#include <sfml/sfml.h>

namespace fettle::bench {

class UndrawnScreen : public app::Screen {
  public:
    UndrawnScreen(unsigned width, unsigned height) : target_(width, height) {}
    property::Vec2 size() const override {
        return {static_cast<double>(target_.getSize().x), static_cast<double>(target_.getSize().y)};
    }
    void begin(property::Color background) override { canvas_.begin(background); }
    property::Painter& painter(const app::View& view) override {
        canvas_.set_view(view);
        return canvas_;
    }
    app::Surface& surface() override { return canvas_; }
    void present() override { canvas_.flush(); }
    void save(const std::filesystem::path&) override {}
    app::Pixels pixels() const override { return {}; }
    void release_textures() override { canvas_.release_textures(); }
    app::Clipboard& clipboard() override { return clipboard_; }

  private:
    /// SFML draws only on an active target. This target is never active, so nothing is drawn.
    struct Target : sf::RenderTarget {
        Target(unsigned width, unsigned height) : size(width, height) { initialize(); }
        sf::Vector2u getSize() const override { return size; }
        bool setActive(bool = true) override { return false; }
        sf::Vector2u size;
    };
    struct NoClipboard : app::Clipboard {
        std::string read() override { return {}; }
        void write(std::string_view) override {}
    };

    Target target_;
    app::Canvas canvas_{target_};
    NoClipboard clipboard_;
};

}  // namespace fettle::bench
