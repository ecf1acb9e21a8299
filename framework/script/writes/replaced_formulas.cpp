#include <writes/replaced_formulas.h>

#include <string>

#include <fettle/property/path.h>

#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <text/words.h>
#include <values/recording.h>

namespace fettle::script {

void note_typed_formula(Machine& machine, property::Handle instance, std::string_view name) {
    if (machine.recording.active)
        machine.typed_formulas.all.emplace(instance.key(), std::string(name));
}

void note_replaced_formula(Machine& machine, property::Handle instance, std::string_view name) {
    // The answer to a command says it itself.
    if (machine.typed_formulas.all.empty() || machine.recording.active) return;
    const property::Tree& tree = machine.tree;
    const auto typed = machine.typed_formulas.all.find({instance.key(), std::string(name)});
    if (typed == machine.typed_formulas.all.end() || !tree.alive(instance)) return;
    const property::Property* const property = tree.find(instance, name);
    const property::Formula* const formula =
        property != nullptr ? tree.formula(instance, *property) : nullptr;
    if (formula == nullptr) return;  // going back in time may give it back
    machine.typed_formulas.all.erase(typed);
    if (!machine.host.on_note) return;
    machine.host.on_note(position(machine.lua.running) +
                         "this line replaces the formula that was typed for " +
                         tree.path(instance, *property) + ": is " + one_line(formula->source));
}

}  // namespace fettle::script
