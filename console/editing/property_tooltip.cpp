// The tooltip of a property: its description in words.

#include <editing/property_editor.h>

#include <fettle/property/earlier_writer.h>
#include <fettle/script/reference.h>

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

void PropertyEditor::tooltip(const Target& target, ImFont* bold) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
    compat::push_font(bold);
    text_line(target.property->name);
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::dim);
    text_line(script::property_facts(tree_, *target.property));
    ImGui::PopStyleColor();
    if (!target.property->doc.empty()) {
        const FontScope font(fonts().sans);
        text_line(script::shown_doc(target.property->doc));
    }
    std::string sources;  // a mass has many
    for (const std::string& source : target.property->derives_from)
        sources += (sources.empty() ? "from " : ", ") + source;
    if (!sources.empty()) text_line(wrapped(sources, ImGui::GetFontSize() * 28));
    if (const std::string writer = last_writer_text(tree_, target.instance, *target.property);
        !writer.empty())
        text_line("written last by " + writer);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::path);
    text_line(tree_.path(target.instance, *target.property));
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace fettle::console
