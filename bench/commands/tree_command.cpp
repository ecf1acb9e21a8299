// `fettle-bench tree`: what the live property tree costs, in nanoseconds and against the least that
// would do.

#include <iostream>

#include "commands/commands.h"
#include "costs/cost_table.h"
#include "report/json_lines.h"
#include "report/table.h"

namespace fettle::bench {

int run_tree(const TreeOptions& options) {
    CostTable costs;
    add_tree_costs(costs);
    add_lua_costs(costs);
    if (!options.only.empty()) costs.keep(options.only);
    const std::vector<Cost> rows = costs.run(options.repetitions);
    Table table({"cost", "ns", "ratio", "against"});
    Chart chart{.title = "What the property tree costs", .unit = "ns", .series = {"fettle"}};
    for (const Cost& row : rows) {
        const bool compared = row.ratio > 0;
        if (options.output.json) {
            std::cout << json_line({{"name", row.name},
                                    {"ns", row.ns},
                                    {"ratio", compared ? JsonField(row.ratio) : JsonField()},
                                    {"against", compared ? JsonField(row.against) : JsonField()}})
                      << "\n";
        }
        table.add({row.name, figure(row.ns), compared ? figure(row.ratio) : "", row.against});
        chart.groups.push_back({row.name, {row.ns}});
    }
    if (!options.output.json) std::cout << table.text();
    if (!options.output.svg.empty()) write_svg(chart, options.output.svg);
    return 0;
}

}  // namespace fettle::bench
