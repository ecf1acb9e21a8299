#include <views/time_bar.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fettle/property/fixed_text.h>

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

using property::Type;
using property::Value;

namespace {

constexpr int flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                      ImGuiWindowFlags_NoFocusOnAppearing;
constexpr float knob = 5;     // half its width in pixels
constexpr float tip_gap = 4;  // pixels between the bar and its tooltips

std::string seconds_text(double seconds) {
    return property::fixed_text(seconds, 2) + " s";
}

}  // namespace

// --- State and actions

Value TimeBar::value(const char* name) const {
    return time_value(tree_, name);
}

bool TimeBar::available() const {
    const Value newest = value("newest");
    return newest.is(Type::integer) && value("step").is(Type::integer) &&
           value("oldest").is(Type::integer) && value("paused").is(Type::boolean);
}

TimeBar::Times TimeBar::times() const {
    Times now;
    if (!available()) return now;
    now.step = value("step").integer();
    now.oldest = std::min(value("oldest").integer(), now.step);
    now.newest = std::max(value("newest").integer(), now.step);
    now.end = now.newest;
    for (const OtherBranch& branch : branches_) now.end = std::max(now.end, branch.newest);
    const Value dt = value("dt");
    now.dt = dt.is(Type::number) ? dt.number() : 1.0 / 60;
    now.paused = value("paused").boolean();
    now.halted = halted && halted();
    return now;
}

std::string TimeBar::play_back(double seconds) {
    return playing_back_.request(times(), seconds);
}

void TimeBar::play_on(bool drags) {
    const Times now = times();
    if (!playing_back_.play_on(now, drags) || !now.in_past() || !note) return;
    note("playing back ends at step " + std::to_string(now.step) +
         ": an edit was made here. When the game goes on, what came later becomes another branch");
}

/// The marks are those of the present branch.
void TimeBar::follow_branch() {
    std::map<std::string, std::int64_t> others;
    for (const OtherBranch& branch : branches_) others.emplace(branch.name, branch.fork);
    const Value name = value("branch");
    if (name.is(Type::text)) marks_.follow(name.text(), others);
}

// It runs as a command, so that a recording of the run contains it.
void TimeBar::go_to(std::int64_t step) {
    if (step == requested_) return;
    requested_ = step;
    const bool paused = times().paused;
    set_time_flag(tree_, "paused", true);
    if (!interpreter_.evaluate) return;
    const script::Evaluation result =
        interpreter_.evaluate("time:go_to(" + std::to_string(step) + ")");
    if (!result.error) return;
    requested_ = -1;
    set_time_flag(tree_, "paused", paused);
    if (report) report(result.error->message);
}

// --- Appearance

float TimeBar::height() const {
    return ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().WindowPadding.y + 14 +
           static_cast<float>(branches_.size()) * lane_height();
}

void TimeBar::draw(ImVec2 corner, float width, float opacity, ImFont* bold) {
    branches_ = other_branches(tree_);
    follow_branch();
    const Times now = times();
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y - height()));
    ImGui::SetNextWindowSize(ImVec2(std::max(120.0f, width), height()));
    ImGui::SetNextWindowBgAlpha(opacity);
    ImGui::Begin("##time", nullptr, flags);
    rect_ = window_rect();
    // Most tooltips have one line or two.
    tip_room_ =
        2 * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().WindowPadding.y + 2 * tip_gap;
    draw_branch_menu();
    const float lanes = static_cast<float>(branches_.size()) * lane_height();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lanes);
    draw_play(now);
    ImGui::SameLine();
    step_ = play_back_ = record_ = {};
    // In a narrow window the track needs the room of the longer texts, and of buttons.
    const float em = ImGui::GetFontSize(), short_text = text_width("00000.00 s now ") + 30;
    const float button = play_.high.x - play_.low.x + ImGui::GetStyle().ItemSpacing.x;
    const auto is_room = [&] {
        return ImGui::GetContentRegionAvail().x - button >= short_text + 5 * em;
    };
    if (is_room()) {
        draw_step(now);
        ImGui::SameLine();
    }
    if (is_room()) {
        draw_play_back(now);
        ImGui::SameLine();
    }
    if (records && is_room()) {
        draw_record();
        ImGui::SameLine();
    }
    const float room = ImGui::GetContentRegionAvail().x;
    // The texts of the newest moment have the most digits, so the track keeps its width in the
    // past.
    const std::string seconds = seconds_text(static_cast<double>(now.newest) * now.dt);
    float text =
        text_width(seconds + "  step " + std::to_string(now.newest) + "  to the present") + 40;
    const bool narrow = room - text < std::max(8 * em, room / 2);
    if (narrow) text = text_width(seconds + " now ") + 30;
    draw_track(now, std::max(40.0f, room - text));
    ImGui::SameLine();
    draw_text(now, bold, narrow);
    draw_lanes(now);
    ImGui::End();
}

/// Draws a tooltip above the bar, because below it would cover the bar.
void TimeBar::tip(const std::string& text) const {
    const float half = text_width(tip_lines(text)) / 2 + ImGui::GetStyle().WindowPadding.x;
    const float x = std::max(ImGui::GetIO().MousePos.x, rect_.low.x + half);
    ImGui::SetNextWindowPos(ImVec2(x, rect_.low.y - tip_gap), ImGuiCond_Always, ImVec2(0.5f, 1));
    show_tip(text);
}

/// Of a branch: high enough to be hit.
float TimeBar::lane_height() {
    return std::max(16.0f, ImGui::GetTextLineHeight() + 2);
}

bool TimeBar::icon(const char* id, Rect& place) {
    const float side = ImGui::GetTextLineHeight() + 12;
    const bool pressed = ImGui::InvisibleButton(id, ImVec2(side, side));
    place = item_rect();
    ImGui::GetWindowDrawList()->AddRectFilled(
        place.low, place.high, ImGui::IsItemHovered() ? palette::hover : palette::raised,
        ImGui::GetStyle().FrameRounding);
    return pressed;
}

void TimeBar::draw_play(const Times& now) {
    const bool pressed = icon("play", play_);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 c = play_.middle();
    const float r = (play_.high.y - play_.low.y) * 0.24f;
    if (now.stands()) {
        list.AddTriangleFilled(ImVec2(c.x - r * 0.8f, c.y - r), ImVec2(c.x - r * 0.8f, c.y + r),
                               ImVec2(c.x + r * 1.1f, c.y), palette::accent);
    } else {
        for (const float side : {-1.0f, 1.0f})
            list.AddRectFilled(ImVec2(c.x + side * r * 0.55f - r * 0.3f, c.y - r),
                               ImVec2(c.x + side * r * 0.55f + r * 0.3f, c.y + r), palette::text);
    }
    if (ImGui::IsItemHovered())
        tip(now.in_past() ? "go on from here: what came later becomes another branch"
            : now.halted  ? "go on after the error"
            : now.paused  ? "go on"
                          : "pause");
    if (!pressed) return;
    requested_ = -1;
    playing_back_.stop();
    if (now.halted && resume) {
        resume();
        return set_time_flag(tree_, "paused", false);
    }
    set_time_flag(tree_, "paused", !now.paused);
}

void TimeBar::draw_step(const Times& now) {
    const bool pressed = icon("step", step_);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 c = step_.middle();
    const float r = (step_.high.y - step_.low.y) * 0.22f;
    const ImU32 color = now.stands() ? palette::text : palette::faint;
    list.AddTriangleFilled(ImVec2(c.x - r, c.y - r), ImVec2(c.x - r, c.y + r),
                           ImVec2(c.x + r * 0.5f, c.y), color);
    list.AddRectFilled(ImVec2(c.x + r * 0.65f, c.y - r), ImVec2(c.x + r * 1.1f, c.y + r), color);
    if (ImGui::IsItemHovered()) tip(now.in_past() ? "one step on, as it was" : "one step");
    if (!pressed) return;
    if (now.in_past()) {
        go_to(now.step + 1);
    } else {
        if (now.halted && resume) resume();
        set_time_flag(tree_, "paused", true);
        set_time_flag(tree_, "step_once", true);
    }
}

void TimeBar::draw_play_back(const Times& now) {
    const bool pressed = icon("play back", play_back_);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 c = play_back_.middle();
    const float r = (play_back_.high.y - play_back_.low.y) * 0.22f;
    // An arrow that goes round.
    const ImU32 color = plays_back() ? palette::accent : palette::text;
    constexpr float from = -0.5f, to = 4.4f;  // rad
    list.PathArcTo(c, r, from, to, 20);
    list.PathStroke(color, 0, 1.6f);
    const ImVec2 tip_of(c.x + r * std::cos(from), c.y + r * std::sin(from));
    list.AddTriangleFilled(ImVec2(tip_of.x - r * 0.75f, tip_of.y - r * 0.15f),
                           ImVec2(tip_of.x + r * 0.65f, tip_of.y - r * 0.05f),
                           ImVec2(tip_of.x + r * 0.05f, tip_of.y - r * 0.95f), color);
    if (ImGui::IsItemHovered())
        tip(plays_back()    ? "stop here"
            : now.in_past() ? "play what follows, as it was"
                            : "play the whole past again, as it was");
    if (!pressed) return;
    if (plays_back())
        playing_back_.stop();
    else
        play_back(static_cast<double>(now.newest - now.oldest) * now.dt);
}

void TimeBar::draw_record() {
    const bool pressed = icon("record", record_);
    const bool on = records();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 c = record_.middle();
    const float r = (record_.high.y - record_.low.y) * 0.2f;
    if (on)
        list.AddRectFilled(ImVec2(c.x - r, c.y - r), ImVec2(c.x + r, c.y + r), palette::error);
    else
        list.AddCircleFilled(c, r, palette::error);
    if (ImGui::IsItemHovered())
        tip(on ? "end the recording" : "record the run, from its first step on, into a file");
    if (pressed && run) run(on ? "record(false)" : "record()");
}

void TimeBar::draw_track(const Times& now, float width) {
    const float tall = ImGui::GetTextLineHeight() + 12;
    ImGui::InvisibleButton("track", ImVec2(std::max(1.0f, width), tall));
    track_ = item_rect();
    const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    const bool right_click = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    const float mouse = ImGui::GetIO().MousePos.x;
    const TimeMark* const mark = hovered || held ? mark_at(now, mouse) : nullptr;
    const std::int64_t under = mark != nullptr ? step_of(now, *mark) : step_at(now, mouse);
    if (held) {
        playing_back_.stop();
        go_to(under);
    }
    if (!held && requested_ == now.step) requested_ = -1;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = track_.middle().y, half = 4;
    const float rounding = half;
    const float end = now.end > now.newest ? x_of(now, now.newest) : track_.high.x;
    list.AddRectFilled(ImVec2(track_.low.x, y - half), ImVec2(end, y + half), palette::well,
                       rounding);
    const float here = x_of(now, now.step);
    list.AddRectFilled(ImVec2(track_.low.x, y - half), ImVec2(here, y + half),
                       with_alpha(palette::accent, 0.55f), rounding);
    if (now.in_past())
        list.AddRectFilled(ImVec2(here, y - half), ImVec2(x_of(now, now.newest), y + half),
                           with_alpha(palette::note, 0.35f), rounding);
    draw_ruler(now);
    draw_marks(now);
    const float grown = held || hovered ? 1.5f : 0;
    list.AddCircleFilled(ImVec2(here, y), knob + 2 + grown, palette::panel);
    list.AddCircleFilled(ImVec2(here, y), knob + grown,
                         now.in_past() ? palette::note : palette::accent);
    if (hovered && !held) {
        const float at = x_of(now, under);
        list.AddLine(ImVec2(at, y - 2 * half), ImVec2(at, y + 2 * half), palette::dim);
    }
    if (hovered || held) {
        const double back = static_cast<double>(now.newest - under) * now.dt;
        tip("step " + std::to_string(under) +
            (back > 0 ? ", " + seconds_text(back) + " before the present"
                      : std::string(", the present")) +
            (mark != nullptr ? "\n" + mark->text : std::string()));
    }
    if (right_click) marks_.toggle_bookmark(under);  // `mark` may end here
}

float TimeBar::x_of(const Times& now, std::int64_t step) const {
    const auto span = static_cast<float>(std::max<std::int64_t>(1, now.end - now.oldest));
    const float left = track_.low.x + knob, wide = track_.high.x - knob - left;
    return left + wide * static_cast<float>(step - now.oldest) / span;
}

std::int64_t TimeBar::step_at(const Times& now, float x) const {
    const auto span = static_cast<float>(std::max<std::int64_t>(1, now.end - now.oldest));
    const float left = track_.low.x + knob, wide = track_.high.x - knob - left;
    const std::int64_t step =
        now.oldest + std::llround(std::clamp((x - left) / wide, 0.0f, 1.0f) * span);
    return std::min(step, now.newest);
}

/// The step at which a mark is drawn, and to which a click on it goes. A step that failed is not
/// kept: after going back, the mark of its error is at the last step before it.
std::int64_t TimeBar::step_of(const Times& now, const TimeMark& mark) {
    const bool failed = mark.kind == TimeMark::Kind::error && mark.step == now.newest + 1;
    return failed ? now.newest : mark.step;
}

/// The mark that is drawn there, the uppermost if there are several; null if there is none.
const TimeMark* TimeBar::mark_at(const Times& now, float x) const {
    constexpr float reach = 4;  // pixels
    const TimeMark* found = nullptr;
    for (const auto* marks : {&marks_.edits(), &marks_.others()})
        for (const TimeMark& mark : *marks)
            if (const std::int64_t step = step_of(now, mark);
                step >= now.oldest && step <= now.newest && std::fabs(x_of(now, step) - x) <= reach)
                found = &mark;
    return found;
}

/// Draws a stroke above the track for each mark, and a flag for a bookmark.
void TimeBar::draw_marks(const Times& now) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float low = track_.middle().y - 5, high = track_.low.y;
    // Where an edit is, another mark covers the upper half of its stroke only.
    std::vector<bool> edited(
        static_cast<std::size_t>(std::max(1.0f, track_.high.x - track_.low.x)));
    const auto column = [&](float x) {
        return std::min(static_cast<std::size_t>(std::max(0.0f, x - track_.low.x)),
                        edited.size() - 1);
    };
    for (const auto* marks : {&marks_.edits(), &marks_.others()})
        for (const TimeMark& mark : *marks) {
            const std::int64_t step = step_of(now, mark);
            if (step < now.oldest || step > now.newest) continue;
            const float x = std::floor(x_of(now, step));
            const ImU32 color = mark.kind == TimeMark::Kind::error  ? palette::error
                                : mark.kind == TimeMark::Kind::stop ? palette::number
                                : mark.kind == TimeMark::Kind::edit ? palette::path
                                                                    : palette::text;
            const std::size_t at = column(x);
            const auto begin =
                edited.begin() + static_cast<std::ptrdiff_t>(at - std::min<std::size_t>(at, 2));
            const auto end =
                edited.begin() + static_cast<std::ptrdiff_t>(std::min(at + 3, edited.size()));
            const bool edit = mark.kind == TimeMark::Kind::edit;
            const bool covers = !edit && std::find(begin, end, true) != end;
            if (edit) edited[at] = true;
            const float bottom = covers ? std::floor((high + low) / 2) : low;
            list.AddRectFilled(ImVec2(x - 1, high), ImVec2(x + 1, bottom), color);
            if (mark.kind == TimeMark::Kind::bookmark)
                list.AddTriangleFilled(ImVec2(x + 1, high), ImVec2(x + 7, high + 3),
                                       ImVec2(x + 1, high + 6), color);
        }
}

/// Draws a mark every second, or at the shortest interval that leaves room between marks.
void TimeBar::draw_ruler(const Times& now) const {
    const double span = static_cast<double>(now.end - now.oldest) * now.dt;
    const double wide = track_.high.x - track_.low.x - 2 * knob;
    if (!(span > 0) || wide <= 0) return;
    double apart = 1;
    for (const double more : {2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 1800.0})
        if (apart * wide / span < 8) apart = more;
    if (apart * wide / span < 8) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = track_.middle().y + 8;
    const double later = static_cast<double>(now.end - now.newest) * now.dt;  // than the present
    for (double back = 0; back <= span - later; back += apart) {
        const auto x = static_cast<float>(track_.high.x - knob - (back + later) / span * wide);
        const bool tenth = std::fmod(back, 10 * apart) == 0;
        list.AddLine(ImVec2(x, y), ImVec2(x, y + (tenth ? 5.0f : 3.0f)),
                     tenth ? palette::dim : palette::faint);
    }
}

void TimeBar::draw_text(const Times& now, ImFont* bold, bool narrow) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 at = ImGui::GetCursorScreenPos();
    at.x += 6;
    at.y = track_.middle().y - ImGui::GetTextLineHeight() / 2;
    compat::push_font(bold);
    at.x += console::draw_text(list, at, palette::text,
                               seconds_text(static_cast<double>(now.step) * now.dt));
    ImGui::PopFont();
    const std::string step = "  step " + std::to_string(now.step);
    if (!now.in_past()) {
        return_ = {};
        if (narrow) return;
        at.x += console::draw_text(list, at, palette::dim, step);
        if (branches_.empty()) return;
        const float room = rect_.high.x - at.x - ImGui::GetStyle().WindowPadding.x;
        if (room > 0)
            draw_text_fit(list, at, palette::accent, "  branch " + value("branch").text(), room);
        return;
    }
    at.x += 10;
    const std::string label = narrow ? "now" : "to the present";
    const float wide = text_width(label) + 12;
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y - 3));
    const bool pressed =
        ImGui::InvisibleButton("return", ImVec2(wide, ImGui::GetTextLineHeight() + 6));
    return_ = item_rect();
    if (narrow && ImGui::IsItemHovered()) tip("to the present");
    list.AddRectFilled(return_.low, return_.high,
                       ImGui::IsItemHovered() ? palette::hover : palette::raised,
                       ImGui::GetStyle().FrameRounding);
    console::draw_text(list, ImVec2(at.x + 6, at.y), palette::note, label);
    if (pressed) go_to(now.newest);
}

}  // namespace fettle::console
