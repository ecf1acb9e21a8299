// The gutter of the inspector: who wrote a property last. A click leads there.

#include <algorithm>
#include <utility>

#include <fettle/property/earlier_writer.h>

#include <editing/property_editor.h>
#include <look/theme.h>

namespace fettle::console {

using property::Cause;
using property::Provenance;
using property::Writer;

std::string writer_text(const Cause& cause) {
    // The position within a console command is not shown.
    const bool by_command =
        cause.where.starts_with("console:") || cause.where.starts_with("console ");
    if (!cause.where.empty() && !by_command) return cause.where;
    if (cause.writer == Writer::simulation) return "physics";
    return std::string(property::writer_name(cause.writer)) + ", step " +
           std::to_string(cause.step);
}

std::pair<std::string, int> script_place(const std::string& where) {
    const std::size_t colon = where.rfind(':');
    if (colon == std::string::npos || !where.substr(0, colon).ends_with(".lua")) return {};
    int line = 0;
    for (const char c : where.substr(colon + 1)) {
        if (c < '0' || c > '9' || line > 10'000'000) return {};
        line = 10 * line + (c - '0');
    }
    return {where.substr(0, colon), line};
}

float PropertyEditor::gutter_width(float available) {
    const float em = ImGui::GetFontSize();
    // From "physics" to "inspector, step 12345".
    return available >= wide_enough * em ? std::clamp(0.2f * available, 8 * em, 11 * em)
                                         : 0.8f * em;
}

void PropertyEditor::gutter(const Target& target, ImVec2 at, float width) {
    const Provenance written = tree_.last_writer(target.instance, *target.property);
    if (!written.known) return;
    const std::string text = writer_text(written.cause);
    const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos(at);
    const bool clicked = ImGui::InvisibleButton("writer", ImVec2(width, height));
    gutters_[target.property] = item_rect();
    const bool hovered = ImGui::IsItemHovered();
    const bool by_person =
        written.cause.writer == Writer::console || written.cause.writer == Writer::inspector;
    const ImU32 color = hovered ? palette::accent : by_person ? palette::note : palette::faint;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (width > 2 * em) {
        const FontScope font(fonts().sans);
        draw_path_fit(list, ImVec2(at.x + 0.4f * em, at.y + ImGui::GetStyle().FramePadding.y),
                      color, text, width - 0.4f * em);
    } else {
        const float middle = at.x + width / 2;
        list.AddRectFilled(ImVec2(middle - 1.5f, at.y + 0.2f * height),
                           ImVec2(middle + 1.5f, at.y + 0.8f * height), color, 1.5f);
    }
    if (hovered)
        show_tip("written last by " + last_writer_text(tree_, target.instance, *target.property));
    if (clicked && go_to_write)
        go_to_write(written.cause, tree_.path(target.instance, *target.property));
}

Rect PropertyEditor::gutter_rect(const property::Property& property) const {
    const auto found = gutters_.find(&property);
    return found == gutters_.end() ? Rect() : found->second;
}

}  // namespace fettle::console
