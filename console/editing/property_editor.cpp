#include <editing/property_editor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include <fettle/property/exception_text.h>

#include <editing/bit_field.h>
#include <look/imgui_compat.h>
#include <look/theme.h>

namespace fettle::console {

using property::Handle;
using property::List;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

Value PropertyEditor::zero_of(Type type) {
    switch (type) {
        case Type::boolean:
            return Value(false);
        case Type::integer:
            return Value(0);
        case Type::number:
            return Value(0.0);
        case Type::text:
            return Value("");
        case Type::vec2:
            return Value(Vec2(0, 0));
        case Type::color:
            return Value(property::Color{});
        case Type::list:
            return Value(List{});
        default:
            return Value();
    }
}

Rect PropertyEditor::widget_rect(const Property& property) const {
    auto found = widgets_.find(&property);
    return found == widgets_.end() ? Rect() : found->second;
}

std::string PropertyEditor::problem(const Property& property) const {
    auto found = problems_.find(&property);
    return found == problems_.end() ? std::string() : found->second;
}

// --- The row

bool PropertyEditor::written_by_simulation(Handle instance, const Property& property) const {
    const property::Provenance written = tree_.last_writer(instance, property);
    return written.known && written.cause.writer == property::Writer::simulation;
}

/// Whether a property is drawn by a row of the height of its layout, which is left out while it is
/// not visible.
bool PropertyEditor::is_plain(const Property& property) const {
    return property.type != Type::list && !property.any_type && mixed_.others().empty() &&
           !problems_.contains(&property) && tree_.formula_count() == 0 && !fields_.typing() &&
           !fields_.widget_has_focus() && !fields_.moves_focus();
}

PropertyEditor::Origin PropertyEditor::origin_of(Handle instance, const Property& property) const {
    Origin origin;
    if (const property::Formula* formula = tree_.formula(instance, property)) {
        origin.formula = true;
        origin.source = formula->source;
        origin.problem = tree_.problem(instance, property);
    }
    // A value that the simulation writes differs from the default without being set. Some modules
    // know it (`overridden`): they know whether a mass was set, but not whether it was a step that
    // made a body fall asleep.
    const bool computed = property.simulated && (property.binding.overridden == nullptr ||
                                                 written_by_simulation(instance, property));
    const bool set = origin.formula || (!computed && tree_.overridden(instance, property));
    origin.ad_hoc = property.binding.kind == property::BindingKind::ad_hoc;
    origin.resettable = !property.read_only && !origin.ad_hoc && set;
    return origin;
}

bool PropertyEditor::draw(Handle instance, const Property& property, ImFont* bold) {
    if (problems_of_ != instance) forget();
    problems_of_ = instance;
    edited_ = false;
    const Target target{instance, &property};
    const float whole = ImGui::GetContentRegionAvail().x;
    const float available = whole - gutter_width(whole);
    const RowLayout::Row row = layout_.row_of(property, available);
    if (is_plain(property) && !ImGui::IsRectVisible(ImVec2(whole, row.height))) {
        ImGui::Dummy(ImVec2(whole, row.height));
        return false;
    }
    ImGui::PushID(&property);
    const float start = ImGui::GetCursorPosX();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Origin origin = origin_of(instance, property);
    gutter(target, ImVec2(corner.x + available, corner.y), whole - available);
    ImGui::SetCursorScreenPos(corner);
    label(target, row.name, origin.resettable, origin.formula, bold);
    if (!row.name_above) ImGui::SameLine();
    ImGui::SetCursorPosX(start + row.value);
    bool gone = false;
    std::string mixed;
    try {
        // If a formula fails, its last valid value is shown, and the error below it.
        const Value value =
            origin.formula ? tree_.peek(instance, property) : tree_.get(instance, property);
        mixed = mixed_.text(tree_, property, value);
        ImGui::BeginGroup();
        if (!formula_line(target, origin.source, row.width))
            widget(target, value, row.width, row.value);
        ImGui::EndGroup();
        widgets_[&property] = item_rect();
        offer_menu(target);
        if (origin.resettable || origin.ad_hoc) {
            ImGui::SameLine(start + available - ImGui::GetFrameHeight());
            gone = reset_button(target);
        }
    } catch (const std::exception& error) {
        problems_[&property] = property::exception_text(error);
    }
    take_typed(target);
    if (!gone) {
        mixed_line(target, start, row.value, mixed);
        remarks(property, origin, start + row.value);
    }
    ImGui::PopID();
    return edited_;
}

/// Applies what was typed in this frame.
void PropertyEditor::take_typed(const Target& target) {
    const bool settled = fields_.consume_settled();
    if (const std::string expression = fields_.consume_formula(); !expression.empty())
        define_formula(target, expression);
    if (std::string typed = fields_.consume_problem(); !typed.empty()) {
        problems_[target.property] = typed;
        edited_ = true;  // an expression ran, which may have changed anything
    } else if (settled && !edited_) {
        problems_.erase(target.property);  // typing ended with the value that there was
    }
}

/// The lines below the widget: the formula, its error, and the error of the last edit.
void PropertyEditor::remarks(const Property& property, const Origin& origin, float left) {
    if (formula_of_ != &property) {
        remark(left, palette::note, origin.source.empty() ? "" : "is " + origin.source);
        if (!origin.source.empty() && ImGui::IsItemClicked(0)) begin_formula(property);
    }
    remark(left, palette::error, origin.problem);
    const std::string refused = problem(property);
    const bool fresh = !refused.empty() && refused != seen_problem_;
    if (!refused.empty()) seen_problem_ = refused;
    remark(left, palette::error, refused);
    if (fresh && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(1.0f);
    if (problems_.empty()) seen_problem_.clear();
}

void PropertyEditor::remark(float left, ImU32 color, const std::string& text) {
    if (text.empty()) return;
    ImGui::SetCursorPosX(left);
    ImGui::PushTextWrapPos(0);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    text_line(wrapped(text, ImGui::GetContentRegionAvail().x));
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

/// Always one line: values that change all the time must not move the rows below.
void PropertyEditor::mixed_line(const Target& target, float start, float indent,
                                const std::string& text) {
    if (text.empty()) return;
    ImGui::SetCursorPosX(start);
    const float whole = ImGui::GetContentRegionAvail().x;
    // A text that is too long for its place below the value begins below the name: always at the
    // same place, because it changes while the bodies move.
    const float left = text_width(text) <= whole - indent ? indent : ImGui::GetFontSize();
    const float room = whole - left;
    ImGui::SetCursorPosX(start + left);
    draw_text_fit(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), palette::dim, text,
                  room);
    ImGui::Dummy(ImVec2(std::max(1.0f, room), ImGui::GetTextLineHeight()));
    if (ImGui::IsItemHovered() && text_width(text) > room) show_tip(text);
    offer_menu(target);
}

/// A press of the right button on the item before opens the menu of the property.
void PropertyEditor::offer_menu(const Target& target) {
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1) && menu)
        menu(tree_.path(target.instance, *target.property));
}

bool PropertyEditor::reset_button(const Target& target) {
    if (target.property->binding.kind == property::BindingKind::ad_hoc) {
        if (!small_button("remove", "×", "remove this property")) return false;
        attempt(target, [&] { tree_.remove_ad_hoc(target.instance, target.property->name); });
        return !problems_.contains(target.property);
    }
    std::string tip =
        "back to " + tree_.text(target.property->default_value, target.property->precision());
    if (target.property->binding.reset != nullptr) tip = "back to what its owner computes";
    if (small_button("reset", "↺", tip.c_str()))
        attempt(target, [&] {
            edit_all(target, "reset " + target.property->name + " of all selected",
                     [&](Handle instance, const Property& property) {
                         tree_.reset(instance, property);
                     });
        });
    return false;
}

// --- Widgets

/// `before`: the room in front of the widget.
void PropertyEditor::widget(const Target& target, const Value& value, float width, float before) {
    Type type = value.is_nil() || target.property->any_type ? value.type() : target.property->type;
    // References can be followed even if they are read-only.
    bool greyed = target.property->read_only && type != Type::reference && type != Type::list;
    ImGui::BeginDisabled(greyed);
    switch (type) {
        case Type::nil:
            nil(target, width);
            break;
        case Type::boolean:
            boolean(target, value);
            break;
        case Type::integer:
        case Type::number:
            number(target, value, width);
            break;
        case Type::text:
            if (target.property->enumerators.empty())
                text(target, value, width);
            else
                enumerator(target, value, width);
            break;
        case Type::vec2:
            vector(target, value, width);
            break;
        case Type::color:
            color(target, value, width);
            break;
        case Type::reference:
            editable_reference(target, value.reference(), width);
            break;
        case Type::list:
            list(target, value, width, before);
            break;
    }
    ImGui::EndDisabled();
}

NumberLook PropertyEditor::look_of(const Property& property) {
    NumberLook look;
    look.unit = property.unit;
    look.range = property.range;
    look.precision = property.precision();
    return look;
}

void PropertyEditor::boolean(const Target& target, const Value& value) {
    bool checked = value.boolean();
    const bool clicked = ImGui::Checkbox("##value", &checked);
    if (fields_.focus_stop("##value"))
        write(target, Value(!value.boolean()));
    else if (clicked)
        write(target, Value(checked));
}

void PropertyEditor::number(const Target& target, const Value& value, float width) {
    if (target.property->bits && value.is(Type::integer)) {
        const auto changed = bit_field(value.integer(), width);
        if (fields_.focus_stop("##value")) compat::press("##value");
        if (changed) write(target, Value(*changed));
        return;
    }
    NumberLook look = look_of(*target.property);
    look.integer = value.is(Type::integer);
    auto changed = fields_.number("##value", value.as_double(), look, width);
    if (!changed) return;
    bool whole = look.integer && *changed == std::floor(*changed) && std::abs(*changed) < 9e15;
    write(target, whole ? Value(static_cast<std::int64_t>(*changed)) : Value(*changed));
}

void PropertyEditor::text(const Target& target, const Value& value, float width) {
    auto changed = fields_.text("##value", value.text(), width);
    if (!changed) return;
    if (define && changed->starts_with("is "))
        define_formula(target, changed->substr(3));
    else
        write(target, Value(*changed));
}

void PropertyEditor::enumerator(const Target& target, const Value& value, float width) {
    ImGui::SetNextItemWidth(width);
    const float room = width - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
    const std::string shown = shortened(value.text(), room);
    if (!ImGui::BeginCombo("##value", widget_text(shown).c_str())) {
        if (shown != value.text() && ImGui::IsItemHovered()) show_tip(value.text());
        const std::vector<std::string>& all = target.property->enumerators;
        if (!fields_.focus_stop("##value")) return;
        const auto now = std::ranges::find(all, value.text());
        write(target, Value(now == all.end() || now + 1 == all.end() ? all.front() : now[1]));
        return;
    }
    for (const std::string& name : target.property->enumerators) {
        bool current = name == value.text();
        if (ImGui::Selectable(widget_text(name).c_str(), current)) write(target, Value(name));
        if (current) ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
}

std::optional<Vec2> PropertyEditor::vector_fields(const Target& target, Vec2 value, float width) {
    NumberLook look = look_of(*target.property);
    look.unit = {};
    float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    float half = std::floor((width - gap) / 2);
    const bool beside = RowLayout::fits_two(width);
    look.label = "x";
    auto x = fields_.number("##x", value.x, look, beside ? half : width);
    if (beside) ImGui::SameLine(0, gap);
    look.label = "y";
    auto y = fields_.number("##y", value.y, look, beside ? width - gap - half : width);
    if (!x && !y) return std::nullopt;
    return Vec2(x.value_or(value.x), y.value_or(value.y));
}

void PropertyEditor::vector(const Target& target, const Value& value, float width) {
    if (auto changed = vector_fields(target, value.vec2(), width)) write(target, Value(*changed));
}

/// A square that opens the picker, and the color as text: "#e9ecef", a name, or "is" and a formula.
void PropertyEditor::color(const Target& target, const Value& value, float width) {
    property::Color c = value.color();
    std::array<float, 4> channels = {c.r, c.g, c.b, c.a};
    const int flags = ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_AlphaPreviewHalf |
                      ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_PickerHueWheel |
                      ImGuiColorEditFlags_DisplayHex;
    if (ImGui::ColorEdit4("##picker", channels.data(), flags))
        write(target, Value(property::Color{channels[0], channels[1], channels[2], channels[3]}));
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(0, gap);
    text(target, Value(property::color_text(c)), width - ImGui::GetFrameHeight() - gap);
}

void PropertyEditor::reference(Handle to, float width) {
    bool alive = tree_.alive(to);
    std::string name = alive ? tree_.path(to) : to ? "(deleted)" : "none";
    ImVec2 at = ImGui::GetCursorScreenPos();
    bool clicked =
        ImGui::InvisibleButton("link", ImVec2(std::max(1.0f, width), ImGui::GetFrameHeight()));
    bool hovered = alive && ImGui::IsItemHovered();
    ImVec2 text(at.x, at.y + ImGui::GetStyle().FramePadding.y);
    draw_path_fit(*ImGui::GetWindowDrawList(), text, alive ? palette::path : palette::dim, name,
                  width);
    if (hovered) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        float y = std::round(text.y + ImGui::GetTextLineHeight()) - 1;
        float end = text.x + std::min(width, text_width(name));
        ImGui::GetWindowDrawList()->AddLine(ImVec2(text.x, y), ImVec2(end, y), palette::path);
    }
    if (clicked && alive && follow) follow(to);
}

void PropertyEditor::editable_reference(const Target& target, Handle to, float width) {
    if (target.property->read_only || target.property->any_type) {
        reference(to, width);
        return;
    }
    reference(to, width - RowLayout::button_width());
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const auto chosen = references_.draw(*target.property, to);
    if (fields_.focus_stop("##choose")) compat::press("##choose");
    if (chosen) write(target, *chosen ? Value(*chosen) : Value());
}

void PropertyEditor::nil(const Target& target, float width) {
    Type type = target.property->type;
    if (type == Type::reference) {
        editable_reference(target, {}, width);
        return;
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("nil");
    if (target.property->read_only || type == Type::nil) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x * 2);
    if (width <= 0) return;
    const bool set = low_button("set");
    if (fields_.focus_stop("set") || set) write(target, zero_of(type));
}

}  // namespace fettle::console
