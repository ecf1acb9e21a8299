// The cost of a formula in addition to its function.

#include <fettle/property/tree.h>

#include <stdexcept>

#include "costs/cost_table.h"

namespace fettle::bench {
namespace {

using benchmark::DoNotOptimize;
using property::Handle;
using property::Property;
using property::Tree;
using property::Value;

/// `twice` is a formula that reads `source`; nothing reads `plain`.
struct FormulaTree {
    FormulaTree() {
        property::ClassDescriptor cell{.name = "Cell"};
        cell.properties = {{.name = "source"}, {.name = "plain"}, {.name = "twice"}};
        const property::Class& defined = tree.define(std::move(cell));
        self = tree.create(defined, tree.root(), "cell");
        source = defined.property("source");
        plain = defined.property("plain");
        twice = defined.property("twice");
        tree.set_formula(self, *twice, {.function = [this](const Tree&) { return compute(); }});
        DoNotOptimize(tree.get(self, *twice));
    }
    Value compute() const { return 2 * tree.get(self, *source).number(); }

    Tree tree;
    Handle self;
    const Property* source = nullptr;
    const Property* plain = nullptr;
    const Property* twice = nullptr;
};

FormulaTree& formulas() {
    static FormulaTree tree;
    return tree;
}

}  // namespace

void add_formula_costs(CostTable& table) {
    const std::string alone = "Formula: its function alone";
    const std::string set = "Formula: set a number that none reads";
    table.add(alone, "", 1, [](benchmark::State& state) {
        for (auto _ : state) DoNotOptimize(formulas().compute());
    });
    table.add("Formula: get, nothing changed", "", 1, [](benchmark::State& state) {
        FormulaTree& t = formulas();
        for (auto _ : state) DoNotOptimize(t.tree.get(t.self, *t.twice));
    });
    table.add(set, "", 1, [](benchmark::State& state) {
        FormulaTree& t = formulas();
        double value = 0;
        for (auto _ : state) t.tree.set(t.self, *t.plain, ++value);
    });
    table.add({.name = "Formula: overhead, from a source's edit to the new value",
               .loop =
                   [](benchmark::State& state) {
                       FormulaTree& t = formulas();
                       double value = 0;
                       for (auto _ : state) {
                           t.tree.set(t.self, *t.source, ++value);
                           const double twice = t.tree.get(t.self, *t.twice).number();
                           if (twice != 2 * value) throw std::logic_error("not up to date");
                       }
                   },
               .without = {alone, set}});
}

}  // namespace fettle::bench
