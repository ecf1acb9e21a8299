#pragma once
// Formulas of scripts: `obj.prop = formula(function() return ... end)`, or `obj.prop is ...` in the
// console.

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <handlers/function_source.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Whether the value at `index` is a result of `formula(fn)`.
bool is_formula(lua_State* L, int index);
/// Sets the result of `formula(fn)` at `index` as the formula of a property. Adds the property if
/// it does not exist.
void define_formula(lua_State* L, Machine& machine, int index, property::Handle instance,
                    std::string_view name);
/// Replaces the function at the top of the Lua stack by a formula object.
void push_formula(lua_State* L, const FunctionSource& source);
/// Compiles the text of a formula: an expression, or a function that returns the value. Throws
/// Error(formula) with the reason if it is not valid.
property::Formula compile_formula(Machine& machine, const std::string& source,
                                  const char* what = "the formula");
/// An error message of such a text without the name of its chunk, which is always the same; the
/// number of the line if it is not the first one.
std::string without_chunk(std::string message);
/// The chunk of a formula that is a text.
constexpr const char* formula_chunk = "=formula";
/// A formula of the function at the top of the stack, which it pops; without a text.
property::Formula formula_of(lua_State* L, Machine& machine);
/// Pushes the function of a property's formula, or nil.
void push_formula_function(lua_State* L, const property::Tree& tree, property::Handle instance,
                           const property::Property& property);

/// Adds `formula` to the table of globals at the top of the Lua stack.
void open_formulas(lua_State* L);

}  // namespace fettle::script
