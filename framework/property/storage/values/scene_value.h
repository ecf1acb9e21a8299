#pragma once
// Values in scene files. A declared type is not repeated: a number is 2, a vec2 [1, 2], a color
// "#ff8800", a reference ".ball". Without a declared type (ad-hoc properties, untyped lists) a
// number has a decimal point, and values without a JSON form contain their type: {"vec2": [1, 2]},
// {"number": "inf"}.

#include <functional>
#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// The type in which a value of the property is written; nil if the value must contain its type.
inline Type declared_type(const Property& property) {
    return property.any_type ? Type::nil : property.type;
}

/// Writes the values of one scene, whose topmost instance is `top`.
class ValueWriter {
  public:
    ValueWriter(const Tree& tree, Handle top) : tree_(tree), top_(top) {}

    /// Writes on one line; a list that would exceed column 100 gets one line per element. `column`:
    /// where the value begins; `indent`: indentation of that line. Throws Error.
    void append(std::string& out, const Property& property, const Value& value, std::size_t column,
                std::size_t indent) const;
    /// The same for a formula with its last value. If the text of the formula is not UTF-8, returns
    /// false and leaves `out` unchanged.
    bool append(std::string& out, const Property& property, const Formula& formula,
                const Value& value) const;

    /// ".ball.circle" for an instance inside the scene ("." is its top), "world.floor" for one
    /// outside. Throws Error if no path leads to it.
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

/// Finds the instance for a path in a file; throws SceneError at `node`.
using ReferenceResolver =
    std::function<Handle(const std::string& path, const Document::Node& node)>;

/// A formula in a file: `{"is": "world.ball.mass * 2", "value": 4}`. It contains the text, and the
/// last value for programs that cannot compile the text.
struct FormulaText {
    const Document::Node* is = nullptr;
    const Document::Node* value = nullptr;  // null if the file has none
    explicit operator bool() const { return is != nullptr; }
};

/// Empty if the node is a plain value. Throws SceneError for an object that is neither.
FormulaText formula_text(const Document& document, const Document::Node& node);

/// Compiles the text. Without a compiler, returns a formula that keeps `value` and the text. Throws
/// Error if the text does not compile.
Formula make_formula(const Tree& tree, const std::string& source, const Value& value);

/// The same for a formula in a file; a text that does not compile is a SceneError at its place.
Formula made_formula(const Tree& tree, const Document& document, const FormulaText& formula,
                     const Value& value);

/// Throws Error for name and parent, which a scene describes by the keys of an instance.
void require_settable_in_scene(const Property& property);

/// Reads a value of type `type`; if that is a list, `element` is the type of its elements. If the
/// text has another type, the value of that type is returned, and the property converts or refuses
/// it. Throws SceneError if the text is not a value.
Value read_value(const Document& document, const Document::Node& node, Type type, Type element,
                 const ReferenceResolver& resolve);

/// Whether reading the value calls the resolver.
bool names_instance(const Document& document, const Document::Node& node, Type type, Type element);

}  // namespace fettle::property
