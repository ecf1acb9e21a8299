#pragma once
// The classes of widgets, and the instance `interface`.

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/module/rows.h>

#include <themes/themes.h>
#include <widgets/widget.h>

namespace fettle::interface {

/// The values of the instance `interface`.
struct Board {
    double scale = 0;
    property::Handle focus{}, held{};
    property::Handle focus_beneath{};  // what had the keyboard before a modal widget took it
    bool focus_shown = true;
};

/// Members that other folders add to the instance `interface`.
struct ServiceParts {
    std::vector<property::Property> properties{};
    std::vector<property::Method> methods{};
};

class Widgets {
  public:
    using Element = Widget;
    /// Functions of the layout and of the player's actions, which properties and methods of widgets
    /// call. Empty before the interface is attached and after its end.
    struct Callbacks {
        std::function<void()> lay_out;  // arranges the widgets if `stale`
        std::function<bool(property::Row)> hovered;
        std::function<void(Widget&)> placed;  // it got a parent
    };

    void define(property::Tree& tree, ServiceParts more);
    property::Tree& tree() const { return *tree_; }

    Widget& operator[](property::Row row) { return rows_[row]; }
    const Widget& operator[](property::Row row) const { return rows_[row]; }
    auto begin() { return rows_.begin(); }
    auto end() { return rows_.end(); }
    bool is_widget(property::Handle instance) const;
    /// The widget with this handle; null if there is none.
    Widget* find(property::Handle instance);
    void changed(property::Row) { stale = true; }
    /// Writes a property of a widget that the player uses; no effect if the widget was deleted.
    void set(property::Handle widget, const char* name, const property::Value& value);
    /// Selects the whole text of a text field, so that what the player types takes its place.
    void select_text(const Widget& field);
    void emit(const Widget& widget, const char* event, std::vector<property::Value> values = {});

    property::Handle service() const { return service_; }
    const property::Class& base() const { return *base_; }

    Themes themes;
    Board board;
    bool stale = true;  // the layout
    bool moved = true;  // widgets were created, moved or deleted since the layout noted their order
    double scale = 1;   // px of the screen for one px of the layout
    Callbacks callbacks;

  private:
    property::ClassDescriptor base_descriptor();
    void define_service(ServiceParts more);

    property::Tree* tree_ = nullptr;
    const property::Class* base_ = nullptr;
    property::Handle service_{};
    module::Rows<Widget, std::deque> rows_;
};

}  // namespace fettle::interface
