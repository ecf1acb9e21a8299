#pragma once
// The menu of the right mouse button on a property, an instance, or a path.

#include <imgui.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/path.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/property/tree.h>

#include <look/rect.h>

namespace fettle::console {

class ContextMenu {
  public:
    explicit ContextMenu(const property::Tree& tree) : tree_(tree) {}

    /// Runs a command as if it were typed.
    std::function<void(const std::string& command)> run;
    /// Selects all instances of the class.
    std::function<void(const property::Class&)> select_class;
    /// Puts a text into the prompt; into the clipboard.
    std::function<void(const std::string&text)> insert, copy;

    /// The text with which the value of that path was pinned; "" if it is not.
    std::function<std::string(const std::string& path)> pinned;
    /// The text of the break that waits for a change of that value; "" if there is none.
    std::function<std::string(const std::string& path)> breaks;

    /// Begins typing a formula of that property. False if it cannot be typed there.
    std::function<bool(const property::Place&)> begin_formula;

    /// Null: nothing can be kept for all instances of a scene file.
    const property::Tweaks* tweaks = nullptr;

    /// Opens the menu of that path in the next frame, at the mouse.
    void open(std::string path) {
        path_ = std::move(path);
        opens_ = true;
    }
    /// Must be called once per frame, outside of all windows.
    void draw();
    /// The rectangle of an entry in the last frame; for tests.
    Rect entry(std::string_view label) const;

  private:
    bool item(const char* label, const char* tip);
    /// `pin` and `unpin` are the labels; the entry depends on whether the value is pinned.
    void pin_item(const char* pin, const char* unpin, const std::string& path);
    /// The same for a break.
    void break_item(const char* label, const char* tip, const std::string& path);
    /// `tip`: of the first of the entries.
    void keep_items(const char* tip, property::Handle instance, const std::string& path);
    void draw_value(const property::Place& place);
    void draw_instance(property::Handle instance);

    const property::Tree& tree_;
    std::string path_;
    bool opens_ = false;
    std::vector<std::pair<std::string, Rect>> drawn_;
};

}  // namespace fettle::console
