#pragma once
// Formulas of scripts: `obj.prop = formula(function() return ... end)`, in the console `obj.prop is
// ...`.

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <handlers/function_source.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// What `formula(fn)` returned stands at `index`.
bool is_formula(lua_State* L, int index);
/// Makes what `formula(fn)` returned, at `index`, the value of a property; adds the property where
/// there is none.
void define_formula(lua_State* L, Machine& machine, int index, property::Handle instance,
                    std::string_view name);
/// Wraps the function on top of the stack; replaces it on the stack.
void push_formula(lua_State* L, const FunctionSource& source);
/// The formula a text stands for: an expression, or a function that returns the value. Throws
/// Error(formula) with what is wrong with it.
property::Formula compile_formula(Machine& machine, const std::string& source);
/// Pushes the function of a property's formula, or nil.
void push_formula_function(lua_State* L, const property::Tree& tree, property::Handle instance,
                           const property::Property& property);

/// `formula` among the globals on top.
void open_formulas(lua_State* L);

}  // namespace fettle::script
