#include <fettle/app/host_window.h>

#include <set>
#include <string>

#include <fettle/property/tree.h>

#include <draw/canvas.h>
#include <sfml/sfml.h>
#include <sfml/system_clipboard.h>

namespace fettle::app {

struct HostWindow::State {
    explicit State(sf::RenderWindow& w) : window(w), canvas(w) {}
    sf::RenderWindow& window;
    Canvas canvas;
    SystemClipboard clipboard;
    std::set<std::string> down;  // pressed keys, to mark repeated events

    /// Draws in pixels, then restores the view of the game.
    template <class Draw>
    void over_the_game(Draw draw) {
        const sf::View before = window.getView();
        draw();
        canvas.flush();
        window.setView(before);
    }
};

HostWindow::HostWindow(sf::RenderWindow& window) : state_(std::make_unique<State>(window)) {}
HostWindow::~HostWindow() = default;

bool HostWindow::handle(const sf::Event& event, Layer& layer) {
    InputEvent converted;
    if (!sfml::convert(event, converted)) return false;
    if (converted.kind == EventKind::key_pressed)
        converted.repeated = !state_->down.insert(converted.name).second;
    else if (converted.kind == EventKind::key_released)
        state_->down.erase(converted.name);
    else if (converted.kind == EventKind::focus && !converted.focused)
        state_->down.clear();
    return layer.handle(converted);
}

void HostWindow::draw(Layer& layer, double seconds) {
    state_->over_the_game([&] { layer.draw(state_->canvas, seconds); });
}

void HostWindow::draw(const property::Tree& tree, property::Handle top, const View& view,
                      double alpha) {
    state_->canvas.set_view(view);
    state_->over_the_game([&] { tree.draw(top, state_->canvas, alpha); });
}

Clipboard& HostWindow::clipboard() {
    return state_->clipboard;
}

}  // namespace fettle::app
