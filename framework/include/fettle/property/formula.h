#pragma once
// Formulas: functions that are the value of a property.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// A function that is the value of a property.
struct Formula {
    /// Computes the value from other values of the tree. It may throw; it must not write.
    std::function<Value(const Tree&)> function;
    /// Its text, for display, editing and saving; "" if it has none.
    std::string source{};
    /// Why the text alone does not define the same formula ("uses the local variable \"speed\" of
    /// main.lua:12"); files then contain the value. "" if it does.
    std::string not_saved{};
    /// Bytes of memory that only this function uses, estimated.
    std::size_t holds = 0;
};

/// Memory of a formula, in bytes, estimated.
inline std::size_t bytes_of(const Formula& formula) {
    return sizeof formula + formula.source.capacity() + formula.not_saved.capacity() +
           formula.holds;
}

/// Compiles the text of a formula. Throws Error(formula) for an error in the text.
using FormulaCompiler = std::function<Formula(const std::string& source)>;

/// The sources of a value, as a tree.
struct Explanation {
    std::string path;               ///< of the value
    std::string value;              // as printed, with its unit; "" if there is none
    std::string source;             // for a formula
    std::string problem;            // for a formula that fails
    std::vector<Explanation> from;  ///< its sources
    bool repeated = false;          // explained elsewhere in the same tree
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
