#include <algorithm>

#include <observed/last_value.h>
#include <settings/settings.h>

#include <fettle/app/input.h>

namespace fettle::console {

using property::Handle;
using property::Property;
using property::Range;
using property::Type;
using property::Value;

namespace {

Property flag_property(const char* name, bool value, const char* doc) {
    Property property;
    property.name = name;
    property.type = Type::boolean;
    property.default_value = Value(value);
    property.doc = doc;
    property.transient = true;
    return property;
}

Property number_property(const char* name, double value, Range range, const char* unit,
                         const char* doc) {
    Property property;
    property.name = name;
    property.type = Type::number;
    property.default_value = Value(value);
    property.range = range;
    property.unit = unit;
    property.doc = doc;
    property.transient = true;
    return property;
}

/// Whether a key that opens the console would take a character from the commands that are typed, or
/// the key that edits them.
bool is_needed_to_type(std::string_view key) {
    constexpr std::string_view needed[] = {
        "space",        "enter",     "escape",    "tab",           "backspace",    "delete",
        "left",         "right",     "up",        "down",          "home",         "end",
        "page_up",      "page_down", "minus",     "equal",         "comma",        "period",
        "left_bracket", "slash",     "semicolon", "right_bracket", "backslash",    "apostrophe",
        "left_shift",   "left_alt",  "right_alt", "right_shift",   "left_control", "right_control"};
    return key.size() == 1 || key.starts_with("numpad_") ||
           std::ranges::find(needed, key) != std::ranges::end(needed);
}

property::ClassDescriptor console_class() {
    property::ClassDescriptor descriptor;
    descriptor.name = "Console";
    descriptor.stem = "console";
    descriptor.creatable = false;
    descriptor.snapshots = property::Snapshots::never;
    descriptor.doc = "The in-game console and inspector.";
    auto& list = descriptor.properties;
    list.push_back(flag_property("open", false, "Whether the console is shown."));
    list.push_back(
        flag_property("pauses", false, "Whether time stands still while the console is open."));
    list.push_back(flag_property("inspector", true, "Whether the inspector is shown with it."));
    list.push_back(flag_property("time_bar", true,
                                 "Whether the time bar is shown with it: pause, step, back."));
    list.push_back(
        flag_property("tweaks", false, "Whether tweaks are listed in place of the log."));
    list.push_back(flag_property(
        "picks", true,
        "Whether a click on a body, a picture or a widget selects it while the console is open."));
    list.push_back(flag_property(
        "listen", false,
        "Whether `fettle repl --attach` may attach to this game: only this user, on this computer, "
        "with the token in the user's runtime folder."));
    list.push_back(flag_property(
        "overlays", false, "Whether the overlays of `view.show` are shown as a row of buttons."));
    list.push_back(flag_property("ghosts", true,
                                 "Whether edits of a game that is paused show what would move, and "
                                 "where, as far as the physics says."));
    list.push_back(
        number_property("ghost_time", 2, {0.1, 10}, "s", "How far these ghosts look ahead."));
    list.push_back(number_property("font_size", 15, {8, 48}, "px", "Height of the text."));
    list.push_back(number_property(
        "scale", 1, {0.5, 4}, "",
        "Factor of the size of the text, and of what is measured by it, as far as the "
        "window is wide enough."));
    list.push_back(number_property("height", 0.45, {0.15, 1}, "",
                                   "Height of the console as a share of the window."));
    list.push_back(number_property("inspector_width", 420, {200, 2000}, "px",
                                   "Width of the inspector at a scale of 1."));
    list.push_back(number_property("plot_height", 0, {0, 4000}, "px",
                                   "Height of the curves of a plot at a scale of 1, as far as the "
                                   "window has room; 0: a height that fits the window."));
    list.push_back(number_property(
        "memory_limit", 256, {1, 1e6}, "MB",
        "How much memory one command may add, by Lua's values and by what it makes in the tree; a "
        "command that needs more is stopped."));
    list.push_back(number_property("opacity", 1, {0.3, 1}, "",
                                   "Of the background. Below 1 the game is seen behind the text."));
    Property filter;
    filter.name = "filter";
    filter.type = Type::text;
    filter.default_value = Value("");
    filter.transient = true;
    filter.doc = "Only lines of the log that contain this text are shown; \"\" shows all.";
    list.push_back(filter);
    Property key;
    key.name = "key";
    key.type = Type::text;
    key.default_value = Value("grave");
    key.transient = true;
    key.doc =
        "The key that opens and closes the console, by its name in the class Keys. Keys with which "
        "commands are typed and edited, such as \"b\" and \"enter\", cannot be it.";
    for (const std::string_view name : app::key_names())
        if (!is_needed_to_type(name)) key.enumerators.emplace_back(name);
    list.push_back(key);
    return descriptor;
}

}  // namespace

Settings::Settings(property::Tree& tree) : tree_(tree) {
    if (tree_.find_class("Console") == nullptr) tree_.define(console_class());
    instance();
}

Settings::~Settings() {
    if (tree_.alive(instance_)) tree_.destroy(instance_);
}

Handle Settings::instance() {
    if (!tree_.alive(instance_)) {
        bool taken = static_cast<bool>(tree_.child(tree_.root(), "console"));
        instance_ = tree_.create(tree_.class_named("Console"), tree_.root(),
                                 taken ? std::string_view() : std::string_view("console"));
    }
    return instance_;
}

Value Settings::value(std::string_view name) {
    const Handle console = instance();
    return last_value(tree_, console, tree_.property(console, name));
}

bool Settings::flag(std::string_view name) {
    return value(name).boolean();
}

float Settings::number(std::string_view name) {
    return static_cast<float>(value(name).number());
}

std::string Settings::text(std::string_view name) {
    return value(name).text();
}

std::string Settings::shown_key() {
    const std::string key = text("key");
    return key == "grave" ? "`" : key;
}

void Settings::set(std::string_view name, const Value& value) {
    property::Tree::CauseScope cause(tree_,
                                     property::Writer::module);  // no edits for undo
    tree_.set(instance(), name, value);
}

}  // namespace fettle::console
