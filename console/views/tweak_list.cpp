#include <views/tweak_list.h>

#include <algorithm>
#include <ctime>

#include <look/theme.h>
#include <text/short_numbers.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr double patience = 0.25;  // seconds until the list is read again

std::string when(const property::Tweak& tweak) {
    const auto time = static_cast<std::time_t>(tweak.time);
    std::tm date{};
    char text[32] = "";
    if (localtime_r(&time, &date) != nullptr)
        std::strftime(text, sizeof text, tweak.earlier ? "%F %R" : "%T", &date);
    return "step " + std::to_string(tweak.step) + "  " + text;
}

std::string kept_text(const property::Tweak& tweak) {
    return "kept in " + tweak.kept_in;
}

void colored(ImU32 color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    text_line(text);
    ImGui::PopStyleColor();
}

using Draw = void (*)(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view text, float width);

/// Draws a text shortened to `width`. A tooltip shows `all` of it, if that is more.
void fitted(ImU32 color, const std::string& text, float width, Draw draw = draw_text_fit,
            std::string all = {}) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float whole = text_width(text);
    draw(*ImGui::GetWindowDrawList(), at, color, text, width);
    ImGui::Dummy(ImVec2(std::max(1.0f, std::min(whole, width)), ImGui::GetTextLineHeight()));
    if (all.empty()) all = text;
    if ((whole > width || all != text) && ImGui::IsItemHovered())
        show_tip(std::string_view(all).substr(0, 4000));
}

}  // namespace

void TweakList::refresh(bool now) {
    const double time = ImGui::GetTime();
    if (!now && refreshed_ >= 0 && time - refreshed_ < patience && time >= refreshed_) return;
    refreshed_ = time;
    rows_ = tweaks_->list();
}

std::size_t TweakList::open_count() {
    if (tweaks_ == nullptr) return 0;
    refresh(false);
    return static_cast<std::size_t>(
        std::count_if(rows_.begin(), rows_.end(), [](const Tweak& tweak) { return !tweak.kept; }));
}

// Runs a command, so that a recording of the run contains it.
void TweakList::act(const char* function, const std::string& pattern) {
    if (!evaluate) return;
    const script::Evaluation result = evaluate(function + ("(" + lua_string(pattern) + ")"));
    if (report) {
        for (const std::string& line : result.lines) report(line);
        if (result.error) report(result.error->message);
    }
    refresh(true);
}

bool TweakList::small_button(int row, const char* label, const char* hint) {
    ImGui::PushID(row);
    const bool pressed = low_button(label);
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    drawn_.push_back({row, label, {low, high}});
    if (ImGui::IsItemHovered()) show_tip(hint);
    return pressed;
}

Rect TweakList::button(int row, std::string_view label) const {
    for (const Drawn& each : drawn_)
        if (each.row == row && each.label == label) return each.rect;
    return {};
}

void TweakList::draw_header() {
    const auto open = open_count();
    const bool earlier =
        std::any_of(rows_.begin(), rows_.end(), [](const Tweak& t) { return t.earlier; });
    const std::string text =
        rows_.empty() ? "Nothing was tweaked. What you edit while the game runs is listed here, "
                        "and survives whatever happens to the game."
                      : std::to_string(open) + " to keep or to drop";
    colored(palette::dim, wrapped(text, ImGui::GetContentRegionAvail().x));
    if (open == 0) return;
    ImGui::SameLine();
    if (small_button(-1, "keep all", "Write them into the files they came from")) act("keep", "**");
    if (earlier) {
        ImGui::SameLine();
        if (small_button(-1, "make all again", "Make these edits again, as one edit"))
            act("reapply_tweaks", "**");
    }
    ImGui::SameLine();
    if (small_button(-1, "drop all", "Forget them; values stay as they are"))
        act("drop_tweaks", "**");
}

void TweakList::draw_change(const Tweak& tweak) {
    float room = ImGui::GetContentRegionAvail().x;
    std::string old = with_short_numbers(tweak.was).text;
    std::string now = with_short_numbers(tweak.now).text;
    if (old == now) old = tweak.was, now = tweak.now;
    if (tweak.value) {
        const std::string arrow = " → ";
        const float both = room - text_width(arrow);
        // The new value gets the room that the old one does not need, and at least half of it.
        const float was = std::min(text_width(old), std::max(both / 2, both - text_width(now)));
        fitted(palette::dim, old, was, draw_text_fit, tweak.was);
        ImGui::SameLine(0, 0);
        colored(palette::faint, arrow);
        ImGui::SameLine(0, 0);
        room = both - was;
    }
    fitted(tweak.value ? palette::number : palette::string, now, room, draw_text_fit, tweak.now);
}

void TweakList::draw_row(int row) {
    const Tweak tweak = rows_[static_cast<std::size_t>(row)];  // a copy: buttons change the list
    // It has the same height without buttons.
    ImGui::TableNextRow(0, button_height() + 2 * ImGui::GetStyle().CellPadding.y);
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float path_room = ImGui::GetContentRegionAvail().x;
    drawn_.push_back({row, "path", {at, ImVec2(at.x + path_room, at.y + 1)}});
    fitted(palette::path, tweak.path, path_room, draw_path_fit,
           times_ ? "" : tweak.path + "\n" + when(tweak));
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked(0) && follow) follow(tweak.path);
    ImGui::TableNextColumn();
    draw_change(tweak);
    if (times_) {
        ImGui::TableNextColumn();
        colored(tweak.earlier ? palette::accent : palette::faint, when(tweak));
    }
    ImGui::TableNextColumn();
    if (tweak.kept) {
        const float room = ImGui::GetContentRegionAvail().x;
        drawn_.push_back({row, "kept", {ImGui::GetCursorScreenPos(), ImGui::GetCursorScreenPos()}});
        drawn_.back().rect.high.x += std::min(room, text_width(kept_text(tweak)));
        return fitted(palette::note, kept_text(tweak), room);
    }
    if (small_button(row, "keep", "Write it into the file it came from")) act("keep", tweak.path);
    ImGui::SameLine();
    if (tweak.earlier) {
        if (small_button(row, "make again", "Set it now")) act("reapply_tweaks", tweak.path);
        ImGui::SameLine();
    }
    if (small_button(row, "drop", "Forget it; the value stays as it is"))
        act("drop_tweaks", tweak.path);
}

void TweakList::draw(float height) {
    refresh(false);
    drawn_.clear();
    const float top = ImGui::GetCursorPosY();
    draw_header();
    const float left = std::max(1.0f, height - (ImGui::GetCursorPosY() - top));
    constexpr int flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp |
                          ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_PadOuterX;
    // The times and the buttons are never cut; paths and values may be. In a narrow window the
    // times are in the tooltip of the path.
    float times = 0, files = 0, paths = 0, changes = 0;
    bool earlier = false;
    for (const Tweak& tweak : rows_) {
        times = std::max(times, text_width(when(tweak)));
        paths = std::max(paths, text_width(tweak.path));
        changes = std::max(changes, text_width(tweak.was) + text_width(tweak.now));
        earlier = earlier || tweak.earlier;
        if (tweak.kept) files = std::max(files, text_width(kept_text(tweak)));
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto wide = [&](const char* label) {
        return text_width(label) + 2 * style.FramePadding.x + style.ItemSpacing.x;
    };
    const float buttons = wide("keep") + (earlier ? wide("make again") : 0) + wide("drop");
    constexpr float least_values = 30;  // ems of paths and values beside the times
    times_ =
        ImGui::GetContentRegionAvail().x - times - buttons >= least_values * ImGui::GetFontSize();
    // Names of files are not cut, either, where paths and values leave them room.
    const float left_over = ImGui::GetContentRegionAvail().x - (times_ ? times : 0) -
                            least_values * ImGui::GetFontSize();
    const float last = std::max(buttons, std::min(files, left_over));
    if (!ImGui::BeginTable("tweaks", times_ ? 4 : 3, flags, ImVec2(0, left))) return;
    // Paths are not cut where the changes leave them room.
    const float room = std::max(1.0f, ImGui::GetContentRegionAvail().x - last -
                                          (times_ ? times : 0) - 8 * style.CellPadding.x);
    const float needed = std::min(1.0f, (paths + style.CellPadding.x) / room);
    const float left_by_changes = 1 - changes / room;
    const float share = std::clamp(left_by_changes, std::min(needed, 0.4f), std::min(needed, 0.8f));
    ImGui::TableSetupColumn("what", 0, std::max(share, 0.05f));
    ImGui::TableSetupColumn("change", 0, 1 - std::min(share, 0.95f));
    if (times_) ImGui::TableSetupColumn("when", ImGuiTableColumnFlags_WidthFixed, times);
    ImGui::TableSetupColumn("do", ImGuiTableColumnFlags_WidthFixed, last);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.size()));
    while (clipper.Step())
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
            if (row < static_cast<int>(rows_.size())) draw_row(row);
    ImGui::EndTable();
}

}  // namespace fettle::console
