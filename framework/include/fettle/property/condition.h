#pragma once
// Conditions that instances are searched by: `mass > 5 and awake`, `position.x > 3`,
// `Body and not (type == "static")`. They have the words and the precedence of Lua's expressions,
// and can only read: there are no calls and no assignments.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// A condition for instances, as it is typed into the search of the inspector: `mass > 5`.
class Condition {
  public:
    /// Throws Error(rejected), which names the place, for a text that is not a condition, has more
    /// than 2000 bytes, or is nested more than 50 deep.
    explicit Condition(std::string_view text);
    ~Condition();
    Condition(Condition&&) noexcept;
    /// Takes over the other.
    Condition& operator=(Condition&&) noexcept;

    /// Whether a text is meant as a condition: it has an operator, a bracket, or one of the words
    /// `and`, `or` and `not`. A name alone is none.
    static bool is_meant(std::string_view text);

    /// Names are properties of the instance, then children, then classes, which hold for their
    /// instances. `.x` and `.y` of vectors, `.r` `.g` `.b` `.a` of colors, `[1]` of lists, and the
    /// properties of references can be read. A property that an instance does not have is nil. A
    /// formula that fails makes its instance fail. Changes nothing; takes time in proportion to the
    /// text.
    bool holds(const Tree& tree, Handle instance);
    /// What is wrong with the condition, once instances were asked: none of them had one of its
    /// names (with the nearest spelling), or a vector was compared with a number by size. "" if
    /// nothing is.
    std::string problem(const Tree& tree) const;
    /// Number of operations for one instance.
    std::size_t weight() const;

  private:
    struct FETTLE_PROPERTY_PRIVATE Program;
    std::unique_ptr<Program> program_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
