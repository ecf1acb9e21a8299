#include <editing/reference_picker.h>

#include <imgui.h>

#include <fettle/script/fuzzy.h>

#include <look/fields.h>
#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

using property::Handle;

namespace {

constexpr std::size_t max_candidates = 500;
constexpr float list_width = 20, list_height = 14;  // font heights

}  // namespace

void ReferencePicker::take_candidates(const property::Property& property) {
    candidates_.clear();
    const property::Class* of =
        property.reference_class.empty() ? nullptr : tree_.find_class(property.reference_class);
    tree_.each_below(tree_.root(), [&](Handle instance) {
        if (candidates_.size() >= max_candidates) return;
        if (of != nullptr && !tree_.class_of(instance).is_a(*of)) return;
        if (!search_.empty() && !script::fuzzy_match(search_, tree_.path(instance))) return;
        candidates_.push_back(instance);
    });
    taken_for_ = search_;
    stale_ = false;
}

std::optional<Handle> ReferencePicker::draw(const property::Property& property, Handle current) {
    std::optional<Handle> chosen;
    if (ImGui::ArrowButton("choose", ImGuiDir_Down)) {
        search_.clear();
        stale_ = true;
        ImGui::OpenPopup("instances");
    }
    float em = ImGui::GetFontSize();
    ImGui::SetNextWindowSize(ImVec2(list_width * em, list_height * em));
    if (!ImGui::BeginPopup("instances")) return chosen;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool searched = !search_.empty();
    bool entered = input_line("##search", "search", search_, ImGuiInputTextFlags_EnterReturnsTrue);
    // The first Escape only takes the keys from the field and clears its text; without a text, it
    // closes.
    const bool closes = !searched && compat::escape_pressed();
    if (stale_ || search_ != taken_for_) take_candidates(property);
    if (entered && !candidates_.empty()) chosen = candidates_.front();
    ImGui::BeginChild("list");
    if (property.nullable && ImGui::Selectable("none", !current)) chosen = Handle{};
    for (Handle instance : candidates_) {
        if (!tree_.alive(instance)) continue;
        ImGui::PushID(static_cast<int>(instance.index));
        if (ImGui::Selectable(widget_text(tree_.path(instance)).c_str(), instance == current))
            chosen = instance;
        ImGui::PopID();
    }
    if (candidates_.empty()) ImGui::TextDisabled("nothing fits");
    ImGui::EndChild();
    if (chosen || closes) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace fettle::console
