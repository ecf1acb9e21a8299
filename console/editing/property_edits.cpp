// The writes of the editor: an edit is one step of undo, and changes all selected instances.

#include <exception>

#include <fettle/property/exception_text.h>

#include <editing/property_editor.h>

namespace fettle::console {

using property::Handle;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

/// As the history and `undo` name it.
std::string PropertyEditor::name_of_edit(const Target& target) const {
    if (mixed_.others().empty()) return "edit " + tree_.path(target.instance, *target.property);
    return "edit " + target.property->name + " of " + std::to_string(mixed_.others().size() + 1) +
           " selected instances";
}

void PropertyEditor::attempt(const Target& target, const std::function<void()>& edit) {
    edited_ = true;
    // All edits between press and release of the mouse are one step of undo.
    if (!dragging_ && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        dragging_ = true;
        tree_.begin_edit(name_of_edit(target), false);
    }
    try {
        property::Tree::CauseScope cause(tree_, property::Writer::inspector);
        edit();
        problems_.erase(target.property);
    } catch (const std::exception& error) {
        problems_[target.property] = property::exception_text(error);
        fields_.refuse();
    }
}

void PropertyEditor::define_formula(const Target& target, const std::string& expression) {
    if (!define) return;
    const property::Tree::CauseScope cause(tree_, property::Writer::inspector);
    std::string refused;
    // Typed into the field of x or y.
    if (target.property->type == Type::vec2 && fields_.calculate && fields_.calculate(expression))
        refused = "a formula is for the whole vector, as in is vec(x, y)";
    else
        edit_all(target, "formula of " + target.property->name,
                 [&](Handle to, const Property& its) {
                     const std::string why = define(tree_.path(to, its), expression);
                     if (refused.empty()) refused = why;
                 });
    problems_.erase(target.property);
    if (!refused.empty()) {
        problems_[target.property] = refused;
        fields_.refuse();
    }
    edited_ = true;
}

bool PropertyEditor::formula_line(const Target& target, const std::string& source, float width) {
    constexpr const char* id = "##formula";
    if (formula_begins_ == target.property) {
        formula_of_ = formula_begins_;
        formula_begins_ = nullptr;
        fields_.begin_text(id, "is " + source);
    }
    if (formula_of_ != target.property) return false;
    if (const auto typed = fields_.text(id, "", width)) {
        std::string_view expression = *typed;
        if (expression == "is" || expression.starts_with("is ")) expression.remove_prefix(2);
        const std::size_t begin = expression.find_first_not_of(' ');
        if (begin != std::string_view::npos)
            define_formula(target, std::string(expression.substr(begin)));
    }
    if (!fields_.types_into(id)) formula_of_ = nullptr;
    return true;
}

void PropertyEditor::begin_frame() {
    widgets_.clear();
    gutters_.clear();
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) end_drag();
}

void PropertyEditor::end_drag() {
    if (!dragging_) return;
    dragging_ = false;
    tree_.end_edit();
}

void PropertyEditor::edit_all(const Target& target, const std::string& name,
                              const std::function<void(Handle, const Property&)>& edit) {
    if (mixed_.others().empty()) return edit(target.instance, *target.property);
    tree_.begin_edit(name);
    std::exception_ptr problem;
    const auto try_edit = [&](Handle instance, const Property& property) {
        try {
            edit(instance, property);
        } catch (...) {
            if (!problem) problem = std::current_exception();
        }
    };
    try_edit(target.instance, *target.property);
    for (const Handle other : mixed_.others())
        if (const Property* same = MixedValues::same(tree_, other, *target.property))
            try_edit(other, *same);
    tree_.end_edit();
    if (problem) std::rethrow_exception(problem);
}

/// The new value of another instance after an edit from `before` to `after`: of a vector, only the
/// edited component changes.
Value PropertyEditor::edited(Handle instance, const Property& property, const Value& before,
                             const Value& after) const {
    if (!before.is(Type::vec2) || !after.is(Type::vec2)) return after;
    const Value old = tree_.peek(instance, property);
    if (!old.is(Type::vec2)) return after;
    Vec2 made = old.vec2();
    for (const int i : {0, 1})
        if (before.vec2()[i] != after.vec2()[i]) made[i] = after.vec2()[i];
    return Value(made);
}

void PropertyEditor::write(const Target& target, const Value& value) {
    attempt(target, [&] {
        const Value before = tree_.peek(target.instance, *target.property);
        edit_all(target, name_of_edit(target), [&](Handle instance, const Property& property) {
            tree_.set(instance, property, edited(instance, property, before, value));
        });
    });
}

}  // namespace fettle::console
