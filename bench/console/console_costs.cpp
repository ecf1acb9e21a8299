#include "console/console_costs.h"

#include <fettle/console/console.h>

#include <algorithm>
#include <cmath>

#include "engines/hosted_engine.h"
#include "measure/timing.h"

namespace fettle::bench {

namespace {

using property::Handle;
using property::Vec2;

constexpr float wide = 1280, high = 800;  // px

/// Passes triangles on to another surface, counts them, and measures the time that this takes.
class CountingSurface : public app::Surface {
  public:
    explicit CountingSurface(app::Surface* behind) : behind_(behind) {}
    float width() const override { return wide; }
    float height() const override { return high; }
    Texture create_texture(unsigned w, unsigned h, const std::uint8_t* rgba) override {
        return behind_ != nullptr ? behind_->create_texture(w, h, rgba) : 1;
    }
    void update_texture(Texture texture, unsigned x, unsigned y, unsigned w, unsigned h,
                        const std::uint8_t* rgba) override {
        if (behind_ != nullptr) behind_->update_texture(texture, x, y, w, h, rgba);
    }
    void destroy_texture(Texture texture) override {
        if (behind_ != nullptr) behind_->destroy_texture(texture);
    }
    void triangles(std::span<const app::SurfaceVertex> vertices,
                   std::span<const std::uint16_t> indices, Texture texture,
                   const app::ClipRectangle& clip) override {
        const ThreadClock clock;
        if (behind_ != nullptr) behind_->triangles(vertices, indices, texture, clip);
        count += indices.size() / 3;
        ms += clock.elapsed_ms();
    }
    std::size_t count = 0;
    double ms = 0;

  private:
    app::Surface* behind_;
};

/// Rows of sleeping circles that do not touch; the first body flies above them.
Scene sleepers(int bodies) {
    Scene scene{.name = "sleepers", .gravity = {0, 0}};
    const int columns = std::max(1, static_cast<int>(std::sqrt(bodies)));
    for (int i = 0; i < bodies; ++i) {
        SceneBody body;
        body.motion = Motion::dynamic;
        body.position = {static_cast<float>(i % columns), static_cast<float>(-(i / columns))};
        body.awake = false;
        body.shapes.push_back({.geometry = CircleShape{0.3f}});
        scene.bodies.push_back(body);
    }
    SceneBody& flying = scene.bodies.front();
    flying.position = {0, 3};
    flying.velocity = {0.01f, 0};
    flying.awake = true;
    flying.can_sleep = false;
    return scene;
}

class LargeGame {
  public:
    LargeGame(int bodies, app::Screen* screen)
        : engine_(sleepers(bodies), false),
          world_(tree().child(tree().root(), "world")),
          screen_(screen),
          surface_(screen != nullptr ? &screen->surface() : nullptr),
          console_(tree(), engine_.game().runtime, options(bodies)) {
        tree().rename(engine_.handle(0), "flying");
    }
    ~LargeGame() {
        if (screen_ != nullptr) screen_->release_textures();
    }
    LargeGame(const LargeGame&) = delete;

    property::Tree& tree() { return engine_.game().tree; }
    console::Console& console() { return console_; }
    void run(const std::string& code) { engine_.game().runtime.run(code, "bench"); }
    /// One body leaves the game in each frame, and another one comes.
    void let_one_come_and_go() { comes_and_goes_ = true; }

    ConsoleCost measure(const std::string& state, int frames) {
        constexpr int warm_up = 10;
        std::vector<ConsolePhases> all;
        for (int i = 0; i < warm_up; ++i) frame();
        for (int i = 0; i < frames; ++i) all.push_back(frame());
        const auto middle = [&](auto phase) {
            std::vector<double> values;
            for (const ConsolePhases& each : all) values.push_back(phase(each));
            return median(std::move(values));
        };
        ConsoleCost cost{.state = state};
        cost.median.after_step = middle([](const ConsolePhases& p) { return p.after_step; });
        cost.median.between_frames =
            middle([](const ConsolePhases& p) { return p.between_frames; });
        cost.median.widgets = middle([](const ConsolePhases& p) { return p.widgets; });
        cost.median.triangles = middle([](const ConsolePhases& p) { return p.triangles; });
        cost.frame = middle([](const ConsolePhases& p) { return p.total(); });
        for (const ConsolePhases& each : all) cost.longest = std::max(cost.longest, each.total());
        cost.drawn = surface_.count;
        return cost;
    }

  private:
    static console::Options options(int bodies) {
        // All bodies are in the picture, so that outlines of all of them could be seen.
        const double scale = high / std::sqrt(static_cast<double>(bodies));
        console::Options options;
        options.to_world = [=](float x, float y) { return Vec2(x / scale, -y / scale); };
        options.to_pixels = [=](Vec2 p) { return Vec2(p.x * scale, -p.y * scale); };
        return options;
    }
    ConsolePhases frame() {
        if (comes_and_goes_) {
            if (tree().alive(visitor_)) tree().destroy(visitor_);
            visitor_ = tree().create(tree().class_named("Body"), world_);
        }
        engine_.step();
        ConsolePhases phases;
        const auto spent = [](const auto& phase) {
            const ThreadClock clock;
            phase();
            return clock.elapsed_ms();
        };
        phases.after_step = spent([&] { console_.after_step(); });
        phases.between_frames = spent([&] { console_.between_frames(); });
        if (screen_ != nullptr) screen_->begin({});
        surface_.count = 0;
        surface_.ms = 0;
        const double drawing = spent([&] { console_.draw(surface_, 1.0 / 60); });
        phases.triangles = surface_.ms;
        phases.widgets = drawing - surface_.ms;
        if (screen_ != nullptr) phases.triangles += spent([&] { screen_->present(); });
        return phases;
    }

    HostedEngine engine_;
    Handle world_, visitor_;
    app::Screen* screen_;
    CountingSurface surface_;
    console::Console console_;
    bool comes_and_goes_ = false;
};

}  // namespace

std::vector<ConsoleCost> console_costs(int bodies, int frames, app::Screen* screen) {
    LargeGame game(bodies, screen);
    std::vector<ConsoleCost> costs;
    const auto measure = [&](const char* state) { costs.push_back(game.measure(state, frames)); };
    measure("closed");
    game.console().open();
    measure("open");
    game.run("selection { world.flying }");
    measure("one selected");
    std::string plots = "plot(\"world.flying.position\"";
    for (int i = 1; i < 10; ++i) plots += ", \"world.flying.angle + " + std::to_string(i) + "\"";
    game.run(plots + ")");
    measure("one selected, ten plots");
    game.run("plot()");
    game.run("selection(world:children())");
    game.run("assert(#selection() >= " + std::to_string(bodies) + ", #selection())");
    measure("all selected");
    game.let_one_come_and_go();
    measure("all selected, one comes and goes");
    return costs;
}

}  // namespace fettle::bench
