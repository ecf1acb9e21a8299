#include <in_game/context_menu.h>

#include <look/theme.h>
#include <text/utf8.h>

namespace fettle::console {

using property::Type;

namespace {

constexpr const char* menu_name = "##context";

bool can_be_plotted(const property::Property& property) {
    return property.type == Type::number || property.type == Type::integer ||
           property.type == Type::vec2 || property.type == Type::boolean || property.any_type;
}

}  // namespace

bool ContextMenu::item(const char* label, const char* tip) {
    const bool chosen = ImGui::MenuItem(label);
    drawn_.emplace_back(label, item_rect());
    if (ImGui::IsItemHovered()) show_tip_beside(tip);
    return chosen;
}

void ContextMenu::pin_item(const char* pin, const char* unpin, const std::string& path) {
    const std::string text = pinned ? pinned(path) : std::string();
    if (text.empty()) {
        if (item(pin, "Adds it to the watch list")) run("pin " + path);
    } else if (item(unpin, "Takes it out of the watch list")) {
        run("unpin(" + lua_string(text) + ")");
    }
}

void ContextMenu::break_item(const char* label, const char* tip, const std::string& path) {
    const std::string text = breaks ? breaks(path) : std::string();
    if (text.empty()) {
        if (item(label, tip)) run("break_when " + path);
    } else if (item("No break any more", "Ends the break on this value")) {
        run("unbreak(" + lua_string(text) + ")");
    }
}

void ContextMenu::keep_items(const char* tip, property::Handle instance, const std::string& path) {
    if (item("Keep", tip)) run("keep(" + lua_string(path) + ")");
    const std::size_t others = tweaks == nullptr ? 0 : tweaks->others_of_scene(instance);
    if (others > 0 && item("Keep for all", "Into the scene file, from which others come, too"))
        run("keep_for_all(" + lua_string(path) + ")");
}

void ContextMenu::draw_value(const property::Place& place) {
    const property::Property& property = *place.property;
    const std::string path = path_;  // a command may open another menu
    pin_item("Pin", "Unpin", path);
    if (can_be_plotted(property) && item("Plot", "Shows it over time, with the kept past"))
        run("plot " + path);
    break_item("Break on change", "Pauses the game when it changes", path);
    if (place.part.empty() && item("Watch", "Prints each new value; _:stop() ends it"))
        run("watch(" + lua_string(path) + ", print)");
    ImGui::Separator();
    if (item("Who", "Who wrote it last")) run("who " + path);
    if (item("Why", "Where its value comes from")) run("why " + path);
    ImGui::Separator();
    if (item("Copy path", "Into the clipboard")) copy(path);
    const property::Handle owner = place.instance;
    if (select_class && item("Select all of its class", "All edits go to all of them"))
        select_class(tree_.class_of(owner));
    if (property.read_only) return;
    if (item("Formula …", "Types a formula: is EXPRESSION")) {
        if (!place.part.empty() || !begin_formula || !begin_formula(place)) insert(path + " is ");
    }
    if (place.part.empty() && item("Reset", "Back to its default")) run(path + " = nil");
    if (!property.transient) keep_items("Writes the edit of it into the game", owner, path);
}

void ContextMenu::draw_instance(property::Handle instance) {
    const std::string path = path_;
    const bool moves = tree_.find(instance, "position") != nullptr;
    if (moves) pin_item("Pin position", "Unpin position", path + ".position");
    if (moves && item("Plot position", "Shows it over time, with the kept past"))
        run("plot " + path + ".position");
    if (item("Help", "What its class has")) run("help(" + path + ")");
    ImGui::Separator();
    if (moves)
        break_item("Break when it moves", "Pauses the game when its position changes",
                   path + ".position");
    if (moves && item("Who", "Who moved it last")) run("who " + path + ".position");
    if (tree_.find(instance, "velocity") != nullptr &&
        item("Why", "What changed its velocity in the last step"))
        run("why " + path + ".velocity");
    if (moves) ImGui::Separator();
    if (item("Copy path", "Into the clipboard")) copy(path);
    if (select_class && item("Select all of its class", "All edits go to all of them"))
        select_class(tree_.class_of(instance));
    if (item("Put into the prompt", "The path, at the cursor")) insert(path);
    keep_items("Writes the edits of it into the game", instance, path);
    if (tree_.class_of(instance).creatable() && item("Delete", "undo brings it back"))
        run(path + ":delete()");
}

Rect ContextMenu::entry(std::string_view label) const {
    for (const auto& [name, rect] : drawn_)
        if (name == label) return rect;
    return {};
}

void ContextMenu::draw() {
    // A menu that is opened in the frame of the click is closed at the end of that frame.
    if (opens_ && !ImGui::IsMouseClicked(1)) {
        opens_ = false;
        ImGui::OpenPopup(menu_name);
    }
    drawn_.clear();
    if (!ImGui::BeginPopup(menu_name)) return;
    try {
        const property::Place place = property::resolve(tree_, path_);
        ImGui::PushStyleColor(ImGuiCol_Text, palette::path);
        text_line(path_);
        ImGui::PopStyleColor();
        ImGui::Separator();
        const FontScope font(fonts().sans);
        if (place.property != nullptr)
            draw_value(place);
        else
            draw_instance(place.instance);
    } catch (const property::Error&) {
        ImGui::CloseCurrentPopup();  // it was deleted
    }
    ImGui::EndPopup();
}

}  // namespace fettle::console
