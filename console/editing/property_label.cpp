// The name of a property in its row, and the width of the column of names.

#include <algorithm>
#include <cmath>

#include <editing/property_editor.h>
#include <look/theme.h>

namespace fettle::console {

using property::Property;
using property::Type;

namespace {

// The column of names has this part of a row, or up to the larger one where names need it.
constexpr float label_share = 0.40f, largest_label_share = 0.55f;
/// The fields of a vector have no room for the unit.
bool unit_is_in_label(const Property& property) {
    return property.type == Type::vec2 && !property.unit.empty();
}

/// Width of the place of a mark before each name.
float label_mark() {
    return ImGui::GetFontSize() * 0.7f;
}

}  // namespace

float PropertyEditor::component_width() {
    return text_width("x -0.0000") + 2 * ImGui::GetStyle().FramePadding.x;
}

float PropertyEditor::button_width() {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
}

void PropertyEditor::fit_labels(const std::vector<const Property*>& properties) {
    const FontScope font(fonts().sans);
    if (fitted_ == properties && fitted_size_ == ImGui::GetFontSize()) return;
    fitted_ = properties;
    fitted_size_ = ImGui::GetFontSize();
    widest_label_ = 0;
    for (const Property* each : properties)
        if (!each->hidden) widest_label_ = std::max(widest_label_, name_width(*each));
}

float PropertyEditor::label_column(float available) const {
    const float usual = available * label_share;
    // Names get no room that values need to show the two fields of a vector side by side.
    const float beside =
        available - 2 * component_width() - ImGui::GetStyle().ItemInnerSpacing.x - button_width();
    const float largest = beside >= usual ? beside : available * largest_label_share;
    return std::clamp(widest_label_, usual, largest);
}

float PropertyEditor::name_width(const Property& property) {
    float width = label_mark() + ImGui::GetStyle().ItemSpacing.x + text_width(property.name);
    if (unit_is_in_label(property)) width += text_width(" ") + text_width(property.unit);
    return std::ceil(width);
}

void PropertyEditor::label(const Target& target, float width, bool overridden, bool formula,
                           ImFont* bold) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float mark = label_mark();
    ImGui::Dummy(ImVec2(width - ImGui::GetStyle().ItemSpacing.x, ImGui::GetFrameHeight()));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float y = at.y + ImGui::GetStyle().FramePadding.y;
    const bool may_be = !target.property->read_only && define && ImGui::IsItemHovered();
    const bool on_mark = ImGui::IsItemHovered() && ImGui::GetIO().MousePos.x < at.x + 2 * mark;
    if (formula || may_be)
        draw_text(list, ImVec2(at.x - mark * 0.1f, y),
                  formula || on_mark ? palette::note : palette::faint, "ƒ");
    else if (overridden)
        list.AddCircleFilled(ImVec2(at.x + mark * 0.35f, at.y + ImGui::GetFrameHeight() / 2),
                             ImGui::GetFontSize() * 0.14f, palette::accent);
    ImU32 color = target.property->read_only ? palette::dim : palette::text;
    const FontScope font(fonts().sans);
    float room = width - mark - ImGui::GetStyle().ItemSpacing.x;
    if (unit_is_in_label(*target.property)) {
        const float unit = text_width(target.property->unit);
        draw_text(list, ImVec2(at.x + mark + room - unit, y), palette::dim, target.property->unit);
        room -= unit + text_width(" ");
    }
    draw_text_fit(list, ImVec2(at.x + mark, y), color, target.property->name, room);
    if (!ImGui::IsItemHovered()) return;
    if (ImGui::IsMouseClicked(1) && menu) menu(tree_.path(target.instance, *target.property));
    // A double click on the name does the same: the sign is small.
    if (may_be && ((on_mark && ImGui::IsMouseClicked(0)) || ImGui::IsMouseDoubleClicked(0)))
        begin_formula(*target.property);
    if (fields_.typing()) return;  // a tooltip could cover the field
    const FontScope mono(fonts().mono);
    tooltip(target, bold);
}

}  // namespace fettle::console
