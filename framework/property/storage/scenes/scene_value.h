#pragma once
// Values as they stand in scene files. What a property declares need not be said again: a number is
// 2, a vec2 [1, 2], a color "#ff8800", a reference ".ball". Where nothing is declared (ad-hoc
// properties, lists of anything) a number has a point, and what JSON has no form for carries its
// type: {"vec2": [1, 2]}, {"number": "inf"}.

#include <functional>
#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// The type a value of the property is written as; nil where it must say its own.
inline Type declared_type(const Property& property) {
    return property.any_type ? Type::nil : property.type;
}

/// Writes the values of one scene, whose topmost instance is `top`.
class ValueWriter {
  public:
    ValueWriter(const Tree& tree, Handle top) : tree_(tree), top_(top) {}

    /// On one line; a list that would pass column 100 gets a line for each element. `column`: where
    /// it starts; `indent`: of the line it starts on. Throws Error.
    void append(std::string& out, const Property& property, const Value& value, std::size_t column,
                std::size_t indent) const;
    /// The same for a formula with its last value. False, with `out` as it was, when its text is
    /// not UTF-8.
    bool append(std::string& out, const Property& property, const Formula& formula,
                const Value& value) const;

    /// ".ball.circle" for what is inside the scene ("." its top), "world.floor" for what is not.
    /// Throws Error for what no path leads to.
    std::string reference(Handle target) const;

  private:
    void append(std::string& out, Type type, Type element, Precision precision,
                const Value& value) const;
    void append_number(std::string& out, double number, Precision precision, bool declared) const;
    void append_text(std::string& out, const std::string& text) const;
    void append_color(std::string& out, Color color) const;
    void append_reference(std::string& out, Handle target, bool declared) const;

    const Tree& tree_;
    Handle top_;
};

/// Finds the instance a reference in a file names; throws SceneError at `node`.
using ReferenceResolver =
    std::function<Handle(const std::string& path, const Document::Node& node)>;

/// A formula in a file: `{"is": "world.ball.mass * 2", "value": 4}`, its text and the last value it
/// had, for whoever cannot compute it.
struct FormulaText {
    const Document::Node* is = nullptr;
    const Document::Node* value = nullptr;  // null: not told
    explicit operator bool() const { return is != nullptr; }
};

/// Empty when the node is a plain value. Throws SceneError for an object that is neither.
FormulaText formula_text(const Document& document, const Document::Node& node);

/// The formula of that text. Where nobody can compute it, one that keeps `value` and the text.
/// Throws Error for a text that does not compile.
Formula make_formula(const Tree& tree, const std::string& source, const Value& value);

/// The same for a formula in a file; a text that does not compile is a SceneError at its place.
Formula made_formula(const Tree& tree, const Document& document, const FormulaText& formula,
                     const Value& value);

/// Throws Error for what a scene tells by the keys of an instance: its name, its parent.
void require_told_as_property(const Property& property);

/// What a value in a file says, read as one of `type` whose elements, if it is a list, are of type
/// `element`. A value that says something else is returned as what it is, for the property to
/// refuse or convert. Throws SceneError for what is no value.
Value read_value(const Document& document, const Document::Node& node, Type type, Type element,
                 const ReferenceResolver& resolve);

/// Whether reading it needs the resolver.
bool names_instance(const Document& document, const Document::Node& node, Type type, Type element);

}  // namespace fettle::property
