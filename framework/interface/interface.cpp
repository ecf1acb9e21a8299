#include <fettle/interface/interface.h>

#include <bit>
#include <stdexcept>
#include <utility>

#include <fettle/property/ended_class.h>

#include <binding/binding.h>
#include <drawing/picture.h>
#include <interaction/player.h>
#include <layout/layout.h>
#include <widgets/widgets.h>

namespace fettle::interface {

using property::Vec2;

struct Interface::State {
    explicit State(property::Media& media)
        : layout(widgets, media),
          binding(widgets, preferences),
          player(widgets, layout, binding),
          picture(widgets, layout, binding, player) {
        widgets.callbacks = {
            .lay_out =
                [this] {
                    if (!framed) player.begin_on(screen_of_view());
                    player.lay_out();
                },
            .hovered = [this](property::Row row) { return player.hovered() == &widgets[row]; },
            .placed = [this](Widget& widget) { binding.begin(widget); }};
    }
    /// A script may ask where a widget is before the first frame.
    Vec2 screen_of_view() const {
        const property::Handle view = tree->child(tree->root(), "view");
        const property::Property* const size = view ? tree->find(view, "screen") : nullptr;
        const property::Value value = size != nullptr ? tree->peek(view, *size) : property::Value();
        return value.is(property::Type::vec2) ? value.vec2() : screen;
    }
    void follow_preferences() {
        if (!preferences.differs()) return;
        preferences.restore_changed();
        binding.follow_properties();
    }
    Widgets widgets;
    Preferences preferences;
    Layout layout;
    Binding binding;
    Player player;
    Picture picture;
    Vec2 screen{1280, 720};
    bool framed = false;
    property::Tree* tree = nullptr;
    std::weak_ptr<const property::Tree*> tree_life;
    property::ScopedConnection restored;
};

namespace {

std::function<std::string()>& place() {
    static std::function<std::string()> where = [] { return std::string("interface"); };
    return where;
}

property::Method prefer_method(Preferences& preferences) {
    using property::Type;
    using property::Value;
    return {.name = "prefer",
            .parameters = {{.name = "path",
                            .type = Type::text,
                            .doc = "Path of the property, such as \"input.actions.jump\"."},
                           {.name = "value",
                            .type = Type::nil,
                            .doc = "What the player has chosen; nil ends the preference, and the "
                                   "game decides about the value again."}},
            .required = 1,
            .doc =
                "Writes a property as a setting of the player: no rewind and no saved game "
                "changes it, and later runs begin with it. A widget that is bound to a property "
                "of audio or input.actions does so by itself.",
            .context = &preferences,
            .call = [](void* context, property::Tree&, property::Handle, property::Row,
                       std::span<const Value> arguments) -> property::Result {
                static_cast<Preferences*>(context)->prefer(arguments[0].text(), arguments[1]);
                return Value();
            },
            .effect = property::Effect::tree};
}

property::Method widget_at_method(Player& player) {
    using property::Type;
    using property::Value;
    return {.name = "widget_at",
            .parameters = {{.name = "point",
                            .type = Type::vec2,
                            .unit = "px",
                            .doc = "From the top left corner of the screen."}},
            .required = 1,
            .returns = {{.name = "widget",
                         .type = Type::reference,
                         .doc = "The widget; nil if there is none.",
                         .reference_class = "Widget",
                         .nullable = true}},
            .doc =
                "The widget that is seen at a point of the screen, the foremost of several. Rows, "
                "columns and the like without a color of their own are not seen.",
            .context = &player,
            .call = [](void* context, property::Tree&, property::Handle, property::Row,
                       std::span<const Value> arguments) -> property::Result {
                const Widget* const found =
                    static_cast<Player*>(context)->seen_at(arguments[0].vec2());
                return found != nullptr ? Value(found->self) : Value();
            },
            .effect = property::Effect::nothing};
}

/// The properties and methods of the instance `interface` for preferences and for the mouse.
ServiceParts service_parts(Preferences& preferences, Player& player) {
    return {.properties = {{.name = Preferences::saved_name,
                            .type = property::Type::list,
                            .default_value = property::List{},
                            .doc = "The settings of the player at this moment: lists of a path "
                                   "and a value. interface:prefer changes them.",
                            .hidden = true}},
            .methods = {prefer_method(preferences), widget_at_method(player)}};
}

}  // namespace

Interface::Interface(property::Media& media) : state_(std::make_unique<State>(media)) {}

// The tree may outlive the interface, so its classes, which read the memory of this object, end.
Interface::~Interface() {
    if (state_->tree_life.expired()) return;
    state_->widgets.callbacks = {};
    for (const char* name : {"Widget", "Theme", "Interface"})
        property::end_class(*state_->tree, state_->tree->class_named(name));
}

void Interface::attach(property::Tree& tree) {
    if (state_->tree != nullptr)
        throw std::logic_error("the interface is attached to a tree already");
    state_->tree = &tree;
    state_->widgets.define(tree, service_parts(state_->preferences, state_->player));
    state_->preferences.attach(tree, state_->widgets.service());
    state_->tree_life = tree.lifetime();
    // Before the next picture and the next sound. `frame` does the rest.
    state_->restored = tree.on(tree.root(), *tree.class_of(tree.root()).event("restored"),
                               [this](const property::Occurrence&) {
                                   const property::Tree::CauseScope cause(
                                       *state_->tree, property::Writer::module, &place());
                                   state_->follow_preferences();
                               });
}

void Interface::step(double) {}

void Interface::report(property::Tree&) {
    state_->binding.update_all();
}

/// The hash of everything that the player can change.
std::uint64_t Interface::hash() const {
    if (state_->tree_life.expired()) return 0;
    std::uint64_t hash = 0;
    const auto add = [&hash](std::uint64_t bits) { hash = (hash ^ bits) * 0x9e3779b97f4a7c15u; };
    const auto add_text = [&add](const std::string& text) {
        for (const char c : text) add(static_cast<unsigned char>(c));
    };
    // In the order of the tree and by paths: after a restore, widgets may be in other rows, and
    // those that are made again have other handles.
    property::Tree& tree = *state_->tree;
    const property::Class& of = tree.class_named("Widget");
    tree.each_below(tree.root(), [&](property::Handle instance) {
        if (!tree.class_of(instance).is_a(of)) return;
        const Widget& widget = state_->widgets[tree.row(instance)];
        add(std::bit_cast<std::uint64_t>(widget.content.value));
        add(std::bit_cast<std::uint64_t>(widget.content.scroll));
        add(static_cast<std::uint64_t>(widget.content.caret));
        add(static_cast<std::uint64_t>(widget.content.mark.value_or(-1)));
        add(static_cast<std::uint64_t>(widget.content.selected));
        add((widget.content.on ? 1u : 0u) | (widget.visible ? 2u : 0u) |
            (widget.disabled ? 4u : 0u) | (widget.content.listening ? 8u : 0u));
        add_text(widget.content.text);
    });
    const Board& board = state_->widgets.board;
    for (const property::Handle each : {board.focus, board.held})
        if (tree.alive(each)) add_text(tree.path(each));
    return hash;
}

void Interface::on_problem(std::function<void(const std::string&)> listener) {
    state_->preferences.on_problem(listener);
    state_->binding.on_problem(std::move(listener));
}

void Interface::on_preference(
    std::function<void(const std::string&, const property::Value&)> keep) {
    state_->preferences.on_change(std::move(keep));
}

void Interface::begin_with(const std::string& path, const property::Value& value) {
    state_->preferences.begin_with(path, value);
}

bool Interface::takes(const app::Act& act) const {
    return !state_->tree_life.expired() && state_->player.takes(act);
}

void Interface::handle(const app::Act& act, bool taken) {
    if (state_->tree_life.expired()) return;
    const property::Tree::CauseScope cause(*state_->tree, property::Writer::module, &place());
    state_->player.handle(act, taken);
}

void Interface::frame(const Vec2& mouse, const Vec2& screen, double seconds) {
    if (state_->tree_life.expired()) return;
    const property::Tree::CauseScope cause(*state_->tree, property::Writer::module, &place());
    state_->screen = screen;
    state_->framed = true;
    state_->follow_preferences();
    state_->player.frame(mouse, screen, seconds);
    state_->picture.advance(seconds);
}

void Interface::draw(property::Painter& painter) {
    if (state_->tree_life.expired()) return;
    state_->player.lay_out();
    state_->picture.draw(painter, state_->screen);
}

std::uint64_t Interface::layouts() const {
    return state_->layout.count();
}

}  // namespace fettle::interface
