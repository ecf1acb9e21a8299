// The name of a property in its row.

#include <editing/property_editor.h>
#include <look/theme.h>

namespace fettle::console {

void PropertyEditor::label(const Target& target, float width, bool overridden, bool formula,
                           ImFont* bold) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float mark = RowLayout::mark_width();
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
    if (RowLayout::unit_is_beside_name(*target.property)) {
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
