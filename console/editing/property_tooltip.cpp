// The tooltip of a property: its description in words.

#include <editing/property_editor.h>

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

using property::Property;
using property::Type;

std::string describe(const property::Tree& tree, const Property& property) {
    std::string out = property.any_type ? "any type" : std::string(type_name(property.type));
    if (property.type == Type::list && property.element != Type::nil)
        out += " of " + std::string(type_name(property.element));
    if (!property.reference_class.empty()) out += " to " + property.reference_class;
    if (!property.unit.empty()) out += " · " + property.unit;
    if (property.range.bounded())
        out += " · " + property::number_text(property.range.min, property.precision()) + " to " +
               property::number_text(property.range.max, property.precision());
    if (property.read_only)
        out += " · read-only";
    else if (!property.any_type)
        out += " · default " + tree.text(property.default_value, property.precision());
    return out;
}

void PropertyEditor::tooltip(const Target& target, ImFont* bold) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
    compat::push_font(bold);
    text_line(target.property->name);
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::dim);
    text_line(describe(tree_, *target.property));
    ImGui::PopStyleColor();
    if (!target.property->doc.empty()) {
        const FontScope font(fonts().sans);
        text_line(target.property->doc);
    }
    std::string sources;  // a mass has many
    for (const std::string& source : target.property->derives_from)
        sources += (sources.empty() ? "from " : ", ") + source;
    if (!sources.empty()) text_line(wrapped(sources, ImGui::GetFontSize() * 28));
    if (const property::Provenance written = tree_.who(target.instance, *target.property);
        written.known)
        text_line("written last by " + written.cause.text());
    ImGui::PushStyleColor(ImGuiCol_Text, palette::path);
    text_line(tree_.path(target.instance, *target.property));
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace fettle::console
