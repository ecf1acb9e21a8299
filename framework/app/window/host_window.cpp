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
    InputEvent told;
    if (!sfml::convert(event, told)) return false;
    if (told.kind == EventKind::key_pressed)
        told.repeated = !state_->down.insert(told.name).second;
    else if (told.kind == EventKind::key_released)
        state_->down.erase(told.name);
    else if (told.kind == EventKind::focus && !told.focused)
        state_->down.clear();
    return layer.handle(told);
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
