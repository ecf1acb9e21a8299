// Fettle's console in a game that has a window and a loop of its own, written with SFML.
// The game draws its balls itself; the console (the grave key) shows and edits them as they fly.
//
//   window [FRAMES [open]]   ends after FRAMES frames, with a picture in window.png; the word open
//                            opens the console

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <SFML/Graphics.hpp>

#include <fettle/app/host_window.h>
#include <fettle/console/console.h>
#include <fettle/physics_module/physics_module.h>

using namespace fettle;
using property::Handle;
using property::Vec2;

namespace {

constexpr float scale = 40;  // pixels a meter
constexpr unsigned width = 960, height = 640;

sf::Vector2f pixels(const Vec2& at) {
    return {width / 2 + scale * float(at.x), height - 60 - scale * float(at.y)};
}
Vec2 meters(float x, float y) {
    return {(x - width / 2) / scale, (height - 60 - y) / scale};
}

/// The next event. SFML 2 writes it to an argument, SFML 3 returns it.
template <class Window>
std::optional<sf::Event> next(Window& window) {
    if constexpr (requires(sf::Event e) { window.pollEvent(e); }) {
        sf::Event event;
        return window.pollEvent(event) ? std::optional(event) : std::nullopt;
    } else {
        return window.pollEvent();
    }
}
template <class Texture>
void make(Texture& texture) {
    if constexpr (requires { texture.create(width, height); })
        (void)texture.create(width, height);
    else
        (void)texture.resize({width, height});
}
template <class Event>
bool closes(const Event& event) {
    if constexpr (requires { event.type; })
        return event.type == Event::Closed;
    else
        return event.template is<typename Event::Closed>();
}

std::vector<Handle> make_balls(property::Tree& tree) {
    const Handle world = tree.child(tree.root(), "world");
    tree.set(world, "bounds", property::List{Vec2(-12, 0), Vec2(12, 14)});
    std::vector<Handle> balls;
    for (int i = 0; i < 12; ++i) {
        balls.push_back(tree.create(tree.class_named("Body"), world));
        tree.set(balls.back(), "position", Vec2(i - 5.5, 4 + i % 4));
        const Handle circle = tree.create(tree.class_named("Circle"), balls.back(), "circle");
        tree.set(circle, "restitution", 0.8);
        tree.set(circle, "radius", 0.3 + 0.05 * (i % 5));
    }
    return balls;
}

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : -1;
    sf::RenderWindow window(sf::VideoMode({width, height}), "A game of its own");
    window.setFramerateLimit(60);

    physics_module::PhysicsModule physics;
    property::Tree tree;
    physics.attach(tree);
    const std::vector<Handle> balls = make_balls(tree);

    // The console needs a runtime that runs its commands, and a connection to the window.
    script::Runtime lua(tree, {});
    app::HostWindow host(window);
    console::Console console(
        tree, lua, {.clipboard = &host.clipboard(), .to_world = meters, .to_pixels = [](Vec2 at) {
                        const sf::Vector2f p = pixels(at);
                        return Vec2(p.x, p.y);
                    }});
    console.open(argc > 2 && argv[2] == std::string("open"));

    for (int frame = 0; window.isOpen() && frame != frames; ++frame) {
        while (const std::optional<sf::Event> event = next(window)) {
            if (host.handle(*event, console)) continue;  // the console has used it
            if (closes(*event)) window.close();
        }
        console.between_frames();
        tree.set_step(static_cast<std::uint64_t>(frame) + 1);
        physics.step(1.0 / 60);
        physics.report(tree);
        tree.barrier();
        console.after_step();  // for plots, pinned values and breaks
        if (frame == 30 && console.is_open()) console.select(balls[3]);

        window.clear(sf::Color(30, 34, 42));
        for (const Handle ball : balls) {
            if (!tree.alive(ball)) continue;  // the console may have deleted it
            const float radius =
                float(tree.get(tree.child(ball, "circle"), "radius").number()) * scale;
            sf::CircleShape disc(radius);
            disc.setOrigin({radius, radius});
            disc.setPosition(pixels(tree.get(ball, "position").vec2()));
            disc.setFillColor(sf::Color(255, 190, 60));
            window.draw(disc);
        }
        host.draw(console, 1.0 / 60);
        if (frame + 1 == frames) {
            sf::Texture picture;
            make(picture);
            picture.update(window);
            if (!picture.copyToImage().saveToFile("window.png")) return 1;
        }
        window.display();
    }
}
