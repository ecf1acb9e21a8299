// `fettle-bench tree`: the cost of the live property tree in nanoseconds, compared with the least
// possible cost.

#include <iostream>

#include "commands/commands.h"
#include "costs/cost_table.h"
#include "report/json_lines.h"
#include "report/table.h"

namespace fettle::bench {

int run_tree(const TreeOptions& options) {
    CostTable costs;
    add_tree_costs(costs);
    add_formula_costs(costs);
    add_pattern_costs(costs);
    add_lua_costs(costs);
    if (!options.only.empty()) costs.keep(options.only);
    const std::vector<Cost> rows = costs.run(options.repetitions);
    Verdict verdict("tree");
    Table table({"cost", "ns", "ratio", "bound", "against"});
    Chart chart{.title = "What the property tree costs", .unit = "ns", .series = {"fettle"}};
    for (const Cost& row : rows) {
        std::vector<Comparison> comparisons = row.comparisons;
        if (comparisons.empty()) comparisons.emplace_back();
        bool first = true;  // a row with two comparisons prints its name once
        for (const Comparison& beside : comparisons) {
            const bool compared = !beside.against.empty();
            if (options.output.json) {
                std::cout << json_line(
                                 {{"name", row.name},
                                  {"ns", row.ns},
                                  {"ratio", compared ? JsonField(beside.ratio) : JsonField()},
                                  {"against", compared ? JsonField(beside.against) : JsonField()},
                                  {"at_most",
                                   beside.bound ? JsonField(beside.bound.value) : JsonField()}})
                          << "\n";
            }
            const std::string ratio =
                verdict.mark(row.name, beside.ratio, beside.bound,
                             compared ? figure(beside.ratio) : "", "of \"" + beside.against + "\"");
            table.add({first ? row.name : "", first ? figure(row.ns) : "", ratio,
                       beside.bound.text(), beside.against});
            first = false;
        }
        chart.groups.push_back({row.name, {row.ns}});
    }
    if (!options.output.json) std::cout << table.text();
    verdict.print(options.output.json ? std::cerr : std::cout);
    if (!options.output.svg.empty()) write_svg(chart, options.output.svg);
    return 0;
}

}  // namespace fettle::bench
