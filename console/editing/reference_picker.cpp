#include <editing/reference_picker.h>

#include <algorithm>
#include <utility>

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
    const property::Class* of =
        property.reference_class.empty() ? nullptr : tree_.find_class(property.reference_class);
    std::vector<std::pair<int, Handle>> found;  // how well each fits
    tree_.each_below(tree_.root(), [&](Handle instance) {
        if (of != nullptr && !tree_.class_of(instance).is_a(*of)) return;
        if (search_.empty()) {  // all fit, in the order of the tree
            if (found.size() < max_candidates) found.emplace_back(0, instance);
            return;
        }
        const auto by_name = script::fuzzy_score(search_, tree_.name(instance));
        const auto by_path = script::fuzzy_score(search_, tree_.path(instance));
        if (by_name || by_path)
            found.emplace_back(std::max(by_name.value_or(0), by_path.value_or(0)), instance);
    });
    std::ranges::stable_sort(found, std::ranges::greater{}, &std::pair<int, Handle>::first);
    candidates_.clear();
    if (property.nullable && search_.empty()) candidates_.push_back(Handle{});
    for (const auto& [score, instance] : found)
        if (candidates_.size() < max_candidates) candidates_.push_back(instance);
    marked_ = 0;
    taken_for_ = search_;
    stale_ = false;
}

/// The keys that move the mark while the search field has the keyboard.
bool ReferencePicker::move_mark() {
    if (candidates_.empty()) return false;
    const std::size_t before = marked_;
    if (compat::pressed(ImGuiKey_DownArrow, true))
        marked_ = std::min(marked_ + 1, candidates_.size() - 1);
    if (compat::pressed(ImGuiKey_UpArrow, true) && marked_ > 0) --marked_;
    return marked_ != before;
}

std::optional<Handle> ReferencePicker::draw(const property::Property& property, Handle current) {
    std::optional<Handle> chosen;
    const float em = ImGui::GetFontSize();
    const ImVec2 size(list_width * em, list_height * em);
    ImGui::SetNextWindowSizeConstraints(size, size);
    if (!ImGui::BeginCombo("##choose", nullptr, ImGuiComboFlags_NoPreview)) return chosen;
    if (ImGui::IsWindowAppearing()) {
        search_.clear();
        stale_ = true;
        compat::give_keyboard();
    }
    ImGui::SetNextItemWidth(-1);
    const bool searched = !search_.empty();
    // With CallbackHistory the field keeps the keys Up and Down, which would take the keyboard
    // away.
    const bool entered =
        input_line("##search", "search", search_,
                   ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory);
    // The first Escape only takes the keys from the field and clears its text; without a text, it
    // closes.
    const bool closes = !searched && compat::escape_pressed();
    if (stale_ || search_ != taken_for_) take_candidates(property);
    const bool moved = move_mark();
    if (entered && !candidates_.empty()) chosen = candidates_[marked_];
    ImGui::PushStyleColor(ImGuiCol_Header, palette::chosen);
    ImGui::BeginChild("list", ImVec2(0, 0), false, ImGuiWindowFlags_NoNav);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const Handle instance = candidates_[i];
        if (instance && !tree_.alive(instance)) continue;
        ImGui::PushID(static_cast<int>(instance.index));
        if (instance == current) ImGui::PushStyleColor(ImGuiCol_Text, palette::accent);
        const std::string path = instance ? widget_text(tree_.path(instance)) : "none";
        if (ImGui::Selectable(path.c_str(), i == marked_)) chosen = instance;
        if (instance == current) ImGui::PopStyleColor();
        if (moved && i == marked_) ImGui::SetScrollHereY();
        ImGui::PopID();
    }
    if (candidates_.empty()) ImGui::TextDisabled("nothing fits");
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (chosen || closes) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
    return chosen;
}

}  // namespace fettle::console
