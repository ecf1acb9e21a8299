#include <views/plot_view.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include <look/fields.h>
#include <look/theme.h>
#include <text/short_numbers.h>
#include <views/watch_list.h>

namespace fettle::console {

namespace {

constexpr int plot_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                           ImGuiWindowFlags_NoFocusOnAppearing;
constexpr double rows_wanted = 4;  // lines of the grid
constexpr float row_apart = 1.2f;  // at least, in heights of a line

float legend_line() {
    return ImGui::GetTextLineHeight() + 3;
}

/// 1, 2 or 5 times a power of ten, at least `span / rows`.
double spacing_for(double span, double rows = rows_wanted) {
    const double raw = span / rows;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= raw) return factor * power;
    return 10 * power;
}

/// The color of a line. The trace of a vector has two lines; `second`: the one of its y.
ImU32 color_of(const std::vector<Trace>& plots, std::size_t index, bool second) {
    if (plots[index].is_vector() && plots.size() == 1)
        return second ? palette::axis_y : palette::axis_x;
    const ImU32 color = series_color(index);
    return second ? with_alpha(color, 0.6f) : color;
}

/// The sample at the step, or the last before it; nullptr if there is none.
const Trace::Sample* sample_at(const Trace& trace, std::int64_t step) {
    const auto& all = trace.samples();
    auto found =
        std::upper_bound(all.begin(), all.end(), step,
                         [](std::int64_t s, const Trace::Sample& a) { return s < a.step; });
    return found == all.begin() ? nullptr : &*std::prev(found);
}

bool follows(const Trace::Sample& before, const Trace::Sample& after) {
    return after.step == before.step + 1;
}

}  // namespace

double value_between_labels(double span, float tall, float line) {
    const double rows = tall / (row_apart * line);
    return spacing_for(span, std::clamp(rows, 1.0, rows_wanted));
}

double seconds_between_labels(double seconds) {
    const double usual = spacing_for(seconds);
    return seconds < 2.2 * usual ? spacing_for(0.6 * seconds) : usual;
}

std::pair<double, double> shown_range(double low, double high) {
    // Numbers below 1e-6 are shown as 0: lines of the grid that are closer would all be "0".
    constexpr double least = 1e-5;
    const double size = std::max(std::abs(low), std::abs(high));
    if (size > 0 && size < least && high > low) {
        low = std::min(low, 0.0);
        high = std::max(low + least, high);
    }
    // Differences that come from rounding do not count.
    if (high - low < 1e-6 * std::max(size, 1e-6)) {
        const double room = size < 1e-6 ? 1 : 0.5 * size;
        low -= room;
        high += room;
    }
    const double edge = 0.04 * (high - low);  // the curve does not touch the frame
    return {low - edge, high + edge};
}

PlotView::Scale PlotView::scale_of(const std::vector<Trace>& plots, const Times& times) const {
    Scale scale;
    scale.last = std::max(times.newest, times.step);
    scale.first = std::min(times.oldest, scale.last - 1);
    bool any = false;
    for (const Trace& trace : plots)
        for (const Trace::Sample& s : trace.samples()) {
            if (s.step < scale.first) continue;
            const double other = trace.is_vector() ? s.y : s.x;
            scale.low = any ? std::min({scale.low, s.x, other}) : std::min(s.x, other);
            scale.high = any ? std::max({scale.high, s.x, other}) : std::max(s.x, other);
            any = true;
        }
    std::tie(scale.low, scale.high) = shown_range(scale.low, scale.high);
    return scale;
}

ImVec2 PlotView::point(const Scale& scale, std::int64_t step, double value) const {
    const double x = static_cast<double>(step - scale.first) /
                     static_cast<double>(std::max<std::int64_t>(1, scale.last - scale.first));
    const double y = (value - scale.low) / (scale.high - scale.low);
    return ImVec2(area_.low.x + (area_.high.x - area_.low.x) * static_cast<float>(x),
                  area_.high.y - (area_.high.y - area_.low.y) * static_cast<float>(y));
}

void PlotView::draw_grid(const Scale& scale, const Times& times, bool labels) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    const double apart =
        value_between_labels(scale.high - scale.low, area_.high.y - area_.low.y, line);
    for (double v = std::ceil(scale.low / apart) * apart; v <= scale.high; v += apart) {
        const float y = point(scale, scale.first, v).y;
        list.AddLine(ImVec2(area_.low.x, y), ImVec2(area_.high.x, y),
                     with_alpha(palette::line, 0.6f));
        const std::string text = short_number(std::abs(v) < apart * 1e-6 ? 0 : v);
        draw_text(list, ImVec2(area_.low.x - text_width(text) - 6, y - line / 2), palette::faint,
                  text);
    }
    const double seconds = static_cast<double>(scale.last - scale.first) * times.dt;
    const double tick = std::max(seconds_between_labels(seconds), times.dt);
    float labeled = rect_.high.x;  // the next label must end left of this
    for (double back = tick; back < seconds; back += tick) {
        const float x =
            area_.high.x - (area_.high.x - area_.low.x) * static_cast<float>(back / seconds);
        list.AddLine(ImVec2(x, area_.low.y), ImVec2(x, area_.high.y),
                     with_alpha(palette::line, 0.35f));
        const std::string text = "-" + short_number(back) + " s";
        const float half = text_width(text) / 2;
        if (!labels || x + half + 6 > labeled) continue;
        draw_text(list, ImVec2(x - half, area_.high.y + 2), palette::faint, text);
        labeled = x - half;
    }
}

void PlotView::draw_curves(const Scale& scale, const std::vector<Trace>& plots) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::vector<ImVec2> points;
    const double columns = std::max(2.0, static_cast<double>(area_.high.x - area_.low.x));
    for (std::size_t i = 0; i < plots.size(); ++i)
        for (const bool second : {false, true}) {
            if (second && !plots[i].is_vector()) continue;
            const auto& samples = plots[i].samples();
            const auto part = second ? &Trace::Sample::y : &Trace::Sample::x;
            const auto stride = std::max<std::size_t>(
                1, static_cast<std::size_t>(static_cast<double>(samples.size()) / columns));
            points.clear();
            const auto add = [&](const Trace::Sample& s) {
                if (s.step >= scale.first) points.push_back(point(scale, s.step, s.*part));
            };
            const auto draw = [&] {
                const ImU32 color = color_of(plots, i, second);
                if (points.size() == 1) list.AddCircleFilled(points.front(), 1.6f, color);
                list.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, 1.6f);
                points.clear();
            };
            // Draws the lowest and the highest sample of each column of pixels, so that no peak is
            // lost. At steps without a value the curve is interrupted.
            for (std::size_t k = 0; k < samples.size();) {
                const std::size_t end = std::min(k + stride, samples.size());
                std::size_t low = k, high = k;
                for (++k; k < end && follows(samples[k - 1], samples[k]); ++k) {
                    if (samples[k].*part < samples[low].*part) low = k;
                    if (samples[k].*part > samples[high].*part) high = k;
                }
                add(samples[std::min(low, high)]);
                if (low != high) add(samples[std::max(low, high)]);
                if (k == samples.size() || !follows(samples[k - 1], samples[k])) draw();
            }
        }
}

void PlotView::draw_cursor(const Scale& scale, const Times& times, std::int64_t step) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto upright = [&](std::int64_t at, ImU32 color) {
        const float x = point(scale, at, scale.low).x;
        list.AddLine(ImVec2(x, area_.low.y), ImVec2(x, area_.high.y), color);
    };
    if (times.step < scale.last) upright(times.step, palette::note);
    if (step >= 0) upright(step, palette::dim);
}

void PlotView::draw_legend(const property::Tree& tree, const std::vector<Trace>& plots,
                           std::int64_t step) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight() + 2;
    const float right = at.x + ImGui::GetContentRegionAvail().x - side - em;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    legend_.clear();
    std::string tip;
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const Trace& trace = plots[i];
        const Trace::Sample* s = step >= 0 ? sample_at(trace, step) : nullptr;
        property::Value shown = trace.value();
        if (s != nullptr)
            shown = trace.is_vector() ? property::Value(property::Vec2(s->x, s->y))
                    : shown.is(property::Type::boolean) ? property::Value(s->x != 0)
                                                        : property::Value(s->x);
        const bool fails = !trace.problem().empty();
        const std::string problem = trace.short_problem(tree);
        const float y = at.y + static_cast<float>(i) * legend_line();
        float x = at.x;
        list.AddRectFilled(ImVec2(x, y + em * 0.5f), ImVec2(x + em * 0.8f, y + em * 0.7f),
                           color_of(plots, i, false));
        if (trace.is_vector())
            list.AddRectFilled(ImVec2(x, y + em * 0.8f), ImVec2(x + em * 0.8f, y + em * 1.0f),
                               color_of(plots, i, true));
        x += em * 1.1f;
        const ObservedText value =
            fails ? ObservedText{problem}
                  : observed_text_in(tree, shown, trace.what().unit, trace.largest(),
                                     right - x - em - text_width(trace.what().text), right - x);
        // A long error leaves half of the line for the name.
        const float width = std::min(value.place(), fails ? (right - x) / 2 : right - x);
        const float name =
            std::max(em, std::min(text_width(trace.what().text), right - x - width - em));
        draw_path_fit(list, ImVec2(x, y), palette::text, trace.what().text, name);
        x += name + em * 0.5f;
        draw_text_fit(list, ImVec2(x, y), fails ? palette::error : palette::number, value.text,
                      std::max(1.0f, right - x));
        const Rect line{ImVec2(at.x, y), ImVec2(right, y + legend_line())};
        legend_.push_back({line, name, value.text});
        if (ImGui::IsWindowHovered() && line.contains(mouse.x, mouse.y))
            tip = trace.what().text + "\n" + (fails ? trace.problem() : tree.text(shown));
    }
    if (!tip.empty()) show_tip(tip);
    if (!run) return;  // a picture of the plot has no button
    ImGui::SetCursorScreenPos(ImVec2(right + em, at.y));
    const bool pressed = ImGui::InvisibleButton("close", ImVec2(side, side));
    close_ = item_rect();
    const bool hot = ImGui::IsItemHovered();
    draw_text(list, ImVec2(close_.low.x + (side - text_width("×")) / 2, at.y),
              hot ? palette::accent : palette::dim, "×");
    if (hot) show_tip("end the plot");
    if (pressed) run("plot()");
}

float PlotView::added_legend_height(std::size_t values) {
    return values < 2 ? 0 : static_cast<float>(values - 1) * legend_line();
}

void PlotView::draw(ImVec2 corner, ImVec2 size, float room, const property::Tree& tree,
                    const std::vector<Trace>& plots, const Times& times, float opacity) {
    if (plots.empty()) return hide();
    // Each value has a line of the legend; the curves keep their height as long as there is room.
    const float added = added_legend_height(plots.size()), legend = added + legend_line();
    size.y = std::min(size.y + added, room);
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y - size.y));
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowBgAlpha(opacity);
    ImGui::Begin("##plot", nullptr, plot_flags);
    rect_ = window_rect();
    const float em = ImGui::GetFontSize(), padding = ImGui::GetStyle().WindowPadding.y;
    area_ = {ImVec2(rect_.low.x + 5.5f * em, rect_.low.y + padding + legend + 0.4f * em),
             ImVec2(rect_.high.x - em, rect_.high.y - padding - 1.2f * em)};
    // A low plot has curves and no times below them.
    const bool times_fit = area_.high.y - area_.low.y >= 2 * em;
    if (!times_fit) area_.high.y = rect_.high.y - padding;
    if (area_.high.x < area_.low.x + em || area_.high.y < area_.low.y + em) {
        area_ = {};  // no room for curves
        draw_legend(tree, plots, -1);
        ImGui::End();
        return;
    }
    const Scale scale = scale_of(plots, times);
    const ImVec2 before = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(area_.low);
    ImGui::InvisibleButton("curves",
                           ImVec2(area_.high.x - area_.low.x, area_.high.y - area_.low.y));
    std::int64_t under = -1;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        const float share = std::clamp(
            (ImGui::GetIO().MousePos.x - area_.low.x) / (area_.high.x - area_.low.x), 0.0f, 1.0f);
        under = scale.first + std::llround(share * static_cast<double>(scale.last - scale.first));
    }
    if (ImGui::IsItemActive() && under >= times.oldest && under != requested_ && go_to) {
        requested_ = under;
        go_to(under);
    }
    if (!ImGui::IsItemActive()) requested_ = -1;
    ImGui::SetCursorScreenPos(before);
    ImGui::GetWindowDrawList()->AddRectFilled(area_.low, area_.high, palette::well);
    draw_grid(scale, times, times_fit);
    ImGui::GetWindowDrawList()->PushClipRect(area_.low, area_.high, true);
    draw_curves(scale, plots);
    draw_cursor(scale, times, under);
    ImGui::GetWindowDrawList()->PopClipRect();
    draw_legend(tree, plots, under);
    draw_menu();
    ImGui::End();
}

/// The menu of the right mouse button.
void PlotView::draw_menu() {
    constexpr const char* name = "##plot_menu";
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
        ImGui::IsMouseReleased(1))
        ImGui::OpenPopup(name);
    if (!ImGui::BeginPopup(name)) return;
    const auto item = [&](const char* label, const char* command) {
        const FontScope font(fonts().sans);
        if (ImGui::MenuItem(label) && run) run(command);
        menu_.emplace_back(label, item_rect());
    };
    menu_.clear();
    item("Export as CSV", "export_plot(\"csv\")");
    item("Export as PNG", "export_plot(\"png\")");
    item("End", "plot()");
    ImGui::EndPopup();
}

Rect PlotView::entry(std::string_view label) const {
    for (const auto& [text, rect] : menu_)
        if (text == label) return rect;
    return {};
}

}  // namespace fettle::console
