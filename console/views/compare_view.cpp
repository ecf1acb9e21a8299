#include <views/compare_view.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include <fettle/property/fixed_text.h>

#include <look/theme.h>

namespace fettle::console {

using property::Transform;
using property::Vec2;

namespace {

constexpr int compare_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing;
constexpr double rest = 0.8;  // s that the last moment stays
// In ems: around and between the pictures, their titles, the track.
constexpr float gap_ems = 0.4f, title_ems = 1.4f, track_ems = 2;

/// The dark line below makes the outline visible on any picture.
PenStyle outline_of(ImU32 color) {
    return {
        .color = color, .width = 1.5f, .glow = with_alpha(palette::well, 0.6f), .glow_width = 4};
}

/// The map of the world into a rectangle, as large as it fits.
class Window {
  public:
    Window(const Rect& place, const property::Seen& seen) : middle_(place.middle()) {
        const Vec2 size = (seen.upper - seen.lower).max({1e-6, 1e-6});
        scale_ = std::min(static_cast<double>(place.high.x - place.low.x) / size.x,
                          static_cast<double>(place.high.y - place.low.y) / size.y);
        center_ = 0.5 * (seen.lower + seen.upper);
    }
    Vec2 pixels(const Vec2& at) const {
        return {static_cast<double>(middle_.x) + scale_ * (at.x - center_.x),
                static_cast<double>(middle_.y) - scale_ * (at.y - center_.y)};
    }

  private:
    ImVec2 middle_;
    double scale_ = 1;
    Vec2 center_{0, 0};
};

/// Draws what was drawn at a moment, each thing at its place. `wanted`: for the index of a pose.
template <class Wanted>
void draw_moment(Pen& pen, const DrawnPast& past, const Comparison::Moment& moment, bool hidden_too,
                 const Wanted& wanted) {
    for (const DrawnPast::Item& item : *moment.items) {
        if (!wanted(item.pose)) continue;
        const bool placed = item.pose != DrawnPast::nowhere;
        pen.place(placed ? moment.poses[item.pose].map() : Transform());
        pen.draw_for(placed ? moment.poses[item.pose].instance.key() : 0);
        draw_figures(pen, past.drawing(item), hidden_too);
    }
}

}  // namespace

void CompareView::draw_title(const Rect& place, const std::string& name, const std::string& what,
                             ImU32 color) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    list.AddRectFilled(place.low, ImVec2(place.high.x, place.low.y + 1.4f * em), palette::raised);
    draw_text(list, ImVec2(place.low.x + 0.5f * em, place.low.y + 0.2f * em), color, name);
    const float room = std::max(1.0f, place.high.x - place.low.x - 4 * em);
    // A change begins with a path, and its value is at its end.
    draw_path_fit(list, ImVec2(place.low.x + 2 * em, place.low.y + 0.2f * em), palette::text, what,
                  room);
    const Rect bar{place.low, ImVec2(place.high.x - 1.4f * em, place.low.y + 1.4f * em)};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (text_width(what) > room && ImGui::IsWindowHovered() && bar.contains(mouse.x, mouse.y))
        show_tip(what);
}

/// Says at the lower edge of a run how its picture differs from what was seen then. `rows_below`:
/// notes below this one.
void CompareView::draw_note(const Rect& place, const std::string& whole, const std::string& brief,
                            int rows_below) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const FontScope font(fonts().sans);
    const float pad = 0.5f * ImGui::GetFontSize(), high = ImGui::GetTextLineHeight();
    std::string text = whole;
    const float room = place.high.x - place.low.x - 2 * pad;
    if (text_width(text) > room) text = brief;
    const float above = static_cast<float>(rows_below + 1) * (high + 4);
    const ImVec2 at(place.low.x + pad, place.high.y - above);
    const float wide = std::min(text_width(text), std::max(1.0f, room));
    list.AddRectFilled(ImVec2(at.x - 4, at.y - 2), ImVec2(at.x + wide + 4, at.y + high + 2),
                       palette::well, ImGui::GetStyle().FrameRounding);
    draw_text_fit(list, at, palette::dim, text, wide);
}

void CompareView::draw_side(const Rect& place, const Comparison& runs, bool second,
                            GamePictures& pictures) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(place.low, place.high, palette::well);
    list.PushClipRect(place.low, place.high, true);
    const Comparison::Moment& own = (second ? runs.b() : runs.a())[shown_];
    const Comparison::Moment& other = (second ? runs.a() : runs.b())[shown_];
    // A run without a window has shown no part of the world.
    const bool unseen = !(own.seen.upper.x > own.seen.lower.x);
    const Window window(place, unseen && runs.seen ? runs.seen() : own.seen);
    const ToPixels to_pixels = [&](Vec2 at) { return window.pixels(at); };
    Pen pen(list, to_pixels, {.as_drawn = true, .pictures = &pictures});
    draw_moment(pen, runs.drawn(), own, false, [](std::uint32_t) { return true; });
    // What the picture lacks, such as a body that a script draws, has an outline.
    Pen outline(list, to_pixels, outline_of(palette::note));
    draw_moment(outline, runs.drawn(), own, true, [&](std::uint32_t pose) {
        return pose != DrawnPast::nowhere && !pen.drew_for(own.poses[pose].instance.key());
    });
    outline.outline_pictures();
    for (const Pose& pose : own.poses) {
        if (pen.drew_for(pose.instance.key()) || outline.drew_for(pose.instance.key())) continue;
        const Vec2 at = window.pixels(pose.position);  // a dot shows where it is
        list.AddCircleFilled(ImVec2(static_cast<float>(at.x), static_cast<float>(at.y)), 3,
                             palette::note);
    }
    if (second) {  // a line shows where it is in A
        Pen line(list, to_pixels, outline_of(palette::accent));
        draw_moment(line, runs.drawn(), other, true, [&](std::uint32_t i) {
            return i < own.poses.size() && own.poses[i].instance == other.poses[i].instance &&
                   (own.poses[i].position - other.poses[i].position).length() > Comparison::apart;
        });
        line.outline_pictures();
    }
    list.PopClipRect();
}

void CompareView::play(const Comparison& runs, double seconds, double dt) {
    const std::size_t count = std::min(runs.a().size(), runs.b().size());
    const double length = static_cast<double>(count - 1) * dt;
    if (number_ != runs.number()) {  // a new comparison shows its end first
        number_ = runs.number();
        time_ = length;
    }
    if (!held_) time_ += seconds;
    if (time_ > length + rest) time_ = 0;
    shown_ = std::min(count - 1, static_cast<std::size_t>(std::max(0.0, time_ / dt)));
}

/// Draws the track below both sides; a press on it chooses the moment.
void CompareView::draw_track(const Comparison& runs, double dt) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(track_.low);
    ImGui::InvisibleButton("track", ImVec2(std::max(1.0f, track_.high.x - track_.low.x),
                                           std::max(1.0f, track_.high.y - track_.low.y)));
    held_ = ImGui::IsItemActive();
    const float wide = std::max(1.0f, track_.high.x - track_.low.x);
    const std::size_t last = runs.a().size() - 1;
    if (held_) {
        const float share =
            std::clamp((ImGui::GetIO().MousePos.x - track_.low.x) / wide, 0.0f, 1.0f);
        time_ = static_cast<double>(share) * static_cast<double>(last) * dt;
    }
    const float y = track_.middle().y;
    const float here = track_.low.x + wide * static_cast<float>(shown_) /
                                          static_cast<float>(std::max<std::size_t>(1, last));
    list.AddRectFilled(ImVec2(track_.low.x, y - 3), ImVec2(track_.high.x, y + 3), palette::well, 3);
    list.AddRectFilled(ImVec2(track_.low.x, y - 3), ImVec2(here, y + 3),
                       with_alpha(palette::accent, 0.6f), 3);
    list.AddCircleFilled(ImVec2(here, y), 6, palette::accent);
}

float CompareView::height(float width, float aspect) {
    const float em = ImGui::GetFontSize();
    const float picture = (width - 3 * gap_ems * em) / 2;
    return picture / aspect + (gap_ems + title_ems + track_ems) * em;
}

void CompareView::draw(const Rect& place, const Comparison& runs, GamePictures& pictures,
                       double seconds, double dt) {
    if (!runs.shown() || place.high.x - place.low.x < 100 ||
        place.high.y - place.low.y < least_height)
        return hide();
    play(runs, seconds, dt);
    ImGui::SetNextWindowPos(place.low);
    ImGui::SetNextWindowSize(ImVec2(place.high.x - place.low.x, place.high.y - place.low.y));
    ImGui::SetNextWindowBgAlpha(1);
    ImGui::Begin("##compare", nullptr, compare_flags);
    rect_ = window_rect();
    const float em = ImGui::GetFontSize(), gap = gap_ems * em, title = title_ems * em;
    const float middle = rect_.middle().x, low = rect_.high.y - track_ems * em;
    const Rect left{ImVec2(rect_.low.x + gap, rect_.low.y + gap), ImVec2(middle - gap / 2, low)};
    const Rect right{ImVec2(middle + gap / 2, rect_.low.y + gap), ImVec2(rect_.high.x - gap, low)};
    const auto below = [&](const Rect& side) {
        return Rect{ImVec2(side.low.x, side.low.y + title), side.high};
    };
    draw_side(below(left), runs, false, pictures);
    draw_side(below(right), runs, true, pictures);
    draw_title(left, "A", runs.original(), palette::dim);
    draw_title(right, "B", runs.change(), palette::accent);
    int notes = 0;
    if (runs.lacks_drawing())
        draw_note(left, "without what scripts draw in draw(pen)", "without draw(pen)", notes++);
    if (runs.drawn().full())
        draw_note(left, "later changes of shapes and colors are not kept", "old shapes", notes++);
    const std::string text = "step " + std::to_string(runs.a()[shown_].step) + "  " +
                             property::fixed_text(static_cast<double>(shown_) * dt, 2) + " s";
    draw_text(*ImGui::GetWindowDrawList(), ImVec2(rect_.low.x + gap, low + 0.4f * em), palette::dim,
              text);
    track_ = {ImVec2(rect_.low.x + 13 * em, low + 0.3f * em),
              ImVec2(rect_.high.x - em, rect_.high.y - 0.3f * em)};
    draw_track(runs, dt);
    ImGui::SetCursorScreenPos(ImVec2(right.high.x - title, right.low.y));
    const bool pressed = ImGui::InvisibleButton("close", ImVec2(title, title));
    close_ = item_rect();
    draw_text(*ImGui::GetWindowDrawList(),
              ImVec2(close_.low.x + 0.4f * em, close_.low.y + 0.2f * em),
              ImGui::IsItemHovered() ? palette::accent : palette::dim, "×");
    if (ImGui::IsItemHovered()) show_tip("end the comparison");
    if (pressed && close) close();
    ImGui::End();
}

}  // namespace fettle::console
