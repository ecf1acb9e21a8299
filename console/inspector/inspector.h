#pragma once
// The inspector: every instance of the tree, and every property of the one that is selected.

#include <imgui.h>

#include <functional>
#include <string>

#include <fettle/property/tree.h>

#include <inspector/instance_tree.h>
#include <inspector/property_editor.h>

namespace fettle::console {

class Inspector {
  public:
    explicit Inspector(property::Tree& tree);

    /// The user chose another instance here.
    std::function<void(property::Handle)> chosen;
    /// A piece of a command: the name of a method that was clicked.
    std::function<void(const std::string&)> insert;

    property::Handle selected() const { return selected_; }
    /// Shows this one, unfolding the outline down to it. `property`: its name, to scroll to.
    void select(property::Handle instance, const std::string& property = {});

    /// Fills the current window.
    void draw(ImFont* bold);
    bool about_to_type() const { return editor_.about_to_type(); }
    PropertyEditor& editor() { return editor_; }

  private:
    void draw_outline(float height);
    void draw_outline_row(const InstanceTree::Row& row);
    void draw_splitter();
    void draw_header(ImFont* bold);
    void draw_properties(ImFont* bold);
    void draw_methods();
    void draw_children();
    bool group(const std::string& title, bool open, ImFont* bold);
    void choose(property::Handle instance);

    property::Tree& tree_;
    InstanceTree outline_;
    PropertyEditor editor_;
    std::string search_;
    property::Handle selected_;
    std::string last_path_;  // of the selected one, to say what was deleted
    std::string scroll_to_property_;
    bool scroll_to_selected_ = false;
    float outline_share_ = 0.36f;
};

}  // namespace fettle::console
