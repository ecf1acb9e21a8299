// The lanes of the other branches above the track of the time bar.

#include <observed/game_time.h>
#include <views/time_bar.h>

#include <algorithm>

#include <look/imgui_compat.h>
#include <look/theme.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr const char* branch_menu = "##branch";

}  // namespace

void TimeBar::draw_lanes(const Times& now) {
    lanes_.clear();
    const float tall = lane_height();
    float y = track_.low.y - static_cast<float>(branches_.size()) * tall;
    for (const OtherBranch& branch : branches_) {
        const Rect lane{ImVec2(track_.low.x, y),
                        ImVec2(rect_.high.x - ImGui::GetStyle().WindowPadding.x, y + tall)};
        draw_lane(now, branch, lane);
        lanes_.push_back(lane);
        y += tall;
    }
}

void TimeBar::draw_lane(const Times& now, const OtherBranch& branch, const Rect& lane) {
    ImGui::SetCursorScreenPos(lane.low);
    ImGui::PushID(branch.name.c_str());
    const bool pressed = ImGui::InvisibleButton(
        "lane", ImVec2(std::max(1.0f, lane.high.x - lane.low.x), lane.high.y - lane.low.y));
    const bool hovered = ImGui::IsItemHovered();
    const bool clicked = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = lane.middle().y;
    const ImU32 color = hovered ? palette::text : palette::note;
    const float from = x_of(now, std::max(branch.fork, now.oldest));
    const float to = std::max(from + 2, x_of(now, branch.newest));
    // From the track up to the lane, and along it.
    if (branch.fork >= now.oldest) {
        list.AddLine(ImVec2(from, track_.middle().y - 4), ImVec2(from, y), with_alpha(color, 0.5f));
        list.AddCircleFilled(ImVec2(from, track_.middle().y), 2.5f, color);
    }
    list.AddRectFilled(ImVec2(from, y - 2), ImVec2(to, y + 2), with_alpha(color, 0.7f), 2);
    list.AddCircleFilled(ImVec2(to, y), 3.5f, color);
    // Its name is after its end, or before its beginning where there is no room.
    const float room = lane.high.x - to - 10, wide = text_width(branch.name);
    const float text = wide <= room || from - lane.low.x < wide + 10 ? to + 10 : from - wide - 10;
    draw_text_fit(list, ImVec2(text, y - ImGui::GetTextLineHeight() / 2),
                  hovered ? palette::text : palette::dim, branch.name,
                  std::max(1.0f, std::max(room, wide)));
    if (hovered)
        tip("branch " + branch.name + ": parts after step " + std::to_string(branch.fork) +
            ", ends at step " + std::to_string(branch.newest) +
            "\nclick: compare · right click: go there, name, forget");
    if (pressed && run) run("compare_branch(" + lua_string(branch.name) + ")");
    if (clicked) {
        menu_of_ = branch.name;
        opens_menu_ = true;
    }
}

bool TimeBar::entry(const char* label, const char* tip_text) {
    const bool chosen = ImGui::MenuItem(label);
    entries_.emplace_back(label, item_rect());
    if (ImGui::IsItemHovered()) show_tip_beside(tip_text);
    return chosen;
}

Rect TimeBar::menu_entry(const std::string& label) const {
    for (const auto& [name, rect] : entries_)
        if (name == label) return rect;
    return {};
}

/// `name`: the branch, as Lua writes it.
void TimeBar::draw_entries(const std::string& name) {
    const FontScope font(fonts().sans);
    if (entry("Compare", "Shows it and the present branch side by side, and what differs") && run)
        run("compare_branch(" + name + ")");
    if (entry("Go there", "Makes it the present branch, at its last step") && run) {
        set_time_flag(tree_, "paused", true);
        run("time:switch_to(" + name + ")");
    }
    if (entry("Name …", "Puts the command into the prompt") && insert)
        insert("time:name_branch(\"", "\", " + name + ")");
    if (entry("Forget", "It is not kept any more") && run) run("time:forget_branch(" + name + ")");
}

void TimeBar::draw_branch_menu() {
    // As in ContextMenu::draw: not in the frame of the click.
    if (opens_menu_ && !ImGui::IsMouseClicked(1)) {
        opens_menu_ = false;
        ImGui::OpenPopup(branch_menu);
    }
    entries_.clear();
    if (!ImGui::BeginPopup(branch_menu)) return;
    const std::string name = lua_string(menu_of_);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::note);
    text_line("branch " + menu_of_);
    ImGui::PopStyleColor();
    ImGui::Separator();
    draw_entries(name);
    ImGui::EndPopup();
}

}  // namespace fettle::console
