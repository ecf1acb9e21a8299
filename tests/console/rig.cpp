#include "rig.h"

#include "catch.h"

#include <algorithm>
#include <cmath>

#include <fettle/script/fuzzy.h>

namespace fettle::console::test {

using property::Class;
using property::Handle;
using property::List;
using property::Property;
using property::Range;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

constexpr double pixels_per_meter = 40;

property::Result body_at(void*, property::Tree& tree, Handle world, property::Row,
                         std::span<const Value> arguments) {
    Vec2 point = arguments[0].vec2();
    for (Handle body : tree.children(world))
        if ((tree.get(body, "position").vec2() - point).length() < 0.5) return Value(body);
    return Value();
}

std::vector<Property> body_properties() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    std::vector<Property> list;
    list.push_back({.name = "mask", .type = Type::integer, .default_value = -1, .bits = true});
    list.push_back({.name = "type",
                    .type = Type::text,
                    .default_value = "dynamic",
                    .doc = "How the body moves.",
                    .enumerators = {"static", "kinematic", "dynamic"}});
    list.push_back({.name = "position",
                    .type = Type::vec2,
                    .default_value = Vec2(0, 0),
                    .unit = "m",
                    .range = {-1e8, 1e8}});
    list.push_back({.name = "angle", .default_value = 0.0, .unit = "rad"});
    list.push_back({.name = "mass",
                    .default_value = 1.0,
                    .unit = "kg",
                    .range = {0, inf},
                    .doc = "Resists being moved; infinite: nothing moves it.",
                    .infinity = true});
    list.push_back({.name = "friction",
                    .default_value = 0.6,
                    .range = {0, 1},
                    .doc = "Of the surface.",
                    .single_precision = true});
    list.push_back({.name = "lives", .type = Type::integer, .default_value = 3, .range = {0, 9}});
    list.push_back({.name = "awake", .type = Type::boolean, .default_value = true});
    list.push_back({.name = "label", .type = Type::text, .default_value = ""});
    list.push_back(
        {.name = "color", .type = Type::color, .default_value = property::Color{1, 0.4f, 0.3f, 1}});
    list.push_back(
        {.name = "target", .type = Type::reference, .nullable = true, .reference_class = "Body"});
    list.push_back({.name = "vertices",
                    .type = Type::list,
                    .default_value = List{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)},
                    .element = Type::vec2});
    list.push_back({.name = "speed", .default_value = 0.0, .unit = "m/s", .simulated = true});
    list.push_back({.name = "energy", .default_value = 12.5, .unit = "J", .read_only = true});
    return list;
}

}  // namespace

void define_game(property::Tree& tree) {
    property::Method at;
    at.name = "at";
    at.parameters = {{"point", Type::vec2}};
    at.required = 1;
    at.returns = {{"body", Type::reference}};
    at.call = body_at;
    property::ClassDescriptor world;
    world.name = "World";
    world.properties = {
        {.name = "gravity", .type = Type::vec2, .default_value = Vec2(0, -10), .unit = "m/s²"}};
    world.methods = {at};
    tree.define(world);
    property::ClassDescriptor body;
    body.name = "Body";
    body.properties = body_properties();
    tree.define(body);
    property::ClassDescriptor time;
    time.name = "Time";
    time.properties = {{.name = "paused", .type = Type::boolean, .default_value = false}};
    tree.define(time);
}

void make_game(property::Tree& tree) {
    define_game(tree);
    Handle world = tree.create(tree.class_named("World"), tree.root(), "world");
    tree.create(tree.class_named("Time"), tree.root(), "time");
    double x = 0;
    for (const char* name : {"ball", "crate", "floor"}) {
        Handle body = tree.create(tree.class_named("Body"), world, name);
        tree.set(body, "position", Value(Vec2(x, -4)));
        x += 3;
    }
}

// --- The rig

Options Rig::with_view(Options options) {
    if (options.clipboard == nullptr) options.clipboard = &clipboard;
    options.to_world = [this](float x, float y) {
        return Vec2((x - surface.width() / 2) / pixels_per_meter,
                    (surface.height() / 2 - y) / pixels_per_meter);
    };
    options.to_pixels = [this](Vec2 p) {
        return Vec2(surface.width() / 2 + p.x * pixels_per_meter,
                    surface.height() / 2 - p.y * pixels_per_meter);
    };
    options.tweaks = tweaks.get();
    return options;
}

Rig::Rig(Options options, const std::filesystem::path& game)
    : tweaks(game.empty() ? nullptr
                          : std::make_unique<property::Tweaks>(
                                tree, game, [](const std::string& text) { FAIL(text); })),
      surface(1280, 720),
      console((make_game(tree), tree), simple_interpreter(), with_view(std::move(options))) {}

/// Runs a command that keeps, drops or reapplies tweaks; returns its report, "" for other commands.
std::string Rig::run_tweak_command(const std::string& command) {
    const std::size_t open = command.find("(\"");
    if (tweaks == nullptr || open == std::string::npos) return {};
    const std::string function = command.substr(0, open);
    const std::string pattern = command.substr(open + 2, command.size() - open - 4);
    const property::Tree::CauseScope cause(tree, property::Writer::console);
    const auto reported = [](const char* done, const property::TweakReport& report) {
        std::string line = std::string(done) + " " + std::to_string(report.count) +
                           (report.count == 1 ? " tweak" : " tweaks");
        for (const std::string& file : report.files)
            line += " in " + std::filesystem::path(file).filename().string();
        return line;
    };
    if (function == "keep") return reported("kept", tweaks->keep(pattern));
    if (function == "drop_tweaks") return reported("dropped", tweaks->drop(pattern));
    if (function == "reapply_tweaks") return reported("made again", tweaks->reapply(pattern));
    return {};
}

Interpreter Rig::simple_interpreter() {
    Interpreter interpreter;
    interpreter.evaluate = [this](std::string_view command) {
        script::Evaluation evaluation;
        commands.emplace_back(command);
        std::string text(command);
        auto count = [&](std::string_view word) {
            std::size_t n = 0;
            for (std::size_t at = text.find(word); at != std::string::npos;
                 at = text.find(word, at + 1))
                ++n;
            return n;
        };
        if (count("function") + count("then") + count(" do") > count("end")) {
            evaluation.incomplete = true;
            commands.pop_back();
            return evaluation;
        }
        std::size_t sign = text.find(" = ");
        try {
            if (std::string done = run_tweak_command(text); !done.empty()) {
                evaluation.lines.push_back(done);
                evaluation.ok = true;
                return evaluation;
            }
            if (text.starts_with("time:go_to(")) {  // a test looks at the command alone
                evaluation.ok = true;
                return evaluation;
            }
            std::string path = text.substr(0, sign);
            if (sign != std::string::npos)
                property::set(tree, path, Value(std::stod(text.substr(sign + 3))));
            evaluation.result = property::get(tree, path);
            evaluation.lines.push_back(path + ": " + tree.text(evaluation.result));
            evaluation.ok = true;
        } catch (const std::exception& error) {
            evaluation.error.emplace();
            evaluation.error->message = error.what();
            evaluation.error->source_line = text;
            evaluation.error->line = 1;
        }
        return evaluation;
    };
    interpreter.complete = [](std::string_view input, std::size_t cursor) {
        std::vector<script::Completion> found;
        std::size_t dot = input.substr(0, cursor).rfind('.');
        std::size_t from = dot == std::string_view::npos ? 0 : dot + 1;
        std::string_view typed = input.substr(from, cursor - from);
        std::vector<std::pair<int, std::string>> names;
        for (const char* name : {"friction", "force", "fixed", "mass", "inertia"})
            if (auto match = script::fuzzy_match(typed, name))
                names.emplace_back(match->score, name);
        std::stable_sort(names.begin(), names.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        for (const auto& [score, name] : names)
            found.push_back(
                {name, name, "0.612345 · number · 0 to inf", "About " + name + ".", from});
        return found;
    };
    return interpreter;
}

app::InputEvent key_event(std::string_view name, bool pressed) {
    app::InputEvent event;
    event.kind = pressed ? app::EventKind::key_pressed : app::EventKind::key_released;
    event.name = name;
    return event;
}

bool Rig::key(std::string_view combination) {
    bool control = false, shift = false, alt = false;
    for (std::size_t plus; (plus = combination.find('+')) != std::string_view::npos;) {
        std::string_view modifier = combination.substr(0, plus);
        control = control || modifier == "ctrl";
        shift = shift || modifier == "shift";
        alt = alt || modifier == "alt";
        combination.remove_prefix(plus + 1);
    }
    app::InputEvent event = key_event(combination, true);
    event.control = control;
    event.shift = shift;
    event.alt = alt;
    bool consumed = console.handle(event);
    event.kind = app::EventKind::key_released;
    console.handle(event);
    return consumed;
}

bool Rig::press(std::string_view name) {
    return console.handle(key_event(name, true));
}
bool Rig::release(std::string_view name) {
    return console.handle(key_event(name, false));
}

bool Rig::character(char32_t character) {
    app::InputEvent event;
    event.kind = app::EventKind::text;
    event.character = character;
    return console.handle(event);
}

void Rig::type(std::string_view text) {
    for (char c : text) {
        std::string name(1, static_cast<char>(std::tolower(c)));
        press(name);
        character(static_cast<char32_t>(c));
        release(name);
    }
}

bool Rig::move(float x, float y) {
    app::InputEvent event;
    event.kind = app::EventKind::mouse_moved;
    event.x = x;
    event.y = y;
    return console.handle(event);
}

bool Rig::button(bool pressed, float x, float y, std::string_view name) {
    app::InputEvent event;
    event.kind = pressed ? app::EventKind::mouse_pressed : app::EventKind::mouse_released;
    event.name = name;
    event.x = x;
    event.y = y;
    return console.handle(event);
}

void Rig::click(float x, float y) {
    move(x, y);
    button(true, x, y);
    button(false, x, y);
}

void Rig::drag(float from_x, float from_y, float to_x, float to_y) {
    move(from_x, from_y);
    button(true, from_x, from_y);
    for (int i = 1; i <= 8; ++i) {
        float share = static_cast<float>(i) / 8;
        move(from_x + (to_x - from_x) * share, from_y + (to_y - from_y) * share);
        draw();
    }
    button(false, to_x, to_y);
}

void Rig::draw(int frames) {
    for (; frames > 0; --frames) {
        tree.barrier();
        if (tweaks) tweaks->barrier();
        surface.clear();
        console.draw(surface, 1.0 / 60);
    }
}

std::string Rig::log_text() {
    std::string text;
    for (const LogLine& line : state().log.lines()) text += line.text + "\n";
    return text;
}

ImVec2 Rig::widget(std::string_view name, float share_x) {
    Handle selected = console.selected();
    const Property& property = tree.property(selected, name);
    state().inspector.select(selected, std::string(name));
    draw(3);
    Rect rect = state().inspector.editor().widget_rect(property);
    return ImVec2(rect.low.x + (rect.high.x - rect.low.x) * share_x, rect.middle().y);
}

void Rig::save(const std::string& name) {
    draw();
    surface.save(std::filesystem::path(FETTLE_CONSOLE_PICTURES) / (name + ".ppm"));
}

}  // namespace fettle::console::test
