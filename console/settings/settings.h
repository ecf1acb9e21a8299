#pragma once
// Settings of the console: the properties of the instance `console` under `game`.

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

namespace fettle::console {

class Settings {
  public:
    /// Defines the class `Console` if the tree does not have it, and creates the instance.
    explicit Settings(property::Tree& tree);
    ~Settings();
    Settings(const Settings&) = delete;

    bool flag(std::string_view name);
    float number(std::string_view name);
    std::string text(std::string_view name);
    /// The key that opens the console, as the player sees it: "`" for the grave key.
    std::string shown_key();
    /// Writes a setting. Undo does not revert it, because it is not an edit by a person.
    void set(std::string_view name, const property::Value& value);

  private:
    property::Value value(std::string_view name);
    /// The instance; it is created again if it was deleted.
    property::Handle instance();

    property::Tree& tree_;
    property::Handle instance_;
};

}  // namespace fettle::console
