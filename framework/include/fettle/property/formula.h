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

struct Formula {
    /// Computes the value from what it reads of the tree. It may throw; it must not write.
    std::function<Value(const Tree&)> function;
    /// Its text, as it is shown, edited and saved; "" for a formula that has none.
    std::string source{};
    /// Why the text alone does not make the same formula again ("uses the local variable \"speed\"
    /// of main.lua:12"), so that files hold its value instead; "" when it does.
    std::string not_saved{};
    /// Bytes that the function alone keeps in memory, about.
    std::size_t holds = 0;
};

/// Memory a formula takes, about.
inline std::size_t bytes_of(const Formula& formula) {
    return sizeof formula + formula.source.capacity() + formula.not_saved.capacity() +
           formula.holds;
}

/// Makes a formula of its text. Throws Error(formula) with what is wrong with the text.
using FormulaCompiler = std::function<Formula(const std::string& source)>;

/// Where a value comes from, as a tree.
struct Explanation {
    std::string path;
    std::string value;    // as printed, with its unit; "" where there is none
    std::string source;   // of a formula
    std::string problem;  // of a formula in error
    std::vector<Explanation> from;
    bool repeated = false;  // explained elsewhere in the same tree
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
