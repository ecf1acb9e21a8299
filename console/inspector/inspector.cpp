#include <inspector/inspector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fettle/property/natural_order.h>
#include <fettle/script/reference.h>

#include <inspector/multi_selection.h>
#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

using property::Handle;
using property::Property;

Inspector::Inspector(property::Tree& tree)
    : tree_(tree), outline_(tree), editor_(tree), selection_(tree) {
    editor_.follow = [this](Handle instance) { choose(instance); };
}

void Inspector::select(Handle instance, const std::string& property) {
    if (!tree_.alive(instance)) return;
    selection_.select(instance);
    outline_.reveal(instance);
    scroll_to_selected_ = true;
    scroll_to_property_ = property;
    tree_in_turn_ = false;
}

void Inspector::toggle(Handle instance) {
    std::vector<Handle> all = selection();
    if (std::erase(all, instance) == 0) all.push_back(instance);
    if (all.empty()) return deselect();
    select(all);
}

void Inspector::deselect() {
    selection_.clear();
    last_path_.clear();
}

void Inspector::select(const std::vector<Handle>& instances) {
    selection_.select(instances);
    select(selected());
}

void Inspector::run_for_all(const std::string& command, const char* what) {
    if (!command.empty() && run) return run(command);
    if (report)
        report(std::string(what) + ": at most " + std::to_string(most_in_command) +
               " instances at once; for more use selection()");
}
void Inspector::delete_selection() {
    run_for_all(delete_command(tree_, selection()), "delete");
}
void Inspector::clone_selection() {
    run_for_all(clone_command(tree_, selection()), "clone");
}

void Inspector::choose(Handle instance) {
    selection_.select_only(instance);
    select(instance);
    if (chosen) chosen(instance);
}

void Inspector::draw_search(float right_free) {
    ImGui::SetNextItemWidth(right_free > 0 ? -right_free : -1);
    const char* const hint = "search by name, class, or mass > 5";
    const bool fits =
        text_width(hint) + 2 * ImGui::GetStyle().FramePadding.x < ImGui::GetContentRegionAvail().x;
    if (frames_to_search_ > 0) compat::give_keyboard();
    const std::string before = search_;
    input_line("##search", fits ? hint : "search", search_, ImGuiInputTextFlags_AutoSelectAll);
    const bool had_keyboard = searches_;
    searches_ = ImGui::IsItemActive();
    if (searches_ || frames_to_search_ > 0) tree_in_turn_ = true;
    frames_to_search_ = searches_ ? 0 : std::max(0, frames_to_search_ - 1);
    // Escape clears the text, and ends the search when there is none.
    if (had_keyboard && !searches_ && compat::escape_pressed() && !before.empty()) {
        search_.clear();
        begin_search();
    }
    if (search_ != before) focused_row_ = {};
    outline_.search(search_);
    if (!before.empty() && search_.empty() &&
        tree_.alive(selected())) {  // the whole tree again, where the selected instance is
        outline_.reveal(selected());
        scroll_to_selected_ = true;
    }
    if (searches_)
        move_through_rows();
    else if (had_keyboard && compat::pressed(ImGuiKey_Enter))
        choose_focused_row();
    else if (had_keyboard)
        focused_row_ = {};
}

/// The keys that move through the rows while the search field has the keyboard.
void Inspector::move_through_rows() {
    const auto& rows = outline_.rows(ImGui::GetTime());
    if (rows.empty()) return;
    const auto last = static_cast<std::ptrdiff_t>(rows.size()) - 1;
    const auto page = static_cast<std::ptrdiff_t>(outline_height_ / ImGui::GetFrameHeight());
    std::ptrdiff_t by = 0;
    if (compat::pressed(ImGuiKey_DownArrow, true)) by = 1;
    if (compat::pressed(ImGuiKey_UpArrow, true)) by = -1;
    if (compat::pressed(ImGuiKey_PageDown, true)) by = std::max<std::ptrdiff_t>(1, page);
    if (compat::pressed(ImGuiKey_PageUp, true)) by = -std::max<std::ptrdiff_t>(1, page);
    const bool began = tree_.alive(focused_row_);
    const std::ptrdiff_t at = outline_.row_of(began ? focused_row_ : selected());
    if (by != 0) {
        const std::ptrdiff_t to = at < 0 ? (by > 0 ? 0 : last) : std::clamp(at + by, {}, last);
        focused_row_ = rows[static_cast<std::size_t>(to)].instance;
        scroll_to_selected_ = true;
    } else if (at >= 0 && search_.empty()) {  // else the arrows move the cursor in the text
        const InstanceTree::Row row = rows[static_cast<std::size_t>(at)];
        if (compat::pressed(ImGuiKey_RightArrow)) outline_.fold(row.instance, true);
        if (compat::pressed(ImGuiKey_LeftArrow)) {
            if (row.unfolded && row.has_children)
                outline_.fold(row.instance, false);
            else if (const Handle parent = tree_.parent(row.instance))
                focused_row_ = parent;
            scroll_to_selected_ = true;
        }
    }
}

/// Selects the row that the arrow keys have reached, or the first one that was found.
void Inspector::choose_focused_row() {
    const auto& rows = outline_.rows(ImGui::GetTime());
    Handle found = std::exchange(focused_row_, {});
    if (!tree_.alive(found) && !search_.empty() && !rows.empty()) found = rows.front().instance;
    if (tree_.alive(found)) choose(found);
}

bool Inspector::tab(bool back) {
    if (searches_ || frames_to_search_ > 0) {
        if (!back) {
            choose_focused_row();
            tree_in_turn_ = false;
            editor_.move_focus(false);
        }
        frames_to_search_ = 0;
        return true;
    }
    if (!editor_.typing()) return false;
    editor_.move_focus(back);
    return true;
}

/// Shows the row of the selected instance again after it, or an instance above it, got another
/// parent.
void Inspector::follow_selected() {
    if (!tree_.alive(selected())) return;
    std::string path = tree_.path(selected());
    if (path == last_path_) return;
    last_path_ = std::move(path);
    outline_.reveal(selected());
    scroll_to_selected_ = true;
}

float Inspector::height_without_selection(float whole) const {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float above = style.WindowPadding.y + ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const float below = 4 * style.ItemSpacing.y + 2 * ImGui::GetTextLineHeight();  // the hint
    const float available = whole - above - style.WindowPadding.y;
    return std::min(whole, above + available * outline_share_ + button_height() + below);
}

void Inspector::draw(ImFont* bold, float left_out) {
    editor_.begin_frame();
    pointed_ = {};
    follow_selected();
    draw_search();
    draw_problem();
    // Whether or not something is selected, so that a selection moves nothing.
    const float available = ImGui::GetContentRegionAvail().y + left_out;
    draw_outline(std::max(1.0f, std::floor(available * outline_share_)));
    draw_splitter();
    draw_selected(bold);
    editor_.end_frame();
    if (editor_.consume_moved_before_first()) begin_search();
}

// --- Outline

void Inspector::draw_outline(float height) {
    const float row_height = ImGui::GetFrameHeight();
    const float shown = std::max(1.0f, std::floor(height / row_height));  // whole rows
    height = std::min(height, shown * row_height);
    if (height < outline_height_) scroll_to_selected_ = true;
    outline_height_ = height;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::well);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, 0));
    ImGui::BeginChild("outline", ImVec2(0, height));
    const auto& rows = outline_.rows(ImGui::GetTime());
    if (scroll_to_selected_) {
        const auto row = static_cast<float>(
            outline_.row_of(tree_.alive(focused_row_) ? focused_row_ : selected()));
        const float y = row * row_height, view = ImGui::GetScrollY();
        if (row >= 0 && (y < view || y + row_height > view + height))
            // The row in the middle, and none that is cut.
            ImGui::SetScrollY(std::max(0.0f, row - std::floor(shown / 2)) * row_height);
        scroll_to_selected_ = false;
    }
    if (rows.empty() && outline_.problem().empty())
        ImGui::TextDisabled(outline_.searching()                     ? " searching …"
                            : property::Condition::is_meant(search_) ? " it holds for nothing"
                                                                     : " nothing is called that");
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), row_height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            // A copy, because folding a row changes the list in the next frame.
            draw_outline_row(InstanceTree::Row(rows[static_cast<std::size_t>(i)]));
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void Inspector::draw_outline_row(const InstanceTree::Row& row) {
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
    ImVec2 at = ImGui::GetCursorScreenPos();
    if (!tree_.alive(row.instance)) {
        ImGui::Dummy(ImVec2(width, height));
        return;
    }
    ImGui::PushID(static_cast<int>(row.instance.index));
    float em = ImGui::GetFontSize();
    float x = at.x + em * (0.3f + 0.85f * static_cast<float>(row.depth));
    ImGui::InvisibleButton("row", ImVec2(std::max(width, 1.0f), height));
    bool hovered = ImGui::IsItemHovered();
    if (hovered) pointed_ = row.instance;
    if (ImGui::IsItemClicked(0)) {
        bool on_arrow = row.has_children && ImGui::GetIO().MousePos.x < x + em;
        if (on_arrow || (row.has_children && ImGui::IsMouseDoubleClicked(0)))
            outline_.fold(row.instance, !row.unfolded);
        if (!on_arrow && ImGui::GetIO().KeyCtrl) {
            toggle(row.instance);
            if (chosen && selection_.contains(row.instance)) chosen(row.instance);
            if (chosen && !selected()) chosen({});
        } else if (!on_arrow) {
            choose(row.instance);
        }
    }
    if (ImGui::IsItemClicked(1) && menu) menu(tree_.path(row.instance));
    ImGui::PopID();

    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 end(at.x + width, at.y + height);
    bool chosen_row = selection_.contains(row.instance);
    if (chosen_row || hovered)
        list.AddRectFilled(at, end, chosen_row ? palette::selection : palette::rgb(0x1b2029),
                           ImGui::GetStyle().FrameRounding);
    if (row.instance == focused_row_)
        list.AddRect(at, end, palette::accent, ImGui::GetStyle().FrameRounding);
    float y = at.y + (height - ImGui::GetTextLineHeight()) / 2;
    if (row.has_children) draw_text(list, ImVec2(x, y), palette::dim, row.unfolded ? "▾" : "▸");
    const property::Class& kind = tree_.class_of(row.instance);
    x += em;
    list.AddCircleFilled(ImVec2(x + em * 0.2f, at.y + height / 2), em * 0.2f,
                         class_color(kind.name()));
    x += em * 0.7f;
    float class_width = [&] {
        const FontScope font(fonts().sans);
        return text_width(kind.name()) + em * 0.5f;
    }();
    std::string name =
        outline_.searched().empty() ? tree_.name(row.instance) : tree_.path(row.instance);
    if (name.empty()) name = tree_.path(row.instance);
    // The name goes before the class.
    const float room = end.x - x - em * 0.5f;
    const bool has_class = text_width(name) <= room - class_width || room > 3 * class_width;
    // Of a path, the end tells one row from another.
    const auto fit = outline_.searched().empty() ? draw_text_fit : draw_path_fit;
    fit(list, ImVec2(x, y), palette::text, name, has_class ? room - class_width : room);
    if (!has_class) return;
    const FontScope font(fonts().sans);
    draw_text(list, ImVec2(end.x - class_width, y), palette::faint, kind.name());
}

void Inspector::draw_splitter() {
    float thickness = std::max(6.0f, std::floor(ImGui::GetFontSize() * 0.4f));
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x;
    // It can be grasped below the line, too: nothing in the header can be clicked.
    ImGui::InvisibleButton("splitter", ImVec2(std::max(1.0f, width), button_height()));
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + thickness + ImGui::GetStyle().ItemSpacing.y));
    bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    // The motion before the press does not count.
    if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) {
        float whole = std::max(1.0f, ImGui::GetWindowHeight());
        outline_share_ =
            std::clamp(outline_share_ + ImGui::GetIO().MouseDelta.y / whole, 0.1f, 0.85f);
    }
    float y = at.y + thickness / 2;
    ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x, y), ImVec2(at.x + width, y),
                                        hot ? palette::accent : palette::line);
}

// --- The selected instance

void Inspector::draw_header(ImFont* bold, float right_free) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x - right_free, em = ImGui::GetFontSize();
    std::string class_name = tree_.class_of(selected()).name();
    float class_width = text_width(class_name) + em * 0.8f;
    ImGui::Dummy(ImVec2(width, em * 1.5f));
    float y = at.y + em * 0.25f;
    compat::push_font(bold);
    draw_path_fit(list, ImVec2(at.x, y), palette::text, last_path_,
                  width - class_width - em * 0.5f);
    ImGui::PopFont();
    ImVec2 low(at.x + width - class_width, at.y + em * 0.1f);
    list.AddRectFilled(low, ImVec2(at.x + width, low.y + em * 1.3f),
                       with_alpha(class_color(class_name), 0.18f), em * 0.65f);
    draw_text(list, ImVec2(low.x + em * 0.4f, y), class_color(class_name), class_name);
}

/// The header for several selected instances, with buttons for operations on all of them.
void Inspector::draw_several(ImFont* bold, float right_free) {
    const std::string& kind = tree_.class_of(selected()).name();
    const bool alike = selection_.of_one_class();
    compat::push_font(bold);
    text_line(std::to_string(selection_.count()) + " selected");
    ImGui::PopFont();
    const FontScope font(fonts().sans);
    const float right =
        ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x - right_free;
    const ImGuiStyle& style = ImGui::GetStyle();
    // What has no room in a row begins another one.
    const auto beside_if_it_fits = [&](float wide) {
        if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + wide <= right) ImGui::SameLine();
    };
    const std::string shared = alike ? kind : "what all of them have";
    beside_if_it_fits(text_width(shared));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float wide = std::min(text_width(shared), right - at.x);
    ImGui::Dummy(ImVec2(wide, ImGui::GetTextLineHeight()));
    draw_text_fit(*ImGui::GetWindowDrawList(), at, alike ? class_color(kind) : palette::dim, shared,
                  wide);
    const auto button = [&](const char* label) {
        beside_if_it_fits(text_width(label) + 2 * style.FramePadding.x);
        return low_button(label);
    };
    if (low_button("Delete")) delete_selection();
    if (button("Clone")) clone_selection();
    for (const int axis : {0, 1}) {
        if (button(axis == 0 ? "Align x" : "Align y")) align(tree_, selection(), axis);
        if (ImGui::IsItemHovered())
            show_tip(std::string("Gives all the mean of their positions along ") +
                     (axis == 0 ? "x" : "y"));
    }
}

/// Looks at no more than fifty instances: all instances of a class have its properties.
bool Inspector::all_have(const Property& property) const {
    constexpr std::size_t most_asked = 50;
    if (!selection_.others().empty() && property.name == "name") return false;
    const std::vector<Handle>& others = selection_.others();
    const auto end =
        others.begin() + static_cast<std::ptrdiff_t>(std::min(others.size(), most_asked));
    return std::all_of(others.begin(), end, [&](Handle each) {
        return MixedValues::same(tree_, each, property) != nullptr;
    });
}

bool Inspector::group(const std::string& title, bool open, ImFont* bold) {
    compat::push_font(bold);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::dim);
    bool unfolded =
        ImGui::CollapsingHeader(title.c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    return unfolded;
}

std::vector<const Property*> grouped_by_class(std::vector<const Property*> properties,
                                              const OfGame& is_of_game) {
    const auto place = [&](const Property* property) {
        if (property->binding.kind == property::BindingKind::ad_hoc || property->owner == nullptr)
            return std::numeric_limits<int>::max();
        int depth = 0;
        for (const property::Class* at = property->owner; at != nullptr; at = at->base()) ++depth;
        return is_of_game && is_of_game(*property->owner) ? -depth : depth;
    };
    std::ranges::stable_sort(properties, {}, place);
    const auto own =
        std::ranges::lower_bound(properties, std::numeric_limits<int>::max(), {}, place);
    std::ranges::sort(own, properties.end(), property::NaturalOrder{}, &Property::name);
    return properties;
}

void Inspector::draw_properties(ImFont* bold) {
    ImGui::PushID(static_cast<int>(selected().index));
    const property::Class* owner = nullptr;
    bool unfolded = true;
    Handle shown = selected();
    const std::vector<const Property*> properties =
        grouped_by_class(tree_.properties(shown), is_of_game);
    editor_.fit_labels(properties);
    for (const Property* property : properties) {
        if (property->hidden || !all_have(*property)) continue;
        bool ad_hoc = property->binding.kind == property::BindingKind::ad_hoc;
        const property::Class* now = ad_hoc ? nullptr : property->owner;
        if (now != owner || (owner == nullptr && property == properties.front())) {
            owner = now;
            unfolded = group(now != nullptr ? now->name() : "added here", true, bold);
        }
        if (property->name == scroll_to_property_) {
            ImGui::SetScrollHereY(0.3f);
            scroll_to_property_.clear();
        }
        bool edited = unfolded && editor_.draw(shown, *property, bold);
        if (shown != selected() || !tree_.alive(shown)) break;  // the user followed a link
        if (edited && tree_.properties(shown).size() != properties.size()) break;
    }
    if (tree_.alive(shown) && shown == selected() && selection_.others().empty()) {
        if (!tree_.class_of(shown).methods().empty() && group("methods", false, bold))
            draw_methods();
        std::size_t children = tree_.child_count(shown);
        std::string title = "children (" + std::to_string(children) + ")###children";
        if (children > 0 && group(title, true, bold)) draw_children();
    }
    ImGui::PopID();
}

void Inspector::draw_methods() {
    for (const property::Method* method : tree_.class_of(selected()).methods()) {
        std::string line = method->name + "(";
        for (std::size_t i = 0; i < method->parameters.size(); ++i)
            line += (i > 0 ? ", " : "") + method->parameters[i].name +
                    (i >= method->required ? "?" : "");
        line += ")";
        if (ImGui::Selectable(line.c_str()) && insert)
            insert(tree_.path(selected()) + ":" + method->name + "(");
        if (ImGui::IsItemHovered() && !method->doc.empty()) {
            ImGui::BeginTooltip();
            ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
            text_line(script::shown_doc(method->doc));
            ImGui::PopTextWrapPos();
            ImGui::EndTooltip();
        }
    }
}

void Inspector::draw_children() {
    constexpr int limit = 100;  // the outline above shows all of them
    int shown = 0;
    float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    Handle chosen_child;
    for (Handle child = tree_.first_child(selected()); child && shown < limit;
         child = tree_.next_sibling(child), ++shown) {
        ImGui::PushID(static_cast<int>(child.index));
        ImGui::PushStyleColor(ImGuiCol_Text, palette::path);
        if (ImGui::Selectable(widget_text(tree_.name(child)).c_str())) chosen_child = child;
        ImGui::PopStyleColor();
        std::string kind = tree_.class_of(child).name();
        ImGui::SameLine(right - text_width(kind) - ImGui::GetStyle().ItemSpacing.x);
        ImGui::TextDisabled("%s", kind.c_str());
        ImGui::PopID();
    }
    std::size_t count = tree_.child_count(selected());
    if (count > static_cast<std::size_t>(limit))
        ImGui::TextDisabled("and %zu more", count - static_cast<std::size_t>(limit));
    if (chosen_child) choose(chosen_child);
}

}  // namespace fettle::console
