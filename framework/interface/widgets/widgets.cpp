#include <widgets/widgets.h>

#include <array>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/utf8.h>

#include <themes/fields.h>
#include <widgets/classes.h>
#include <widgets/groups.h>

namespace fettle::interface {

using property::accessor;
using property::Handle;
using property::Property;
using property::Row;
using property::Type;
using property::Value;

namespace {

/// The kinds of the classes that are defined, for instances of classes that derive from them.
Kind kind_of(const property::Class& of) {
    constexpr std::array<std::pair<const char*, Kind>, 11> kinds{
        {{"Panel", Kind::panel},
         {"Row", Kind::row},
         {"Column", Kind::column},
         {"List", Kind::list},
         {"Button", Kind::button},
         {"Label", Kind::label},
         {"Image", Kind::image},
         {"Slider", Kind::slider},
         {"Toggle", Kind::toggle},
         {"TextField", Kind::text_field},
         {"ProgressBar", Kind::progress_bar}}};
    for (const property::Class* each = &of; each != nullptr; each = each->base())
        for (const auto& [name, kind] : kinds)
            if (each->name() == name) return kind;
    return Kind::panel;
}

/// Values that the class has by default, where they are not those of other classes.
void set_defaults(Widget& w) {
    if (w.kind == Kind::row) w.placing.align = "center";
    if (w.kind == Kind::button || w.kind == Kind::progress_bar) w.style.text_align = "center";
    if (w.kind == Kind::label) w.style.overflow = "wrap";
}

property::Method focus_method(Widgets& widgets) {
    return {.name = "focus",
            .doc = "Gives it the keyboard. The text of a text field is selected then.",
            .context = &widgets,
            .call = [](void* context, property::Tree& tree, Handle self, Row,
                       std::span<const Value>) -> property::Result {
                auto& w = *static_cast<Widgets*>(context);
                if (!tree.alive(w.service())) return Value();
                if (const Widget* const widget = w.find(self);
                    widget != nullptr && widget->kind == Kind::text_field && w.board.focus != self)
                    w.select_text(*widget);
                tree.set(w.service(), "focus", Value(self));
                return Value();
            },
            .effect = property::Effect::tree};
}

}  // namespace

property::ClassDescriptor Widgets::base_descriptor() {
    property::ClassDescriptor described{
        .name = "Widget",
        .doc =
            "What panels, buttons and all other parts of menus have in common. They are on the "
            "screen, over everything else, in pixels of the layout, which interface.scale makes "
            "larger on large screens.",
        .creatable = false,
        .properties = common_properties(*this),
        .methods = {focus_method(*this)},
        .weight = 1200};
    described.lifecycle.context = this;
    described.lifecycle.create = [](void* context, property::Tree& tree, Handle self) {
        auto& w = *static_cast<Widgets*>(context);
        const Row row = w.rows_.add(self);
        w[row].kind = kind_of(tree.class_of(self));
        set_defaults(w[row]);
        w.stale = w.moved = true;
        return row;
    };
    described.lifecycle.place = [](void* context, property::Tree&, Handle, Row row) {
        auto& w = *static_cast<Widgets*>(context);
        w.stale = w.moved = true;
        if (w.callbacks.placed) w.callbacks.placed(w[row]);
        return row;
    };
    described.lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        auto& w = *static_cast<Widgets*>(context);
        w.rows_.remove(row);
        w.stale = w.moved = true;
    };
    return described;
}

void Widgets::define(property::Tree& tree, ServiceParts more) {
    tree_ = &tree;
    themes.define(tree);
    themes.on_change([this] { stale = true; });
    base_ = &tree.define(base_descriptor());
    for (auto list : {container_classes(*this), control_classes(*this)})
        for (property::ClassDescriptor& each : list) tree.define(std::move(each));
    define_service(std::move(more));
}

void Widgets::define_service(ServiceParts more) {
    const auto of_board = [this](Property described, auto get, auto set) {
        described.binding = accessor(*this, get, set);
        return described;
    };
    property::ClassDescriptor described{
        .name = "Interface",
        .doc = "What all widgets have in common.",
        .creatable = false,
        .properties =
            {of_board(
                 {.name = "scale",
                  .type = Type::number,
                  .default_value = 0.0,
                  .range = {0, 16},
                  .doc =
                      "Pixels of the screen for one of the layout; 0: such that the shorter side "
                      "of the screen is 720 long."},
                 [](Widgets& w, Row) { return Value(w.board.scale); },
                 [](Widgets& w, Row, const Value& v) {
                     w.board.scale = v.as_double();
                     w.stale = true;
                 }),
             of_board(
                 {.name = "focus",
                  .type = Type::reference,
                  .doc = "The widget that has the keyboard; nil: none.",
                  .reference_class = "Widget"},
                 [](Widgets& w, Row) { return Value(w.board.focus); },
                 [](Widgets& w, Row, const Value& v) { assign(w.board.focus, v); }),
             of_board(
                 {.name = "focus_shown",
                  .type = Type::boolean,
                  .default_value = true,
                  .doc = "Whether that widget has a ring: after a key or a gamepad's button, not "
                         "after a click."},
                 [](Widgets& w, Row) { return Value(w.board.focus_shown); },
                 [](Widgets& w, Row, const Value& v) { assign(w.board.focus_shown, v); }),
             of_board(
                 {.name = "focus_beneath",
                  .type = Type::reference,
                  .doc = "The widget that had the keyboard before a modal one took it.",
                  .hidden = true,
                  .reference_class = "Widget"},
                 [](Widgets& w, Row) { return Value(w.board.focus_beneath); },
                 [](Widgets& w, Row, const Value& v) { assign(w.board.focus_beneath, v); }),
             of_board(
                 {.name = "held",
                  .type = Type::reference,
                  .doc = "The widget that the player holds down; nil: none.",
                  .reference_class = "Widget"},
                 [](Widgets& w, Row) { return Value(w.board.held); },
                 [](Widgets& w, Row, const Value& v) { assign(w.board.held, v); })},
        .methods = std::move(more.methods)};
    for (Property& each : more.properties) described.properties.push_back(std::move(each));
    service_ = tree_->create(tree_->define(std::move(described)), tree_->root(), "interface");
    tree_->create(themes.of(), service_, "theme");
}

bool Widgets::is_widget(Handle instance) const {
    return instance && tree_->alive(instance) && tree_->class_of(instance).is_a(*base_);
}

Widget* Widgets::find(Handle instance) {
    return is_widget(instance) ? &rows_[tree_->row(instance)] : nullptr;
}

void Widgets::set(Handle widget, const char* name, const Value& value) {
    if (tree_->alive(widget)) tree_->set(widget, name, value);
}

void Widgets::select_text(const Widget& field) {
    const auto length = static_cast<std::int64_t>(property::code_point_count(field.content.text));
    const Handle self = field.self;
    set(self, "caret", Value(length));
    set(self, "mark", length > 0 ? Value(std::int64_t{0}) : Value());
}

void Widgets::emit(const Widget& widget, const char* event, std::vector<Value> values) {
    const property::Event* const known = tree_->class_of(widget.self).event(event);
    if (known != nullptr && tree_->listens(widget.self, *known))
        tree_->emit(widget.self, *known, std::move(values));
}

}  // namespace fettle::interface
