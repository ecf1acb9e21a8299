#include <views/watch_list.h>

#include <algorithm>
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
constexpr std::size_t most_name_rows = 3;

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
    // The curve of a value that is gone is grey.
    const auto color = [&](ImU32 living) {
        return trace.problem().empty() ? living : palette::faint;
    };
    stroke(&Trace::Sample::x, color(trace.is_vector() ? palette::axis_x : palette::note));
    if (trace.is_vector()) stroke(&Trace::Sample::y, color(palette::axis_y));
}

namespace {

/// The text in rows that are at most `width` wide; the last one is shortened if there are too many.
/// Rows end after a space, else before a point.
std::vector<std::string> in_rows(std::string_view text, float width) {
    std::vector<std::string> rows;
    while (rows.size() + 1 < most_name_rows && text_width(text) > width) {
        std::size_t fitting = code_point_offset(text, 1), space = 0, point = 0;
        for (std::size_t next = fitting; next < text.size();) {
            next += code_point_offset(text.substr(next), 1);
            if (text_width(text.substr(0, next)) > width) break;
            fitting = next;
            if (text[next - 1] == ' ') space = next;
            if (next < text.size() && text[next] == '.') point = next;
        }
        std::size_t end = fitting;
        for (const std::size_t at : {space, point})
            if (end == fitting && at > fitting / 2) end = at;
        rows.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    rows.push_back(shortened(text, width));
    return rows;
}

}  // namespace

/// `low`: the name is shortened beside the value, even where the whole name would fit above it.
WatchList::Row WatchList::row_of(const property::Tree& tree, const Trace& pin, float width,
                                 bool low) const {
    Row row;
    const float em = ImGui::GetFontSize(), side = ImGui::GetFrameHeight();
    // A text or a list has no curve.
    const bool curve = pin.samples().size() > 1;
    const double largest = pin.largest(sparkline_samples);
    const std::string& name = pin.what().text;
    const float name_width = text_width(name);
    // The curve leaves room for the whole name beside a short value.
    const float left = width - side - 2 * em - name_width -
                       observed_text(tree, pin.value(), pin.what().unit, largest, 2).place();
    const float widest_curve = std::min(6 * em, width * 0.22f);
    row.curve = curve ? std::clamp(left, widest_curve / 2, widest_curve) : 0;
    row.room = width - side - row.curve - em;
    const float widest = row.room * 0.65f;
    const auto value_in = [&](float room, float most) {
        return pin.problem().empty()
                   ? observed_text_in(tree, pin.value(), pin.what().unit, largest, room, most)
                   : ObservedText{pin.short_problem(tree)};
    };
    row.value = value_in(row.room - em - name_width, widest);
    row.value_width = std::min(row.value.place(), widest);
    row.name_width = row.room - row.value_width - em;
    if (name_width > row.name_width && !low) {
        row.above = in_rows(shortened(name, 1e9f), width - side - em);
        row.value = value_in(row.room - em, row.room - em);
        row.value_width = row.room - em;
    }
    row.height =
        ImGui::GetFrameHeight() + static_cast<float>(row.above.size()) * ImGui::GetTextLineHeight();
    return row;
}

void WatchList::draw_row(const property::Tree& tree, const Trace& pin, const Row& row,
                         float width) {
    const float em = ImGui::GetFontSize(), side = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    const float above = static_cast<float>(row.above.size()) * line, low = at.y + row.height;
    const float y = at.y + above + (side - line) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float shown = std::min(text_width(row.value.text), row.value_width);

    ImGui::InvisibleButton("text", ImVec2(std::max(1.0f, width - side), row.height));
    const bool hovered = ImGui::IsItemHovered();
    const bool path = !pin.what().path.empty();
    if (hovered) {
        list.AddRectFilled(at, ImVec2(at.x + width - side, low), palette::hover,
                           ImGui::GetStyle().FrameRounding);
        const std::string now = pin.problem().empty() ? tree.text(pin.value()) : pin.problem();
        show_tip(pin.what().text + "\n" + now);
    }
    if (path && ImGui::IsItemClicked(0) && follow) follow(pin.what().path);
    if (path && ImGui::IsItemClicked(1) && menu) menu(pin.what().path);
    const ImU32 color = path ? palette::path : palette::text;
    for (std::size_t i = 0; i < row.above.size(); ++i)
        draw_text(list,
                  ImVec2(at.x + em * 0.3f, at.y + static_cast<float>(i) * line + (side - line) / 2),
                  color, row.above[i]);
    if (row.above.empty())
        draw_path_fit(list, ImVec2(at.x + em * 0.3f, y), color, pin.what().text, row.name_width);
    draw_text_fit(list, ImVec2(at.x + row.room - shown, y),
                  pin.problem().empty() ? palette::number : palette::error, row.value.text, shown);
    draw_sparkline(list,
                   {ImVec2(at.x + row.room + em * 0.5f, low - side + 3),
                    ImVec2(at.x + row.room + row.curve, low - 3)},
                   pin);
    ImGui::SameLine(0, 0);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("unpin", ImVec2(side, row.height))) unpinned_ = pin.what().text;
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
    const auto rows_in = [&](float inside, bool low) {
        std::vector<Row> rows;
        rows.reserve(pins.size());
        for (const Trace& pin : pins) rows.push_back(row_of(tree, pin, inside, low));
        return rows;
    };
    const auto height_of = [&](const std::vector<Row>& rows) {
        float whole = 2 * style.WindowPadding.y - style.ItemSpacing.y;
        for (const Row& row : rows) whole += row.height + style.ItemSpacing.y;
        return whole;
    };
    float inside = width - 2 * style.WindowPadding.x;
    std::vector<Row> rows = rows_in(inside, false);
    // In a low window, a value in sight is worth more than the beginning of a name.
    const bool low = 2 * style.WindowPadding.y + rows.front().height > room;
    if (low) rows = rows_in(inside, true);
    const float whole = height_of(rows);
    const float height = std::max(1.0f, std::min(whole, room));
    // Dear ImGui decides by the last picture: a bar that was needed there would make the rows
    // narrower and higher, so that it stays.
    const bool scrolls = whole > room;
    if (scrolls) rows = rows_in(inside -= style.ScrollbarSize, low);
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y - height));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::SetNextWindowBgAlpha(opacity);
    const int bar = scrolls ? ImGuiWindowFlags_AlwaysVerticalScrollbar : 0;
    ImGui::Begin("##watch", nullptr,
                 scrolls ? (watch_flags & ~ImGuiWindowFlags_NoScrollbar) | bar : watch_flags);
    rect_ = window_rect();
    if (!scrolls) ImGui::SetScrollY(0);
    for (std::size_t i = 0; i < pins.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_row(tree, pins[i], rows[i], inside);
        ImGui::PopID();
    }
    ImGui::End();
    // The list changes only when all rows are drawn.
    if (!unpinned_.empty() && run) run("unpin(" + lua_string(std::exchange(unpinned_, {})) + ")");
}

}  // namespace fettle::console
