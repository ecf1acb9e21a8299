#include <views/tweak_list.h>

#include <algorithm>
#include <ctime>
#include <iterator>
#include <utility>

#include <look/theme.h>
#include <text/short_numbers.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr double refresh_interval = 0.25;  // seconds until the list is read again

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
    if (!now && refreshed_ >= 0 && time - refreshed_ < refresh_interval && time >= refreshed_)
        return;
    refreshed_ = time;
    std::vector<Tweak> all = tweaks_->list();
    if (!hovered_) {
        gone_.clear();
        rows_ = std::move(all);
        return;
    }
    // The rows keep their places, so that a second click does not hit another row.
    gone_.resize(rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        Tweak& shown = rows_[row];
        const auto same = [&](const Tweak& each) {
            return each.path == shown.path && each.value == shown.value;
        };
        auto found = std::ranges::find_if(
            all, [&](const Tweak& each) { return same(each) && each.earlier == shown.earlier; });
        if (found == all.end()) found = std::ranges::find_if(all, same);
        gone_[row] = found == all.end();
        if (gone_[row]) continue;
        shown = std::move(*found);
        all.erase(found);
    }
    std::ranges::move(all, std::back_inserter(rows_));
    gone_.resize(rows_.size());
}

bool TweakList::is_gone(std::size_t row) const {
    return row < gone_.size() && gone_[row];
}

std::size_t TweakList::open_count() {
    if (tweaks_ == nullptr) return 0;
    refresh(false);
    std::size_t count = 0;
    for (std::size_t row = 0; row < rows_.size(); ++row)
        count += rows_[row].kept || is_gone(row) ? 0 : 1;
    return count;
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

namespace {

constexpr const char* arrow = " → ";

/// The texts that are shown: with short numbers, unless these are equal.
std::pair<std::string, std::string> shown_change(const property::Tweak& tweak) {
    std::pair<std::string, std::string> texts{with_short_numbers(tweak.was).text,
                                              with_short_numbers(tweak.now).text};
    return texts.first == texts.second ? std::pair{tweak.was, tweak.now} : texts;
}

}  // namespace

void TweakList::draw_change(const Tweak& tweak) {
    float room = ImGui::GetContentRegionAvail().x;
    const auto [old, now] = shown_change(tweak);
    if (tweak.value) {
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
    if (ImGui::IsItemClicked(0) && follow) follow(tweak.there);
    ImGui::TableNextColumn();
    draw_change(tweak);
    if (times_) {
        ImGui::TableNextColumn();
        colored(tweak.earlier ? palette::accent : palette::faint, when(tweak));
    }
    ImGui::TableNextColumn();
    if (is_gone(static_cast<std::size_t>(row))) return;
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
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool hovered = ImGui::IsMouseHoveringRect(
        corner, ImVec2(corner.x + ImGui::GetContentRegionAvail().x, corner.y + height));
    const bool left_it = std::exchange(hovered_, hovered) && !hovered;
    refresh(left_it);
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
        const auto [old, now] = shown_change(tweak);
        changes = std::max(changes, (tweak.value ? text_width(old + arrow) : 0) + text_width(now));
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
