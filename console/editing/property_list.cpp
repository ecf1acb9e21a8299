// The elements of a list.

#include <algorithm>

#include <editing/property_editor.h>
#include <look/theme.h>

namespace fettle::console {

using property::List;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

constexpr std::size_t visible_elements = 12;

/// A value after the others. A point is half a side away from the last one, and
/// bends to the left: a polygon drops a point that it has already, or that lies on a side.
Value added_to(const List& elements) {
    const Value& last = elements.back();
    if (!last.is(Type::vec2)) return last;
    const bool some = elements.size() > 1 && elements[elements.size() - 2].is(Type::vec2);
    Vec2 side = some ? last.vec2() - elements[elements.size() - 2].vec2() : Vec2(0, 0);
    if (side == Vec2(0, 0)) side = Vec2(1, 0);
    return Value(last.vec2() + 0.35 * Vec2(side.x - side.y, side.x + side.y));
}

/// The room that an element needs beside its number and its button.
float needed_by(const Value& element, const Property& property) {
    if (element.is(Type::vec2))
        return 2 * RowLayout::component_width() + ImGui::GetStyle().ItemInnerSpacing.x;
    return element.is_numeric() ? RowLayout::number_width({}, property.unit) : 0;
}

float number_column(std::size_t elements) {
    return text_width(std::to_string(elements)) + ImGui::GetStyle().ItemSpacing.x;
}

}  // namespace

void PropertyEditor::list(const Target& target, const Value& value, float width, float before) {
    const List& elements = value.list();
    std::string head =
        elements.size() == 1 ? "1 value" : std::to_string(elements.size()) + " values";
    int flags = ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_FramePadding |
                ImGuiTreeNodeFlags_SpanAvailWidth;
    const bool open = ImGui::TreeNodeEx("##list", flags, "%s", head.c_str());
    if (fields_.focus_stop("##list"))
        ImGui::GetStateStorage()->SetBool(ImGui::GetID("##list"), !open);
    if (!open) return;
    const float remove = target.property->read_only ? 0 : RowLayout::button_width();
    const bool scrolls = elements.size() > visible_elements;
    const float beside =
        number_column(elements.size()) + remove + (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
    const float needed =
        beside + (elements.empty() ? 0 : needed_by(elements.front(), *target.property));
    const float wider = std::clamp(needed - width, 0.0f, before);
    const bool stacked = !elements.empty() && elements.front().is(Type::vec2) &&
                         !RowLayout::fits_two(width + wider - beside);
    const float row = ImGui::GetFrameHeightWithSpacing() * (stacked ? 2 : 1);
    const auto shown = static_cast<float>(std::min(elements.size(), visible_elements));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - wider);
    ImGui::BeginChild("elements", ImVec2(width + wider, row * shown));
    const float inner = ImGui::GetContentRegionAvail().x;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(elements.size()), row);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            element(target, elements, static_cast<std::size_t>(i), inner);
            ImGui::PopID();
        }
    ImGui::EndChild();
    if (target.property->read_only) return;
    if (low_button("+ add")) {
        List longer = elements;
        const Type type = target.property->element;
        longer.push_back(elements.empty() ? zero_of(type == Type::nil ? Type::number : type)
                                          : added_to(elements));
        write(target, Value(std::move(longer)));
    }
}

void PropertyEditor::element(const Target& target, const List& elements, std::size_t index,
                             float width) {
    bool fixed = target.property->read_only;
    float remove = fixed ? 0 : RowLayout::button_width();
    std::string number = std::to_string(index + 1);
    float digits = number_column(elements.size());
    float start = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", number.c_str());
    ImGui::SameLine(start + digits);
    float room = width - digits - remove;
    ImGui::BeginGroup();  // a vector may have two lines
    const Value& old = elements[index];
    std::optional<Value> changed;
    bool gone = false;
    if (old.is(Type::reference)) {
        reference(old.reference(), room);
    } else {
        ImGui::BeginDisabled(fixed);
        if (old.is(Type::vec2)) {
            if (auto v = vector_fields(target, old.vec2(), room)) changed = Value(*v);
        } else if (old.is_numeric()) {
            NumberLook look = look_of(*target.property);
            look.integer = old.is(Type::integer);
            if (auto v = fields_.number("##value", old.as_double(), look, room))
                changed = look.integer ? Value(static_cast<std::int64_t>(*v)) : Value(*v);
        } else if (old.is(Type::text)) {
            if (auto v = fields_.text("##value", old.text(), room)) changed = Value(*v);
        } else {
            text_line(tree_.text(old, target.property->precision()));
        }
        ImGui::EndDisabled();
    }
    ImGui::EndGroup();
    if (!fixed) {
        ImGui::SameLine(start + width - ImGui::GetFrameHeight());
        gone = small_button("remove", "×", "remove this value");
    }
    if (!changed && !gone) return;
    List edited = elements;
    if (gone)
        edited.erase(edited.begin() + static_cast<std::ptrdiff_t>(index));
    else
        edited[index] = *changed;
    write(target, Value(std::move(edited)));
}

}  // namespace fettle::console
