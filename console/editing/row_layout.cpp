#include <editing/row_layout.h>

#include <algorithm>
#include <cmath>

#include <look/theme.h>

namespace fettle::console {

using property::Property;
using property::Type;

namespace {

// The column of names has this part of a row, or down to the smaller one where values need room.
constexpr float name_share = 0.40f, least_name_share = 0.30f;
constexpr std::string_view longest_number = "-0.001235";  // of those with four digits
// Texts and paths may have any length.
constexpr std::string_view usual_text = "abcdefgh", usual_color = "#e9ecef80";
constexpr std::string_view usual_bits = "bits 0, 2 to 5", usual_list = "1000 values";

/// The width of a field with that text.
float field_width(std::string_view text) {
    return text_width(text) + 2 * ImGui::GetStyle().FramePadding.x;
}

float value_width(const Property& property) {
    const float square = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    if (property.any_type) return field_width(usual_text);
    switch (property.type) {
        case Type::boolean:
            return square;
        case Type::integer:
            if (property.bits) return field_width(usual_bits) + square;
            [[fallthrough]];
        case Type::number:
            return RowLayout::number_width({}, property.unit);
        case Type::vec2:
            return RowLayout::component_width();
        case Type::color:
            return square + gap + field_width(usual_color);
        case Type::reference:
            return text_width(usual_text) + RowLayout::button_width();
        case Type::list:
            return square + text_width(usual_list);
        default:
            break;
    }
    if (property.enumerators.empty()) return field_width(usual_text);
    float widest = 0;
    for (const std::string& each : property.enumerators)
        widest = std::max(widest, field_width(each));
    return widest + square;
}

float name_width(const Property& property) {
    const FontScope font(fonts().sans);
    float width =
        RowLayout::mark_width() + ImGui::GetStyle().ItemSpacing.x + text_width(property.name);
    if (RowLayout::unit_is_beside_name(property))
        width += text_width(" ") + text_width(property.unit);
    return std::ceil(width);
}

}  // namespace

bool RowLayout::unit_is_beside_name(const Property& property) {
    return property.type == Type::vec2 && !property.unit.empty();
}

float RowLayout::number_width(std::string_view label, std::string_view unit) {
    float width = field_width(longest_number);
    if (!label.empty()) width += text_width(label) + ImGui::GetStyle().FramePadding.x;
    if (!unit.empty()) width += text_width(" ") + text_width(unit);
    return std::ceil(width);
}

bool RowLayout::fits_two(float width) {
    return std::floor((width - ImGui::GetStyle().ItemInnerSpacing.x) / 2) >= component_width();
}

float RowLayout::mark_width() {
    return ImGui::GetFontSize() * 0.7f;
}

float RowLayout::button_width() {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
}

const RowLayout::Needs& RowLayout::needs(const Property& property) {
    const auto [found, fresh] = needs_.try_emplace(&property);
    if (fresh) found->second = {name_width(property), value_width(property)};
    return found->second;
}

void RowLayout::fit(const std::vector<const Property*>& properties) {
    if (fitted_ == properties && size_ == ImGui::GetFontSize()) return;
    fitted_ = properties;
    size_ = ImGui::GetFontSize();
    widest_name_ = 0;
    column_for_ = -1;
    needs_.clear();
    for (const Property* each : properties)
        if (!each->hidden) widest_name_ = std::max(widest_name_, needs(*each).name);
}

/// The width of the column of names: as wide as they need, but values get the room to show the two
/// fields of a vector side by side, or at least one number.
float RowLayout::usual_column(float available) const {
    const float room = available - button_width(), usual = available * name_share;
    const float two = 2 * component_width() + ImGui::GetStyle().ItemInnerSpacing.x;
    for (const float values : {two, component_width()})
        if (room - values >= available * least_name_share)
            return std::floor(std::min(std::max(widest_name_, usual), room - values));
    return std::floor(usual);
}

/// The column that leaves room for name and value of the most rows, as near to the usual one as
/// possible. The other rows have their names above their values.
float RowLayout::column(float available) {
    if (available == column_for_) return column_;
    const float room = available - button_width(), usual = usual_column(available);
    column_for_ = available;
    column_ = usual;
    int most = 0;
    for (const Property* widest : fitted_) {
        if (widest->hidden) continue;
        const float name = needs(*widest).name;
        float low = 0, high = room;
        int count = 0;
        for (const Property* each : fitted_) {
            const Needs& need = needs(*each);
            if (each->hidden || need.name > name || need.value > room - name) continue;
            low = std::max(low, need.name);
            high = std::min(high, room - need.value);
            ++count;
        }
        if (count < most) continue;
        const float at = std::floor(std::clamp(usual, low, high));
        if (count > most || std::abs(at - usual) < std::abs(column_ - usual)) column_ = at;
        most = count;
    }
    return column_;
}

RowLayout::Row RowLayout::row_of(const Property& property, float available) {
    const Needs& need = needs(property);
    const float room = available - button_width();
    Row row;
    const float values = column(available);
    row.name_above = need.name > values || need.value > room - values;
    row.value = row.name_above ? mark_width() : values;
    row.name = row.name_above ? std::min(need.name, available) : row.value;
    row.width = std::max(1.0f, room - row.value);
    const bool stacked = property.type == Type::vec2 && !fits_two(row.width);
    const int lines = (row.name_above ? 2 : 1) + (stacked ? 1 : 0);
    row.height = static_cast<float>(lines) * ImGui::GetFrameHeight() +
                 static_cast<float>(lines - 1) * ImGui::GetStyle().ItemSpacing.y;
    return row;
}

}  // namespace fettle::console
