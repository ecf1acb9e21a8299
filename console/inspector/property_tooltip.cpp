// The tooltip of a property: its description in words.

#include <inspector/property_editor.h>

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
    ImGui::TextUnformatted(target.property->name.c_str());
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::dim);
    ImGui::TextUnformatted(describe(tree_, *target.property).c_str());
    ImGui::PopStyleColor();
    if (!target.property->doc.empty()) {
        const FontScope font(fonts().sans);
        ImGui::TextUnformatted(target.property->doc.c_str());
    }
    std::string sources;  // a mass has many
    for (const std::string& source : target.property->derives_from)
        sources += (sources.empty() ? "from " : ", ") + source;
    if (!sources.empty())
        ImGui::TextUnformatted(wrapped(sources, ImGui::GetFontSize() * 28).c_str());
    if (const property::Provenance written = tree_.who(target.instance, *target.property);
        written.known)
        ImGui::TextUnformatted(("written last by " + written.cause.text()).c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, palette::path);
    ImGui::TextUnformatted(tree_.path(target.instance, *target.property).c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace fettle::console
