#include <look/fields.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <fettle/property/exception_text.h>

#include <look/extra_glyphs.h>
#include <look/imgui_compat.h>
#include <look/theme.h>
#include <text/short_numbers.h>

namespace fettle::console {

namespace {

constexpr double widest_share = 1e4;

int grow(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        auto& text = *static_cast<std::string*>(data->UserData);
        text.resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = text.data();
    }
    return 0;
}

std::string trimmed(std::string_view text) {
    std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
}

void draw_number_frame(ImVec2 low, ImVec2 high, double value, const NumberLook& look,
                       const std::string& digits) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGuiStyle& style = ImGui::GetStyle();
    bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    list.AddRectFilled(low, high,
                       ImGui::GetColorU32(hot ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       style.FrameRounding);
    double span = look.range.max - look.range.min;
    // In a very large range all usual values would fill the same part.
    if (span > 0 && span <= widest_share && std::isfinite(value)) {
        double part = std::clamp((value - look.range.min) / span, 0.0, 1.0);
        float x = low.x + static_cast<float>(part) * (high.x - low.x);
        if (x > low.x + 1)
            list.AddRectFilled(low, ImVec2(x, high.y), palette::share, style.FrameRounding);
    }
    float alpha = style.Alpha;
    ImVec2 at(low.x + style.FramePadding.x, low.y + style.FramePadding.y);
    if (!look.label.empty()) {
        ImU32 tint = look.label == "x" ? palette::axis_x : palette::axis_y;
        at.x += draw_text(list, at, with_alpha(tint, alpha), look.label) + style.FramePadding.x;
    }
    float room = high.x - style.FramePadding.x - at.x;
    const float unit = look.unit.empty() ? 0 : text_width(" ") + text_width(look.unit);
    std::string shown = look.integer ? digits : short_number(value);
    for (int precision = 4; precision > 0 && text_width(shown) + unit > room; --precision)
        shown = narrow_number(value, precision);
    draw_text_fit(list, at, with_alpha(palette::text, alpha), shown, std::max(1.0f, room - unit));
    const float used = std::min(text_width(shown), room - unit) + text_width(" ");
    if (!look.unit.empty())
        draw_text(list, ImVec2(at.x + used, at.y), with_alpha(palette::dim, alpha), look.unit);
    // While the user types, and in the tooltip, all digits are shown.
    if (shown != digits && ImGui::IsItemHovered() && !ImGui::IsItemActive())
        show_tip(look.unit.empty() ? digits : digits + " " + std::string(look.unit));
}

/// The part of a motion of the mouse that a drag follows.
double fineness() {
    const ImGuiIO& io = ImGui::GetIO();
    return io.KeyCtrl ? 0.01 : io.KeyShift ? 0.1 : 1;
}

// A field has one line, in which a line end is shown as a sign.
constexpr std::string_view line_end = "\n", line_end_sign = "↵";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

}  // namespace

bool input_line(const char* id, const char* hint, std::string& text, int flags) {
    ExtraGlyphs& extra = ExtraGlyphs::current();
    const bool lines = text.find(line_end) != std::string::npos;
    const auto meant = [&](const std::string& line) {
        const std::string typed = extra.meant(line);
        return lines ? replaced(typed, line_end_sign, line_end) : typed;
    };
    std::string line = extra.shown(lines ? replaced(text, line_end, line_end_sign) : text);
    // More different characters than there are stand-ins, or line ends beside their sign: it would
    // not come back as it was.
    if (line != text && meant(line) != text) flags |= ImGuiInputTextFlags_ReadOnly;
    const bool entered =
        ImGui::InputTextWithHint(id, hint, line.data(), line.capacity() + 1,
                                 flags | ImGuiInputTextFlags_CallbackResize, grow, &line);
    if ((flags & ImGuiInputTextFlags_ReadOnly) == 0) text = meant(line);
    return entered;
}

void Fields::start_typing(ImGuiID field, std::string text) {
    typing_ = field;
    focused_widget_ = 0;
    typing_active_ = false;
    typing_seen_ = true;
    frames_to_focus_ = 4;
    buffer_ = before_ = std::move(text);
    problem_.clear();
}

void Fields::begin_text(const char* id, std::string text) {
    start_typing(ImGui::GetID(id), std::move(text));
    before_ = "\n";  // no line that is typed equals it: Enter takes the text as it stands
}

/// Whether `move_focus` has arrived at the field, which is about to be drawn.
bool Fields::receives_focus(ImGuiID field, const std::string& text) {
    if (compat::disabled()) return false;
    if (focus_move_ == FocusMove::next && typing_ == 0 && focused_widget_ == 0) {
        focus_move_ = FocusMove::none;
        start_typing(field, text);
        if (!ImGui::IsRectVisible(ImVec2(1, ImGui::GetFrameHeight()))) ImGui::SetScrollHereY(0.5f);
        return true;
    }
    if (typing_ != 0 || focused_widget_ != 0 || focus_move_ != FocusMove::none)
        previous_ = {field, text, ImGui::GetCursorPosY()};
    return false;
}

bool Fields::focus_stop(const char* id) {
    const ImGuiID field = ImGui::GetID(id);
    if (compat::disabled()) return false;
    const float y = ImGui::GetCursorPosY();
    if (focused_widget_ != field) {
        if (focus_move_ != FocusMove::next || typing_ != 0 || focused_widget_ != 0) {
            if (typing_ != 0 || focused_widget_ != 0) previous_ = {field, {}, y, false};
            return false;
        }
        focus_move_ = FocusMove::none;
        focused_widget_ = field;
        pressed_ = false;
        if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
    }
    focused_widget_seen_ = true;
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        palette::accent, ImGui::GetStyle().FrameRounding);
    const bool pressed = std::exchange(pressed_, false);
    if (focus_move_ != FocusMove::none) {
        focused_widget_ = 0;
        focus_previous();
    }
    return pressed;
}

/// Goes back from the field that had the keyboard. The next one is not drawn yet: it
/// `receives_focus`.
void Fields::focus_previous() {
    if (focus_move_ != FocusMove::previous) return;
    focus_move_ = FocusMove::none;
    moved_before_first_ = previous_.field == 0;
    if (moved_before_first_) return;
    if (previous_.is_field) {
        start_typing(previous_.field, previous_.text);
    } else {
        focused_widget_ = previous_.field;
        focused_widget_seen_ = true;
    }
    const float y = previous_.y - ImGui::GetScrollY();
    if (y < 0) ImGui::SetScrollFromPosY(y, 0.5f);
}

void Fields::refuse() {
    if (committed_ == 0 || !by_enter_) return;
    focus_move_ = FocusMove::none;
    moved_before_first_ = false;
    typing_ = std::exchange(committed_, 0);
    typing_active_ = false;
    typing_seen_ = true;
    frames_to_focus_ = 4;
    buffer_ = committed_text_;
}

void Fields::end_frame() {
    committed_ = 0;
    // The edited field was not drawn: it is out of sight, or its property was deleted.
    if (typing_ != 0 && (!typing_seen_ || (!typing_active_ && frames_to_focus_ <= 0))) typing_ = 0;
    typing_seen_ = false;
    if (typing_ == 0) focus_move_ = FocusMove::none;  // there was no field
    if (!std::exchange(focused_widget_seen_, false)) focused_widget_ = 0;
    previous_ = {};
}

std::string Fields::consume_problem() {
    return std::exchange(problem_, {});
}

std::string Fields::consume_formula() {
    return std::exchange(formula_, {});
}

bool Fields::consume_settled() {
    return std::exchange(settled_, false);
}

std::optional<double> Fields::number(const char* id, double value, const NumberLook& look,
                                     float width) {
    ImGuiID field = ImGui::GetID(id);
    if (typing_ == field) return typed_number(id, look, width);
    std::string digits = look.integer && std::abs(value) < 9e15
                             ? std::to_string(static_cast<long long>(value))
                             : property::number_text(value, look.precision);
    if (receives_focus(field, digits)) return typed_number(id, look, width);
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImVec2 high(low.x + width, low.y + ImGui::GetFrameHeight());
    ImGui::InvisibleButton(id, ImVec2(std::max(1.0f, width), ImGui::GetFrameHeight()));
    draw_number_frame(low, high, value, look, digits);
    ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActivated()) {
        start_ = value;
        travelled_ = 0;
        moved_ = false;
        return std::nullopt;
    }
    if (ImGui::IsItemActive()) {
        moved_ = moved_ || std::abs(ImGui::GetMouseDragDelta(0, 0).x) > 2;
        if (!moved_ || io.MouseDelta.x == 0 || !std::isfinite(start_)) return std::nullopt;
        // The distance includes the part before the drag threshold.
        const float way = travelled_ == 0 ? ImGui::GetMouseDragDelta(0, 0).x : io.MouseDelta.x;
        travelled_ += way * fineness();
        double next = dragged(travelled_, look);
        if (next != value) return next;
    } else if (ImGui::IsItemDeactivated() && !moved_ && ImGui::IsItemHovered()) {
        start_typing(field, digits);
    }
    return std::nullopt;
}

// 250 pixels are the whole range. Without a range, and with one that only keeps values computable,
// as that of a position does, one pixel is one percent of the value. The result is rounded to the
// decimal place of one pixel, so that dragging gives round numbers.
double Fields::dragged(double pixels, const NumberLook& look) {
    constexpr double widest = 10'000;
    double span = look.range.max - look.range.min;
    double speed = span > 0 && span <= widest ? span / 250 : std::max(std::abs(start_), 1.0) * 0.01;
    if (look.integer) speed = std::max(speed, 0.1);
    double exponent = std::floor(std::log10(speed * fineness()));
    int decimals = look.integer ? 0 : static_cast<int>(std::clamp(-exponent, 0.0, 12.0));
    char text[400];
    std::snprintf(text, sizeof text, "%.*f", decimals, start_ + pixels * speed);
    return std::clamp(std::strtod(text, nullptr), look.range.min, look.range.max);
}

std::optional<double> Fields::parse(const std::string& typed, std::string_view unit) {
    std::string text = trimmed(typed);
    if (!unit.empty() && text.size() > unit.size() && text.ends_with(unit))
        text = trimmed(std::string_view(text).substr(0, text.size() - unit.size()));
    if (text.starts_with("is ")) {
        formula_ = trimmed(std::string_view(text).substr(3));
        return std::nullopt;
    }
    char* end = nullptr;
    double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0') return value;
    problem_ = "\"" + typed + "\" is not a number";
    if (calculate && !text.empty()) try {
            if (auto result = calculate(text)) {
                problem_.clear();
                return result;
            }
        } catch (...) {  // of the host; the widgets around the field have to be ended
            problem_ += ": " + property::exception_text();
        }
    refuse();
    return std::nullopt;
}

std::optional<double> Fields::typed_number(const char* id, const NumberLook& look, float width) {
    auto text = this->text(id, buffer_, width);
    if (!text) return std::nullopt;
    return parse(*text, look.unit);
}

std::optional<std::string> Fields::text(const char* id, const std::string& value, float width) {
    ImGuiID field = ImGui::GetID(id);
    bool mine = typing_ == field || receives_focus(field, value);
    ImGui::SetNextItemWidth(width);
    std::string passive = mine ? std::string() : value;
    if (mine && !typing_active_ && frames_to_focus_-- > 0) compat::give_keyboard();
    input_line(id, "", mine ? buffer_ : passive, ImGuiInputTextFlags_AutoSelectAll);
    bool active = ImGui::IsItemActive();
    if (!mine) {
        if (active) {  // the field has the focus, so its buffer is used from now on
            start_typing(field, std::move(passive));
            typing_active_ = typing_seen_ = true;
        }
        return std::nullopt;
    }
    typing_seen_ = true;
    const bool leaves = active && typing_active_ && focus_move_ != FocusMove::none;
    if (active && !leaves) {
        typing_active_ = true;
        return std::nullopt;
    }
    if (!typing_active_) return std::nullopt;  // the field gets the focus in the next frames
    typing_ = 0;
    typing_active_ = false;
    settled_ = true;
    by_enter_ = leaves || compat::enter_pressed();
    const std::string typed = std::exchange(buffer_, {});
    // Escape restores what the field of Dear ImGui began with, which may be a refused text.
    const bool same = typed == before_ || (!leaves && compat::escape_pressed());
    if (leaves) {
        compat::release_keyboard();
        focus_previous();
    }
    if (same) return std::nullopt;
    committed_ = field;
    committed_text_ = typed;
    return typed;
}

}  // namespace fettle::console
