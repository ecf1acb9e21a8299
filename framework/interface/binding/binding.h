#pragma once
// Widgets that have the value of a property, and properties that have the value of a widget.

#include <functional>
#include <string>

#include <fettle/property/path.h>

#include <binding/preferences.h>
#include <widgets/widgets.h>

namespace fettle::interface {

class Binding {
  public:
    Binding(Widgets& widgets, Preferences& preferences)
        : widgets_(widgets), preferences_(preferences) {}
    void on_problem(std::function<void(const std::string&)> listener) {
        report_ = std::move(listener);
    }

    /// The side that has changed since the last call gives the other one its value; if both have,
    /// the property does.
    void update(Widget& widget);
    void update_all();
    /// To be called when the widget got a parent: until the first update, which follows at the end
    /// of the step, it shows the value of the property.
    void begin(Widget& widget) const;
    /// Until the next update, the property of each widget counts as changed.
    void follow_properties();
    /// The values at the left and the right end of a slider or progress bar; the left one may be
    /// the greater one.
    property::Range range(const Widget& widget) const;
    /// The distance between two values that the player can choose; 0: any.
    double step(const Widget& widget) const;
    /// A key or button that the player has chosen for the action that the widget is bound to. It
    /// takes the place of those on the same kind of device.
    void choose(Widget& widget, const std::string& name);

  private:
    property::Place place_of(const Widget& widget) const;
    property::Value shown(const Widget& widget, const property::Value& target) const;
    property::Value wanted(const Widget& widget, const property::Place& place,
                           const property::Value& own) const;
    void write(const property::Place& place, const property::Value& value);
    void report(Widget& widget, const std::string& why);

    Widgets& widgets_;
    Preferences& preferences_;
    std::function<void(const std::string&)> report_;
};

}  // namespace fettle::interface
