#include "formulas.h"

#include <memory>

#include <fettle/property/error.h>

#include "guard.h"
#include "machine.h"
#include "protected.h"
#include "sandbox.h"
#include "subscriptions.h"
#include "writes.h"

namespace fettle::script {

using property::Error;
using property::ErrorKind;
using property::Handle;
using property::Property;
using property::Tree;
using property::Value;

namespace {

// User values: 1 the function, 2 its text.
struct FormulaBox {
    Tag tag;
};

// A formula keeps a count of instructions, like a console command, and whatever it raises becomes
// the error of its property: it is not reported to the game.
class ScriptFormula {
  public:
    ScriptFormula(Machine& machine, std::shared_ptr<FunctionRef> function)
        : machine_(&machine), alive_(machine.alive), function_(std::move(function)) {}

    Value operator()(const Tree&) const {
        if (*alive_ == nullptr) throw std::runtime_error("its script has ended");
        Machine& machine = *machine_;
        const bool counted = !machine.budget.active();
        if (counted)
            machine.budget.begin(machine.options.console_budget, machine.options.console_memory);
        struct End {
            Machine& machine;
            bool counted;
            ~End() {
                if (counted) machine.budget.end();
            }
        } end{machine, counted};
        Value result;
        const bool ok = protected_run(
            machine, "formula",
            [&](lua_State* L) {
                function_->push(L);
                lua_call(L, 0, 1);
                result = to_value(L, -1);
            },
            false);
        if (ok) return result;
        const std::string message = machine.caught ? machine.caught->message : "failed";
        machine.caught.reset();
        throw std::runtime_error(message);
    }
    const std::shared_ptr<FunctionRef>& function() const { return function_; }

  private:
    Machine* machine_;
    std::shared_ptr<lua_State*> alive_;
    std::shared_ptr<FunctionRef> function_;
};

int formula(lua_State* L) {
    if (lua_type(L, 1) != LUA_TFUNCTION)
        throw Error(ErrorKind::wrong_type,
                    "formula: needs a function that returns the value, not " + describe_type(L, 1));
    lua_settop(L, 1);
    push_formula(L, "");
    return 1;
}

}  // namespace

bool is_formula(lua_State* L, int index) {
    return box_at<FormulaBox>(L, index, Tag::formula) != nullptr;
}

void push_formula(lua_State* L, const std::string& source) {
    auto* box = static_cast<FormulaBox*>(lua_newuserdatauv(L, sizeof(FormulaBox), 2));
    box->tag = Tag::formula;
    lua_insert(L, -2);
    lua_setiuservalue(L, -2, 1);
    lua_pushlstring(L, source.data(), source.size());
    lua_setiuservalue(L, -2, 2);
    lua_newtable(L);
    lua_pushliteral(L, "formula");
    lua_setfield(L, -2, "__name");
    lua_pushliteral(L, "formula");
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

void define_formula(lua_State* L, Machine& machine, int index, Handle instance,
                    std::string_view name) {
    lua_getiuservalue(L, index, 2);
    const std::string source = lua_tostring(L, -1);
    lua_pop(L, 1);
    lua_getiuservalue(L, index, 1);
    const auto function = std::make_shared<FunctionRef>(L, machine);
    write_formula(machine, instance, name, {ScriptFormula(machine, function), source});
}

void push_formula_function(lua_State* L, Machine& machine, Handle instance,
                           const Property& property) {
    const property::Formula* found = machine.tree.formula(instance, property);
    const auto* ours = found != nullptr ? found->function.target<ScriptFormula>() : nullptr;
    if (ours != nullptr)
        ours->function()->push(L);
    else
        lua_pushnil(L);
}

void open_formulas(lua_State* L) {
    add_function<formula>(L, "formula");
}

}  // namespace fettle::script
