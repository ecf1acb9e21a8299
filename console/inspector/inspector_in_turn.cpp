// The inspector where it has few lines: it shows the tree and the properties in turn.

#include <algorithm>

#include <inspector/inspector.h>
#include <look/fields.h>
#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

void Inspector::draw_problem() {
    if (!outline_.problem().empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::PushStyleColor(ImGuiCol_Text, palette::error);
        text_line(outline_.problem());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
    }
}

void Inspector::draw_selected(ImFont* bold, float right_free) {
    if (!tree_.alive(selected())) {
        const std::string instead = !selected() ? "Click a body in the game, or a name above."
                                    : tree_.deleted_info(selected())
                                        ? last_path_ + " was deleted"
                                        : last_path_ + " is not there at this step";
        ImGui::Spacing();
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("%s", instead.c_str());
        ImGui::PopTextWrapPos();
    } else {
        selection_.drop_deleted();
        editor_.also_edit(selection_.others(), selection_.revision());
        if (selection_.others().empty())
            draw_header(bold, right_free);
        else
            draw_several(bold, right_free);
        ImGui::BeginChild("properties");
        if (tree_.alive(selected())) draw_properties(bold);  // a button may have deleted it
        ImGui::EndChild();
    }
}

void Inspector::draw_in_turn(ImFont* bold) {
    editor_.begin_frame();
    pointed_ = {};
    follow_selected();
    const bool has_properties = tree_.alive(selected());
    if (frames_to_search_ > 0) tree_in_turn_ = true;
    const bool tree = tree_in_turn_ || !has_properties;
    const char* const other = tree ? "values" : "tree";
    const ImGuiStyle& style = ImGui::GetStyle();
    const float wide = text_width(other) + 2 * style.FramePadding.x,
                free = wide + style.ItemSpacing.x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    if (has_properties) {
        ImGui::SetCursorScreenPos(ImVec2(right - wide, at.y));
        if (tree ? ImGui::Button(other) : low_button(other)) {
            tree_in_turn_ = !tree;
            scroll_to_selected_ = true;
        }
        turn_rect_ = item_rect();
        ImGui::SetCursorScreenPos(at);
    }
    if (tree) {
        draw_search(has_properties ? free : 0);
        draw_problem();
        draw_outline(std::max(1.0f, ImGui::GetContentRegionAvail().y));
    } else {
        searches_ = false;
        draw_selected(bold, free);
    }
    editor_.end_frame();
    if (editor_.consume_moved_before_first()) begin_search();
}

}  // namespace fettle::console
