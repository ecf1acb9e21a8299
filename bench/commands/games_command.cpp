// `fettle-bench games`: the cost of games: steps, frames, loading, reloading. The figures are
// processor time of the game's thread, for the start of the whole process, so other load on the
// machine affects them little.

#include <iostream>

#include <fettle/app/screen.h>

#include "commands/commands.h"
#include "games/game_costs.h"
#include "report/json_lines.h"
#include "report/table.h"

namespace fettle::bench {

int run_games(const GamesOptions& options) {
    const bool display = app::display_available();
    if (!display) std::cerr << "there is no display: figures that need a display are left out\n";
    Verdict verdict("games");
    Table table({"cost", "", "", "bound"});
    for (const GameCost& cost : game_costs()) {
        if (cost.name.find(options.only) == std::string::npos) continue;
        if (cost.needs_display && !display) continue;
        const double value = cost.measure();
        if (options.json)
            std::cout << json_line({{"name", cost.name},
                                    {"value", value},
                                    {"unit", cost.unit},
                                    {"at_most", JsonField(cost.bound.value)}})
                      << "\n";
        table.add({cost.name, verdict.mark(cost.name, value, cost.bound, figure(value), cost.unit),
                   cost.unit, cost.bound.text()});
    }
    if (!options.json) std::cout << table.text();
    verdict.print(options.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
