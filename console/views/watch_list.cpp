#include <views/watch_list.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <look/fields.h>
#include <look/theme.h>
#include <text/short_numbers.h>
#include <text/utf8.h>

namespace fettle::console {

using property::Type;

namespace {

constexpr int watch_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
constexpr std::size_t sparkline_samples = 240;
constexpr std::size_t longest_text = 60;  // code points

}  // namespace

float ObservedText::place() const {
    return text_width(text) + static_cast<float>(spare) * text_width(" ");
}

ObservedText observed_text(const property::Tree& tree, const property::Value& value,
                           const std::string& unit, double largest, int digits) {
    ObservedText made;
    const auto number = [&](double n) {
        const std::string aligned = aligned_number(n, largest, digits);
        const std::size_t blanks = aligned.find_first_not_of(' ');
        made.spare += blanks;
        return aligned.substr(blanks);
    };
    std::string& text = made.text;
    if (value.is(Type::vec2)) {
        text = "(" + number(value.vec2().x);
        text += ", " + number(value.vec2().y) + ")";
    } else if (value.is(Type::number)) {
        text = number(value.number());
    } else {
        text = tree.text(value);
    }
    if (value.is(Type::integer)) {
        const std::size_t place = aligned_number(0, largest, digits).size();
        made.spare = std::max(place, text.size()) - text.size();
    }
    if (!unit.empty() && !value.is_nil()) text += " " + unit;
    if (code_point_count(text) > longest_text)
        text = text.substr(0, code_point_offset(text, longest_text)) + "…";
    return made;
}

ObservedText observed_text_in(const property::Tree& tree, const property::Value& value,
                              const std::string& unit, double largest, float room, float widest) {
    ObservedText made;
    for (const float limit : {std::min(room, widest), widest})
        for (int digits = 4; digits >= 2; --digits) {
            made = observed_text(tree, value, unit, largest, digits);
            if (made.place() <= limit) return made;
        }
    return made;
}

void draw_sparkline(ImDrawList& list, const Rect& rect, const Trace& trace) {
    const auto& samples = trace.samples();
    if (samples.size() < 2) return;
    const std::size_t first = samples.size() - std::min(samples.size(), sparkline_samples);
    double low = samples[first].x, high = low;
    for (std::size_t i = first; i < samples.size(); ++i) {
        const auto& s = samples[i];
        low = std::min({low, s.x, trace.is_vector() ? s.y : s.x});
        high = std::max({high, s.x, trace.is_vector() ? s.y : s.x});
    }
    const double span = high - low;
    const float wide = rect.high.x - rect.low.x, tall = rect.high.y - rect.low.y;
    std::vector<ImVec2> points;
    const auto stroke = [&](double Trace::Sample::*part, ImU32 color) {
        points.clear();
        for (std::size_t i = first; i < samples.size(); ++i) {
            const double share = span > 0 ? (samples[i].*part - low) / span : 0.5;
            points.emplace_back(rect.low.x + wide * static_cast<float>(i - first) /
                                                 static_cast<float>(samples.size() - 1 - first),
                                rect.high.y - tall * static_cast<float>(share));
        }
        list.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, 1.5f);
    };
    stroke(&Trace::Sample::x, trace.is_vector() ? palette::axis_x : palette::note);
    if (trace.is_vector()) stroke(&Trace::Sample::y, palette::axis_y);
}

void WatchList::draw_row(const property::Tree& tree, const Trace& pin, float width) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + (height - ImGui::GetTextLineHeight()) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // A text or a list has no curve.
    const bool curve = pin.samples().size() > 1;
    const double largest = pin.largest(sparkline_samples);
    const float side = height, path_width = text_width(pin.what().text);
    // The curve leaves room for the whole name beside a short value.
    const float left = width - side - 2 * em - path_width -
                       observed_text(tree, pin.value(), pin.what().unit, largest, 2).place();
    const float widest_curve = std::min(6 * em, width * 0.22f);
    const float spark = curve ? std::clamp(left, widest_curve / 2, widest_curve) : 0;
    const float room = width - side - spark - em;
    const float widest = room * 0.65f;
    const ObservedText value = pin.problem().empty()
                                   ? observed_text_in(tree, pin.value(), pin.what().unit, largest,
                                                      room - em - path_width, widest)
                                   : ObservedText{pin.problem()};
    const float value_width = std::min(value.place(), widest);
    const float shown = std::min(text_width(value.text), value_width);
    const float path_room = room - value_width - em;

    ImGui::InvisibleButton("text", ImVec2(std::max(1.0f, width - side), height));
    const bool hovered = ImGui::IsItemHovered();
    const bool path = !pin.what().path.empty();
    if (hovered) {
        list.AddRectFilled(at, ImVec2(at.x + width - side, at.y + height), palette::hover,
                           ImGui::GetStyle().FrameRounding);
        const std::string now = pin.problem().empty() ? tree.text(pin.value()) : pin.problem();
        show_tip(pin.what().text + "\n" + now);
    }
    if (path && ImGui::IsItemClicked(0) && follow) follow(pin.what().path);
    if (path && ImGui::IsItemClicked(1) && menu) menu(pin.what().path);
    draw_path_fit(list, ImVec2(at.x + em * 0.3f, y), path ? palette::path : palette::text,
                  pin.what().text, path_room);
    draw_text_fit(list, ImVec2(at.x + room - shown, y),
                  pin.problem().empty() ? palette::number : palette::error, value.text, shown);
    draw_sparkline(
        list,
        {ImVec2(at.x + room + em * 0.5f, at.y + 3), ImVec2(at.x + room + spark, at.y + height - 3)},
        pin);
    ImGui::SameLine(0, 0);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("unpin", ImVec2(side, height))) unpinned_ = pin.what().text;
    buttons_.push_back(item_rect());
    const bool hot = ImGui::IsItemHovered();
    draw_text(list, ImVec2(corner.x + (side - text_width("×")) / 2, y),
              hot ? palette::accent : palette::dim, "×");
    if (hot) show_tip("unpin");
}

void WatchList::draw(ImVec2 corner, float width, float room, const property::Tree& tree,
                     const std::vector<Trace>& pins, float opacity) {
    buttons_.clear();
    if (pins.empty()) return hide();
    ImGuiStyle& style = ImGui::GetStyle();
    const float rows = static_cast<float>(pins.size()) * ImGui::GetFrameHeightWithSpacing();
    const float height =
        std::max(1.0f, std::min(rows - style.ItemSpacing.y + 2 * style.WindowPadding.y, room));
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y - height));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::SetNextWindowBgAlpha(opacity);
    ImGui::Begin("##watch", nullptr, watch_flags & ~ImGuiWindowFlags_NoScrollbar);
    rect_ = window_rect();
    for (std::size_t i = 0; i < pins.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_row(tree, pins[i], ImGui::GetContentRegionAvail().x);
        ImGui::PopID();
    }
    ImGui::End();
    // The list changes only when all rows are drawn.
    if (!unpinned_.empty() && run) run("unpin(" + lua_string(std::exchange(unpinned_, {})) + ")");
}

}  // namespace fettle::console
