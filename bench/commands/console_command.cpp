// `fettle-bench console`: the processor time that the console adds to a frame.

#include <iostream>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "console/console_costs.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#ifdef FETTLE_BENCH_GAMES
#include "games/undrawn_screen.h"
#endif

namespace fettle::bench {
namespace {

const Bound frame_bound = at_most(2);  // ms

std::unique_ptr<app::Screen> make_screen() {
#ifdef FETTLE_BENCH_GAMES
    if (app::display_available()) return std::make_unique<UndrawnScreen>(1280, 800);
#endif
    std::cerr << "there is no display: triangles are only counted\n";
    return nullptr;
}

}  // namespace

int run_console(const ConsoleOptions& options) {
    const std::unique_ptr<app::Screen> screen = make_screen();
    Verdict verdict("console");
    Table table({"ms of a frame", "after a step", "between frames", "widgets", "triangles",
                 "together", "bound", "longest", "triangles drawn"});
    for (const int bodies : options.bodies)
        for (const ConsoleCost& cost : console_costs(bodies, options.frames, screen.get())) {
            const ConsolePhases& ms = cost.median;
            if (options.json)
                std::cout << json_line({{"bodies", std::int64_t{bodies}},
                                        {"state", cost.state},
                                        {"after_step_ms", ms.after_step},
                                        {"between_frames_ms", ms.between_frames},
                                        {"widgets_ms", ms.widgets},
                                        {"triangles_ms", ms.triangles},
                                        {"frame_ms", cost.frame},
                                        {"longest_ms", cost.longest},
                                        {"triangles", static_cast<std::int64_t>(cost.drawn)}})
                          << "\n";
            const std::string name = std::to_string(bodies) + " bodies, " + cost.state;
            table.add({name, figure(ms.after_step), figure(ms.between_frames), figure(ms.widgets),
                       figure(ms.triangles),
                       verdict.mark(name, cost.frame, frame_bound, figure(cost.frame), "ms"),
                       frame_bound.text(), figure(cost.longest), std::to_string(cost.drawn)});
        }
    if (!options.json) std::cout << table.text();
    verdict.print(options.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
