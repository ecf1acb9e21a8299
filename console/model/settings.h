#pragma once
// The console's own properties: the instance `console` under `game`.

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

namespace fettle::console {

class Settings {
  public:
    /// Defines the class `Console` unless the tree has it, and creates the instance.
    explicit Settings(property::Tree& tree);
    ~Settings();
    Settings(const Settings&) = delete;

    bool flag(std::string_view name);
    float number(std::string_view name);
    std::string text(std::string_view name);
    /// Written as an edit by the console.
    void set(std::string_view name, const property::Value& value);

  private:
    /// The instance; created again after it was deleted.
    property::Handle instance();

    property::Tree& tree_;
    property::Handle instance_;
};

}  // namespace fettle::console
