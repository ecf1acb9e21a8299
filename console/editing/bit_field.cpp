#include <editing/bit_field.h>

#include <bit>

#include <look/theme.h>

namespace fettle::console {

namespace {

constexpr int all_bits = 64, columns = 8;

bool is_set(std::uint64_t bits, int bit) {
    return (bits >> bit & 1) != 0;
}

/// "bit 3", "bits 0, 2 to 5"
std::string list_of(std::uint64_t bits) {
    std::string out;
    const std::string begin = std::popcount(bits) == 1 ? "bit " : "bits ";
    for (int first = 0; first < all_bits; ++first) {
        if (!is_set(bits, first)) continue;
        int last = first;
        while (last + 1 < all_bits && is_set(bits, last + 1)) ++last;
        out += (out.empty() ? begin : ", ") + std::to_string(first);
        if (last > first) out += (last == first + 1 ? ", " : " to ") + std::to_string(last);
        first = last;
    }
    return out;
}

}  // namespace

std::string bits_text(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    if (bits == 0) return "none";
    if (~bits == 0) return "all";
    return std::popcount(bits) > all_bits / 2 ? "all but " + list_of(~bits) : list_of(bits);
}

std::optional<std::int64_t> bit_field(std::int64_t value, float width) {
    const auto bits = static_cast<std::uint64_t>(value);
    std::optional<std::int64_t> changed;
    const auto become = [&](std::uint64_t now) { changed = static_cast<std::int64_t>(now); };
    ImGui::SetNextItemWidth(width);
    const std::string text = bits_text(value);
    const float room = width - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
    const bool open =
        ImGui::BeginCombo("##value", shortened(text, room).c_str(), ImGuiComboFlags_HeightLargest);
    if (!open && ImGui::IsItemHovered()) show_tip(text + "\n" + std::to_string(value));
    if (!open) return changed;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const ImVec2 box(2 * ImGui::GetFontSize(), ImGui::GetFrameHeight());
    for (int bit = 0; bit < all_bits; ++bit) {
        if (bit % columns != 0) ImGui::SameLine(0, gap);
        const bool on = is_set(bits, bit);
        ImGui::PushStyleColor(ImGuiCol_Text, on ? palette::accent : palette::dim);
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::selection : palette::raised);
        if (ImGui::Button(std::to_string(bit).c_str(), box)) become(bits ^ std::uint64_t{1} << bit);
        ImGui::PopStyleColor(2);
    }
    if (low_button("all")) become(~std::uint64_t{0});
    ImGui::SameLine(0, gap);
    if (low_button("none")) become(0);
    ImGui::SameLine();
    ImGui::TextDisabled("= %lld", static_cast<long long>(value));
    ImGui::EndCombo();
    return changed;
}

}  // namespace fettle::console
