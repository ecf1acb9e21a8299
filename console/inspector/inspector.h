#pragma once
// The inspector: an outline of all instances, and all properties of the selected instance.

#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <editing/property_editor.h>
#include <inspector/instance_tree.h>
#include <inspector/selection.h>
#include <look/rect.h>

namespace fettle::console {

/// Whether the game has defined the class.
using OfGame = std::function<bool(const property::Class&)>;

/// The properties of each class together: a class may have another default for a property of its
/// base, and then owns it. First those of the game's own classes, the derived ones before their
/// bases; then the others, base classes first. Ad hoc properties are at the end, by name.
std::vector<const property::Property*> grouped_by_class(
    std::vector<const property::Property*> properties, const OfGame& is_of_game = {});

class Inspector {
  public:
    explicit Inspector(property::Tree& tree);

    /// Optional; see `grouped_by_class`.
    OfGame is_of_game;
    /// Called when the user chooses another instance in the inspector; a null handle: none.
    std::function<void(property::Handle)> chosen;
    /// Called with the name of a clicked method, to be inserted into the command.
    std::function<void(const std::string&)> insert;
    /// Called with the path of an instance that was clicked with the right button.
    std::function<void(const std::string& path)> menu;

    property::Handle selected() const { return selection_.last(); }
    const InstanceTree& outline() const { return outline_; }
    /// All selected instances that are alive; `selected` is the last one.
    std::vector<property::Handle> selection() const { return selection_.all(); }
    /// The same without a copy; its `others` may contain deleted instances.
    const Selection& selected_instances() const { return selection_; }
    /// Adds the instance to the selection, or takes it out of it.
    void toggle(property::Handle instance);
    void deselect();
    /// Selects all of them; the last one is `selected`.
    void select(const std::vector<property::Handle>& instances);
    /// Called with commands for all selected instances.
    std::function<void(const std::string& command)> run;
    /// Called when more instances are selected than can be deleted or copied by one command.
    std::function<void(const std::string& problem)> report;
    /// Deletes, or copies, all selected instances.
    void delete_selection();
    void clone_selection();
    /// Selects the instance and unfolds the outline down to it. `property`: name of the property to
    /// scroll to.
    void select(property::Handle instance, const std::string& property = {});

    /// Scrolls to a property of the selected instance.
    void show(const property::Property& property) { scroll_to_property_ = property.name; }

    /// Draws into the current ImGui window. `left_out`: how much higher the window is with a
    /// selection, in pixels.
    void draw(ImFont* bold, float left_out = 0);
    /// The same with either the tree or the properties, in turn, where there is no room for both.
    void draw_in_turn(ImFont* bold);
    /// The button of `draw_in_turn`; for tests.
    const Rect& turn_button() const { return turn_rect_; }
    /// The height that the search, the tree and a hint need in a window whose height is `whole`
    /// with a selection: the tree stays as it is when something is selected.
    float height_without_selection(float whole) const;
    bool about_to_type() const { return frames_to_search_ > 0 || editor_.about_to_type(); }
    /// The search field gets the keyboard in the next frames.
    void begin_search() { frames_to_search_ = 4; }
    /// The search field does not get the keyboard any more, if it has not got it yet: the inspector
    /// has no room.
    void give_up_search() { frames_to_search_ = 0; }
    /// The instance whose row is under the mouse, or was reached with the arrow keys.
    property::Handle pointed() const { return tree_.alive(focused_row_) ? focused_row_ : pointed_; }
    /// Tab goes from the search to the properties, and from field to field. Returns false if the
    /// inspector does not have the keyboard.
    bool tab(bool back);
    PropertyEditor& editor() { return editor_; }

  private:
    void follow_selected();
    /// `right_free`: the width that stays free at the right of the first row, in pixels.
    void draw_search(float right_free = 0);
    void draw_problem();
    void draw_selected(ImFont* bold, float right_free = 0);
    void move_through_rows();
    void choose_focused_row();
    void draw_outline(float height);
    void draw_outline_row(const InstanceTree::Row& row);
    void draw_splitter();
    void draw_header(ImFont* bold, float right_free);
    void draw_several(ImFont* bold, float right_free);
    void run_for_all(const std::string& command, const char* what);
    bool all_have(const property::Property& property) const;
    void draw_properties(ImFont* bold);
    void draw_methods();
    void draw_children();
    bool group(const std::string& title, bool open, ImFont* bold);
    void choose(property::Handle instance);

    property::Tree& tree_;
    InstanceTree outline_;
    PropertyEditor editor_;
    std::string search_;
    Selection selection_;
    std::string last_path_;  // path of the selected instance; shown when it is deleted
    std::string scroll_to_property_;
    bool scroll_to_selected_ = false;
    int frames_to_search_ = 0;
    Rect turn_rect_;
    bool tree_in_turn_ = false;     // `draw_in_turn` shows the tree
    bool searches_ = false;         // the search field has the keyboard
    property::Handle focused_row_;  // the row that the arrow keys have reached
    property::Handle pointed_;      // the row under the mouse
    float outline_height_ = 0;      // px, in the last frame
    float outline_share_ = 0.36f;
};

}  // namespace fettle::console
