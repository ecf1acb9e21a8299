#pragma once
// The console with the Lua runtime, in a game that makes steps and keeps a past.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "rig.h"

namespace fettle::console::test {

using property::Value;
using property::Vec2;

/// A rig whose commands are Lua, in a game that makes steps and keeps a past: the position of
/// `world.ball` at step n is (n, -4).
class ObservingRig : public Rig {
  public:
    ObservingRig() : runtime(tree, {}), lua(tree, runtime, options()) {
        property::ClassDescriptor time;
        time.name = "Clock";
        for (const char* name : {"step", "oldest", "newest"})
            time.properties.push_back(
                {.name = name, .type = property::Type::integer, .default_value = Value(0)});
        for (const char* name : {"paused", "step_once"})
            time.properties.push_back(
                {.name = name, .type = property::Type::boolean, .default_value = Value(false)});
        property::Method go_to;
        go_to.name = "go_to";
        go_to.parameters = {{"step", property::Type::integer}};
        go_to.required = 1;
        go_to.context = this;
        go_to.call = [](void* self, property::Tree&, property::Handle, property::Row,
                        std::span<const Value> arguments) -> property::Result {
            if (arguments[0].integer() < 0)
                throw property::Error(property::ErrorKind::out_of_range,
                                      "the past has no step below 0");
            static_cast<ObservingRig*>(self)->went_to = arguments[0].integer();
            return Value();
        };
        time.methods = {go_to};
        tree.destroy(tree.child(tree.root(), "time"));
        tree.create(tree.define(std::move(time)), tree.root(), "time");
        lua.open();
        show();
    }
    void run(const std::string& command) {
        lua.state().run(command);
        lua.between_frames();
    }
    void step(int count = 1) {
        for (; count > 0 && !value("time.paused").boolean(); --count) {
            ++now;
            tree.set_step(static_cast<std::uint64_t>(now));
            place(now);
            tree.barrier();
            lua.after_step();
            lua.between_frames();
        }
    }
    void show(int frames = 3) {
        for (; frames > 0; --frames) {
            surface.clear();
            lua.draw(surface, 1.0 / 60);
        }
    }
    std::string text() {
        std::string all;
        for (const console::LogLine& line : lua.state().log.lines()) all += line.whole() + "\n";
        return all;
    }
    bool press_key(std::string_view name) {
        const bool consumed = lua.handle(key_event(name, true));
        lua.handle(key_event(name, false));
        return consumed;
    }
    void click_at(ImVec2 at, const char* which = "left") {
        for (const auto kind : {app::EventKind::mouse_moved, app::EventKind::mouse_pressed,
                                app::EventKind::mouse_released}) {
            app::InputEvent event;
            event.kind = kind;
            event.name = which;
            event.x = at.x;
            event.y = at.y;
            lua.handle(event);
            show(2);
        }
    }
    const std::vector<console::Trace>& pins() { return lua.state().observing.pins(); }
    const std::vector<console::Trace>& plots() { return lua.state().observing.plots(); }

    std::int64_t now = 0, went_to = -1;
    bool refuses = false;
    std::vector<std::string> written;
    std::vector<std::vector<Pixel>> pictures;
    script::Runtime runtime;
    console::Console lua;

  private:
    void place(std::int64_t n) {
        const property::Tree::CauseScope cause(tree, property::Writer::simulation);
        property::set(tree, "world.ball.position", Value(Vec2(static_cast<double>(n), -4)));
        for (const char* name : {"time.step", "time.newest"}) property::set(tree, name, Value(n));
    }
    console::Options options() {
        console::Options made;
        made.clipboard = &clipboard;
        made.write_file = [this](const std::string& kind, const std::string& content) {
            if (refuses) throw std::runtime_error("the disk is full");
            written.push_back(content);
            return "/plots/plot-1." + kind;
        };
        made.write_picture = [this](float, float, const auto& draw) {
            RasterSurface picture(1200, 600);
            draw(picture);
            pictures.push_back(picture.pixels());
            CHECK(picture.faults() == 0);
            return std::string("/plots/plot-1.png");
        };
        made.review = [this](std::int64_t from, std::int64_t to, const auto& visit) {
            for (std::int64_t n = std::max<std::int64_t>(from, 0); n <= std::min(now, to); ++n) {
                place(n);
                visit(n);
            }
        };
        return made;
    }
};

}  // namespace fettle::console::test
