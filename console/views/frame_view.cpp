#include <observed/last_value.h>
#include <views/frame_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fettle/property/fixed_text.h>

#include <look/theme.h>

namespace fettle::console {

using app::FrameTimes;
using app::Timings;
using property::Handle;

namespace {

constexpr int frame_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                            ImGuiWindowFlags_NoFocusOnAppearing;

struct Part {
    const char* name;
    double Timings::*ms;
    ImU32 color;
};

/// In the order of a frame.
constexpr std::array<Part, 7> parts{{{"input", &Timings::input, palette::rgb(0x8fd48a)},
                                     {"update", &Timings::update, palette::rgb(0xf4a259)},
                                     {"scripts", &Timings::scripts, palette::rgb(0xffd479)},
                                     {"modules", &Timings::modules, palette::rgb(0x77bdfb)},
                                     {"handlers", &Timings::handlers, palette::rgb(0xc8a8f0)},
                                     {"draw", &Timings::draw, palette::rgb(0xf39b90)},
                                     {"wait", &Timings::wait, palette::rgb(0x3a4250)}}};

std::string in_ms(double ms) {
    return property::fixed_text(ms, ms < 0.995 ? 2 : 1) + " ms";
}

/// Names and times of the parts of physics in the last step, from the properties of `world.step`.
std::vector<std::pair<std::string, double>> parts_of_physics(const property::Tree& tree) {
    std::vector<std::pair<std::string, double>> found;
    const Handle world = tree.child(tree.root(), "world");
    const Handle step = world ? tree.child(world, "step") : Handle{};
    if (!step) return found;
    constexpr std::string_view ending = "_ms", all = "total_ms";
    for (const property::Property* each : tree.class_of(step).properties())
        if (each->name.ends_with(ending) && each->name != all &&
            each->type == property::Type::number)
            found.emplace_back(each->name.substr(0, each->name.size() - ending.size()),
                               last_value(tree, step, *each).number());
    return found;
}

void draw_tooltip(const FrameTimes& frame) {
    ImGui::BeginTooltip();
    ImGui::Text("frame %lld, step %lld: %s", static_cast<long long>(frame.frame),
                static_cast<long long>(frame.step), in_ms(frame.ms.frame).c_str());
    for (const Part& part : parts) {
        ImGui::PushStyleColor(ImGuiCol_Text, part.ms == &Timings::wait ? palette::dim : part.color);
        ImGui::Text("  %-9s %s", part.name, in_ms(frame.ms.*part.ms).c_str());
        ImGui::PopStyleColor();
    }
    ImGui::TextDisabled("a click pauses and goes to its step");
    ImGui::EndTooltip();
}

/// Draws a box, and in it the name and the time, only the name, or nothing, as there is room. The
/// tooltip has both.
void draw_box(ImDrawList& list, const Rect& place, ImU32 color, const std::string& name,
              double ms) {
    if (place.high.x - place.low.x < 0.5f) return;
    list.AddRectFilled(place.low, ImVec2(place.high.x - 1, place.high.y), color);
    const float room = place.high.x - place.low.x - 6;
    const std::string whole = name + " " + in_ms(ms);
    const std::string& label = text_width(whole) <= room ? whole : name;
    // Dark letters on the light colors of the parts, light letters on the dark color of "wait".
    const ImU32 ink = name == "wait" ? palette::text : palette::rgb(0x0d0f14);
    if (text_width(label) <= room)
        draw_text(list, ImVec2(place.low.x + 4, place.low.y + 1), ink, label);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsWindowHovered() && place.contains(mouse.x, mouse.y)) show_tip(whole);
}

}  // namespace

std::optional<FrameTimes> worst_frame(const app::FrameLog& log) {
    const auto& all = log.frames();
    const auto worst =
        std::ranges::max_element(all, {}, [](const FrameTimes& frame) { return frame.ms.work(); });
    return worst == all.end() ? std::nullopt : std::optional(*worst);
}

void FrameView::choose(const FrameTimes& frame, const app::FrameLog& log) {
    chosen_ = frame;
    step_before_ = log.frames().back().step;
    if (go_to) go_to(frame.step);
}

float FrameView::height() {
    return 11 * ImGui::GetFontSize();
}

/// Draws the buttons, and returns the room for the heading beside them.
Rect FrameView::draw_buttons(const app::FrameLog& log) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float side = ImGui::GetTextLineHeight() + 2, pad = ImGui::GetStyle().FramePadding.x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    const auto worst = worst_frame(log);
    const std::string label = "worst " + (worst ? in_ms(worst->ms.work()) : std::string());
    const auto button = [&](const char* id, const std::string& text, float x, ImU32 color) {
        const float wide = text_width(text) + 2 * pad;
        ImGui::SetCursorScreenPos(ImVec2(x - wide, at.y));
        const bool pressed = ImGui::InvisibleButton(id, ImVec2(wide, side));
        const Rect place = item_rect();
        list.AddRectFilled(place.low, place.high,
                           ImGui::IsItemHovered() ? palette::hover : palette::raised,
                           ImGui::GetStyle().FrameRounding);
        draw_text(list, ImVec2(place.low.x + pad, at.y + 1), color, text);
        return std::pair(pressed, place);
    };
    const auto [closed, close_place] = button("close", "×", right, palette::dim);
    close_ = close_place;
    const auto [pressed, place] = button("worst", label, close_place.low.x - pad, palette::accent);
    worst_ = place;
    if (ImGui::IsItemHovered())
        show_tip("pause, and go to the step of the frame that worked longest");
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + side + 4));
    if (pressed && worst) choose(*worst, log);
    if (closed && close) close();
    return {at, ImVec2(std::max(at.x + 1, place.low.x - pad), at.y + side)};
}

void FrameView::draw_heading(const Rect& room) const {
    const Timings& ms = shown_->ms;
    const float wide = room.high.x - room.low.x;
    const std::string works = "works " + in_ms(ms.work());
    std::string text =
        "frame " + std::to_string(shown_->frame) + "   " + in_ms(ms.frame) + ", " + works;
    if (text_width(text) > wide) text = in_ms(ms.frame) + ", " + works;
    if (text_width(text) > wide) text = works;
    draw_text_fit(*ImGui::GetWindowDrawList(), room.low, palette::text, text, wide);
}

/// Returns the index of the frame under the mouse.
std::optional<std::size_t> FrameView::draw_bars(const app::FrameLog& log, double dt) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(bars_.low, bars_.high, palette::well);
    const auto& all = log.frames();
    const float each = (bars_.high.x - bars_.low.x) / static_cast<float>(app::FrameLog::most);
    double highest = 1.25 * 1000 * dt;
    for (const FrameTimes& frame : all) highest = std::max(highest, frame.ms.work());
    highest = std::min(highest, 8 * 1000 * dt);
    const float scale = (bars_.high.y - bars_.low.y) / static_cast<float>(highest);
    const float first = bars_.high.x - each * static_cast<float>(all.size());
    // Whole pixels, so that the gaps between bars are equal.
    const float gap = each >= 3 ? 1 : 0;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::optional<std::size_t> under;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const float x = std::floor(first + each * static_cast<float>(i));
        const float end = std::floor(first + each * static_cast<float>(i + 1));
        if (ImGui::IsItemHovered() && mouse.x >= x && mouse.x < end) under = i;
        float y = bars_.high.y;
        for (const Part& part : parts) {
            const float next =
                std::max(bars_.low.y, y - scale * static_cast<float>(all[i].ms.*part.ms));
            if (y - next > 0.05f)
                list.AddRectFilled(ImVec2(x, next), ImVec2(std::max(x + 1, end - gap), y),
                                   part.color);
            y = next;
        }
        const bool chosen = chosen_ && all[i].frame == chosen_->frame;
        if (under == i || chosen)
            list.AddRect(ImVec2(x - 1, bars_.low.y), ImVec2(end - gap + 1, bars_.high.y),
                         under == i ? palette::text : palette::accent);
    }
    const float line = bars_.high.y - scale * static_cast<float>(1000 * dt);
    list.AddLine(ImVec2(bars_.low.x, line), ImVec2(bars_.high.x, line),
                 with_alpha(palette::accent, 0.8f));
    // The text has a background, because bars may be behind it.
    const std::string text = in_ms(1000 * dt);
    const float high = ImGui::GetTextLineHeight();
    const ImVec2 at(bars_.low.x + 4, std::max(bars_.low.y, line - high));
    list.AddRectFilled(ImVec2(at.x - 2, at.y), ImVec2(at.x + text_width(text) + 2, at.y + high),
                       palette::well);
    draw_text(list, at, palette::accent, text);
    return under;
}

void FrameView::draw_flame(const Rect& place, const property::Tree& tree, bool newest) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double whole = std::max(1e-6, std::max(shown_->ms.frame, shown_->ms.work()));
    const float wide = place.high.x - place.low.x, row = ImGui::GetTextLineHeight() + 3;
    float x = place.low.x;
    for (const Part& part : parts) {
        const double ms = shown_->ms.*part.ms;
        const float end = x + wide * static_cast<float>(ms / whole);
        draw_box(list, {ImVec2(x, place.low.y), ImVec2(end, place.low.y + row)}, part.color,
                 part.name, ms);
        // The times of the parts of physics are known for the last step only.
        if (part.ms == &Timings::modules && newest) {
            float inner = x;
            for (const auto& [name, spent] : parts_of_physics(tree)) {
                const float to = std::min(end, inner + wide * static_cast<float>(spent / whole));
                draw_box(
                    list,
                    {ImVec2(inner, place.low.y + row + 1), ImVec2(to, place.low.y + 2 * row + 1)},
                    palette::rgb(0xa9d4fb), name, spent);
                inner = to;
            }
        }
        x = end;
    }
}

void FrameView::draw(ImVec2 corner, ImVec2 size, const property::Tree& tree,
                     const app::FrameLog& log, double dt, float opacity) {
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y - size.y));
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowBgAlpha(opacity);
    ImGui::Begin("##frames", nullptr, frame_flags);
    rect_ = window_rect();
    const Rect heading = draw_buttons(log);
    const float em = ImGui::GetFontSize(), pad = ImGui::GetStyle().WindowPadding.x;
    const float flame = 2 * (ImGui::GetTextLineHeight() + 3) + 2;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    bars_ = {ImVec2(rect_.low.x + pad, at.y),
             ImVec2(rect_.high.x - pad, std::max(at.y + em, rect_.high.y - pad - flame - 6))};
    ImGui::InvisibleButton(
        "bars", ImVec2(std::max(1.0f, bars_.high.x - bars_.low.x), bars_.high.y - bars_.low.y));
    const bool clicked = ImGui::IsItemClicked();
    const auto& all = log.frames();
    if (chosen_ && !all.empty() && all.back().step != chosen_->step &&
        all.back().step != step_before_)
        chosen_.reset();  // the game has gone on
    const auto under = draw_bars(log, dt);
    shown_.reset();
    if (!all.empty()) {
        shown_ = under ? all[*under] : chosen_ ? *chosen_ : all.back();
        // The newest frame is not complete yet.
        if (!under && !chosen_ && all.size() > 1 && shown_->ms.frame == 0)
            shown_ = all[all.size() - 2];
        draw_heading(heading);
        draw_flame(
            {ImVec2(bars_.low.x, bars_.high.y + 6), ImVec2(bars_.high.x, rect_.high.y - pad)}, tree,
            !under && !chosen_);
    }
    if (under) draw_tooltip(all[*under]);
    if (under && clicked) choose(all[*under], log);
    ImGui::End();
}

}  // namespace fettle::console
