#include <memory>
#include <optional>

#include <fettle/script/runtime.h>

#include <calls/errors.h>
#include <calls/function_ref.h>
#include <calls/held_memory.h>
#include <calls/protected.h>
#include <handlers/formulas.h>
#include <handlers/function_source.h>
#include <handlers/observed.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <lua/stack.h>
#include <sources/sources.h>
#include <text/selected_name.h>
#include <text/words.h>
#include <values/recording.h>
#include <values/values.h>
#include <writes/writes.h>

namespace fettle::script {

using property::Tree;

namespace {

// User values: 1 the function, 2 its text, 3 the reason why the text alone cannot be saved.
struct FormulaBox {
    Tag tag;
};

// The function of a formula. It has a limit of instructions, like a console command. Its errors
// become the error of the property and are not reported to the game.
class ScriptFormula {
  public:
    ScriptFormula(Machine& machine, std::shared_ptr<FunctionRef> function)
        : machine_(&machine), alive_(machine.lua.alive), function_(std::move(function)) {}

    Value operator()(const Tree& tree) const {
        if (*alive_ == nullptr || !machine_->life.has_tree())
            throw std::runtime_error("its script has ended");
        Machine& machine = *machine_;
        if (&tree != &machine.tree)
            throw std::runtime_error(
                "it is a function of the scripts of another tree, and is computed only there");
        const RuntimeLifetime::Use use(machine.life);
        std::optional<Budget::Scope> counted;
        if (!machine.limiters.budget.counting())
            counted.emplace(machine.limiters.budget,
                            Limits{.instructions = machine.options.console_budget,
                                   .memory = machine.options.console_memory,
                                   .subject = "a formula"});
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
        std::string message = machine.errors.caught ? machine.errors.caught->message : "failed";
        machine.errors.caught.reset();
        throw std::runtime_error(without_chunk(std::move(message)));
    }
    const std::shared_ptr<FunctionRef>& function() const { return function_; }

  private:
    Machine* machine_;
    std::shared_ptr<lua_State*> alive_;
    std::shared_ptr<FunctionRef> function_;
};

int formula(lua_State* L) {
    if (lua_type(L, 1) != LUA_TFUNCTION)
        refuse_type(L, 1, "formula: needs a function that returns the value");
    if (lua_gettop(L) > 1)
        throw Error(ErrorKind::wrong_type,
                    "formula: takes one function and nothing else; what it needs, it names");
    Machine& machine = machine_of(L);
    FunctionSource source = function_source(L, machine, 1);
    if (machine.recording.active && mentions_it(source.text)) {
        // Typed into the console: the formula keeps what is selected now.
        source.text = with_selected(machine, source.text);
        bind_selected(L, machine, 1);
    }
    push_formula(L, source);
    return 1;
}

}  // namespace

bool is_formula(lua_State* L, int index) {
    return box_at<FormulaBox>(L, index, Tag::formula) != nullptr;
}

void push_formula(lua_State* L, const FunctionSource& source) {
    auto* box = static_cast<FormulaBox*>(lua_newuserdatauv(L, sizeof(FormulaBox), 3));
    box->tag = Tag::formula;
    lua_insert(L, -2);
    lua_setiuservalue(L, -2, 1);
    push_text(L, source.text);
    lua_setiuservalue(L, -2, 2);
    push_text(L, source.not_saved);
    lua_setiuservalue(L, -2, 3);
    lua_newtable(L);
    name_metatable(L, "formula");
    lua_setmetatable(L, -2);
}

namespace {

std::string user_text(lua_State* L, int index, int user_value) {
    lua_getiuservalue(L, index, user_value);
    std::string text = string_at(L, -1);
    lua_pop(L, 1);
    return text;
}

}  // namespace

std::string without_chunk(std::string message) {
    if (message.starts_with("formula:1: "))
        message.erase(0, 11);
    else if (message.starts_with("formula:"))
        message.replace(0, 8, "line ");
    return message;
}

void define_formula(lua_State* L, Machine& machine, int index, Handle instance,
                    std::string_view name) {
    const std::string source = user_text(L, index, 2), not_saved = user_text(L, index, 3);
    lua_getiuservalue(L, index, 1);
    const std::size_t holds = held_memory(L, machine, -1);
    const auto function = std::make_shared<FunctionRef>(L, machine);
    write_formula(machine, instance, name,
                  {ScriptFormula(machine, function), source, not_saved, holds});
}

property::Formula compile_formula(Machine& machine, const std::string& source, const char* what) {
    if (one_line(source).empty()) throw Error(ErrorKind::formula, "the formula has no text");
    const RuntimeLifetime::Use use(machine.life);
    const std::string chunk = "return " + source;
    std::shared_ptr<FunctionRef> function;
    std::string wrong;
    const bool ok = protected_run(
        machine, "formula",
        [&](lua_State* L) {
            if (load_text(L, chunk, formula_chunk) != LUA_OK) {
                wrong = string_at(L, -1);
                return;
            }
            // If the text is that of a function, running the chunk only creates this function.
            if (is_function_text(source)) {
                lua_pushvalue(L, -1);
                lua_call(L, 0, 1);
                if (lua_type(L, -1) != LUA_TFUNCTION) lua_pop(L, 1);
            }
            function = std::make_shared<FunctionRef>(L, machine);
        },
        false);
    if (!ok) wrong = machine.errors.caught ? machine.errors.caught->message : "failed";
    machine.errors.caught.reset();
    if (!wrong.empty()) {
        const bool early = wrong.ends_with("near <eof>");
        throw Error(
            ErrorKind::formula,
            std::string(what) + (early ? " ends too early"
                                       : " does not compile: " + without_chunk(std::move(wrong))));
    }
    return {ScriptFormula(machine, function), source};
}

property::Formula formula_of(lua_State* L, Machine& machine) {
    return {ScriptFormula(machine, std::make_shared<FunctionRef>(L, machine))};
}

void push_formula_function(lua_State* L, const property::Tree& tree, Handle instance,
                           const Property& property) {
    const property::Formula* found = tree.formula(instance, property);
    const auto* formula = found != nullptr ? found->function.target<ScriptFormula>() : nullptr;
    if (formula != nullptr)
        formula->function()->push(L);
    else
        lua_pushnil(L);
}

void open_formulas(lua_State* L) {
    Machine& machine = machine_of(L);
    machine.tree.compile_formulas_with(
        [&machine](const std::string& source) { return compile_formula(machine, source); });
    add_pure<formula>(L, "formula");
}

}  // namespace fettle::script
