#include <observed/last_value.h>
#include <views/overlay_bar.h>

#include <array>

#include <fettle/script/reference.h>

#include <look/theme.h>

namespace fettle::console {

using property::Handle;
using property::Property;
using property::Type;
using property::Value;

namespace {

/// Draws into a square around `c` with half the side `r`.
class Icon {
  public:
    Icon(ImDrawList& list, ImVec2 c, float r, ImU32 color)
        : list_(list), c_(c), r_(r), color_(color) {}
    ImVec2 at(float x, float y) const { return ImVec2(c_.x + r_ * x, c_.y - r_ * y); }
    void line(float x, float y, float to_x, float to_y, float width = 1.4f) {
        list_.AddLine(at(x, y), at(to_x, to_y), color_, width);
    }
    void dot(float x, float y, float size = 0.22f) {
        list_.AddCircleFilled(at(x, y), r_ * size, color_);
    }
    void ring(float x, float y, float size) {
        list_.AddCircle(at(x, y), r_ * size, color_, 0, 1.4f);
    }
    void box(float x, float y, float to_x, float to_y, bool filled = false) {
        if (filled)
            list_.AddRectFilled(at(x, to_y), at(to_x, y), color_);
        else
            list_.AddRect(at(x, to_y), at(to_x, y), color_, 0, 0, 1.4f);
    }
    void arrow(float x, float y, float to_x, float to_y) {
        line(x, y, to_x, to_y);
        const float dx = (to_x - x) * 0.35f, dy = (to_y - y) * 0.35f;
        line(to_x, to_y, to_x - dx - dy * 0.8f, to_y - dy + dx * 0.8f);
        line(to_x, to_y, to_x - dx + dy * 0.8f, to_y - dy - dx * 0.8f);
    }

  private:
    ImDrawList& list_;
    ImVec2 c_;
    float r_;
    ImU32 color_;
};

using Drawn = void (*)(Icon&);
struct Named {
    std::string_view name;
    Drawn draw;
};

// One line each, so that the table can be read.
// clang-format off
constexpr std::array<Named, 15> icons{{
    {"shapes", [](Icon& i) { i.ring(-0.3f, -0.3f, 0.55f); i.box(-0.1f, -0.1f, 0.9f, 0.9f); }},
    {"aabbs", [](Icon& i) { i.box(-0.9f, -0.9f, 0.9f, 0.9f); i.ring(0, 0, 0.55f); }},
    {"contacts", [](Icon& i) { i.line(-0.9f, -0.5f, 0.9f, -0.5f); i.dot(0, -0.5f); i.line(0, -0.5f, 0, 0.8f); }},
    {"joints", [](Icon& i) { i.line(-0.7f, -0.7f, 0.7f, 0.7f); i.dot(-0.7f, -0.7f); i.dot(0.7f, 0.7f); }},
    {"centers", [](Icon& i) { i.ring(0, 0, 0.85f); i.line(-0.5f, 0, 0.5f, 0); i.line(0, -0.5f, 0, 0.5f); }},
    {"velocities", [](Icon& i) { i.dot(-0.7f, -0.5f, 0.3f); i.arrow(-0.5f, -0.4f, 0.9f, 0.6f); }},
    {"names", [](Icon& i) { i.line(-0.7f, 0.7f, 0.7f, 0.7f); i.line(0, 0.7f, 0, -0.8f); }},
    {"islands", [](Icon& i) { i.box(-0.9f, -0.8f, -0.1f, 0, true); i.box(0.1f, -0.8f, 0.9f, 0); i.box(-0.4f, 0.2f, 0.4f, 0.9f, true); }},
    {"impulses", [](Icon& i) { i.line(-0.9f, -0.8f, 0.9f, -0.8f); i.arrow(-0.4f, -0.8f, -0.4f, 0.9f); i.arrow(0.5f, -0.8f, 0.5f, 0.1f); }},
    {"limits", [](Icon& i) { i.line(-0.7f, -0.7f, 0.9f, -0.7f); i.line(-0.7f, -0.7f, 0.2f, 0.8f); i.line(0.5f, 0.1f, 0.7f, -0.3f); i.line(0.2f, 0.4f, 0.5f, 0.1f); }},
    {"blame", [](Icon& i) { i.ring(0, 0.4f, 0.4f); i.line(-0.7f, -0.9f, -0.3f, -0.2f); i.line(0.7f, -0.9f, 0.3f, -0.2f); i.line(-0.3f, -0.2f, 0.3f, -0.2f); }},
    {"wires", [](Icon& i) { i.dot(-0.8f, 0.6f); i.dot(0.8f, -0.6f); i.line(-0.8f, 0.6f, 0, 0.6f); i.line(0, 0.6f, 0, -0.6f); i.line(0, -0.6f, 0.8f, -0.6f); }},
    {"onion_skins", [](Icon& i) { i.ring(-0.4f, 0, 0.5f); i.ring(0, 0, 0.5f); i.ring(0.4f, 0, 0.5f); }},
    {"grid", [](Icon& i) { for (const float at : {-0.6f, 0.0f, 0.6f}) { i.line(at, -0.9f, at, 0.9f, 1); i.line(-0.9f, at, 0.9f, at, 1); } }},
    {"timings", [](Icon& i) { i.box(-0.8f, -0.8f, -0.35f, 0.1f, true); i.box(-0.2f, -0.8f, 0.25f, 0.8f, true); i.box(0.4f, -0.8f, 0.85f, -0.2f, true); }},
}};
// clang-format on

/// Half the side of the square that an icon fills.
float icon_size() {
    return ImGui::GetFontSize() * 0.42f;
}

std::string label_of(const Property& property) {
    std::string label = property.name;
    for (char& c : label)
        if (c == '_') c = ' ';
    return label;
}

}  // namespace

Handle OverlayBar::show() const {
    const Handle view = tree_.child(tree_.root(), "view");
    return view ? tree_.child(view, "show") : Handle{};
}

int OverlayBar::lit() const {
    int count = 0;
    const Handle of = show();
    if (!of) return count;
    for (const Property* each : tree_.class_of(of).properties())
        if (each->type == Type::boolean && !each->read_only &&
            last_value(tree_, of, *each).boolean())
            ++count;
    return count;
}

Rect OverlayBar::button(const std::string& name) const {
    const auto found = buttons_.find(name);
    return found == buttons_.end() ? Rect() : found->second;
}

float OverlayBar::button_width(const Property& property, bool worded) {
    const float pad = ImGui::GetStyle().FramePadding.x, icon = 2 * icon_size();
    return worded ? text_width(label_of(property)) + 3 * pad + icon : 2 * pad + icon;
}

std::size_t OverlayBar::rows_of_words(const std::vector<const Property*>& shown) {
    const FontScope font(fonts().sans);
    const float room = ImGui::GetContentRegionAvail().x;
    float used = 0;
    std::size_t rows = 1;
    for (const Property* each : shown) {
        const float wide = button_width(*each, true);
        if (used > 0 && used + wide > room) {
            used = 0;
            ++rows;
        }
        used += wide + ImGui::GetStyle().ItemInnerSpacing.x;
    }
    return rows;
}

bool OverlayBar::draw_button(const Property& property, bool on, bool worded) {
    const FontScope font(fonts().sans);
    const float pad = ImGui::GetStyle().FramePadding.x, icon = icon_size();
    const ImVec2 size(button_width(property, worded), ImGui::GetTextLineHeight() + 4);
    const float left = ImGui::GetCursorPosX();
    if (left > ImGui::GetStyle().WindowPadding.x + 1 && ImGui::GetContentRegionAvail().x < size.x)
        ImGui::NewLine();
    const bool pressed = ImGui::InvisibleButton(property.name.c_str(), size);
    const Rect place = item_rect();
    buttons_[property.name] = place;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    list.AddRectFilled(place.low, place.high,
                       hovered ? palette::hover
                       : on    ? palette::chosen
                               : palette::raised,
                       ImGui::GetStyle().FrameRounding);
    const ImU32 color = on ? palette::accent : palette::dim;
    Icon drawn(list, ImVec2(place.low.x + pad + icon, place.middle().y), icon, color);
    for (const Named& each : icons)
        if (each.name == property.name) each.draw(drawn);
    if (worded)
        draw_text(list, ImVec2(place.low.x + 2 * pad + 2 * icon, place.low.y + 2), color,
                  label_of(property));
    if (hovered) show_tip("view.show." + property.name + "\n" + script::shown_doc(property.doc));
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    return pressed;
}

void OverlayBar::draw() {
    buttons_.clear();
    height_ = 0;
    const Handle of = show();
    if (!of) return;
    const float top = ImGui::GetCursorPosY();
    std::vector<const Property*> shown;
    for (const Property* each : tree_.class_of(of).properties())
        if (each->type == Type::boolean && !each->read_only) shown.push_back(each);
    constexpr std::size_t most_rows = 2;
    const bool worded = rows_of_words(shown) <= most_rows;
    for (const Property* each : shown) {
        const bool on = last_value(tree_, of, *each).boolean();
        if (!draw_button(*each, on, worded)) continue;
        const property::Tree::CauseScope cause(tree_, property::Writer::inspector);
        tree_.set(of, *each, Value(!on));
    }
    ImGui::NewLine();
    height_ = ImGui::GetCursorPosY() - top;
}

}  // namespace fettle::console
