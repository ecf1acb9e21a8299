// `fettle-bench scenes`: runs the same scenes in every engine, in turns.

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <iostream>
#include <optional>

#include "commands/commands.h"
#include "engines/engine.h"
#include "measure/simulation.h"
#include "measure/timing.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

struct Cell {
    std::vector<double> ms;  // per step, one value per run
    std::size_t bodies = 0;
    std::size_t contacts = 0;
    std::uint64_t hash = 0;
    double step_ms() const { return median(ms); }
};

struct Row {
    std::string scene;
    int steps = 0;
    Bound bound{};                             // of the time per step divided by that of Box2D
    std::vector<std::optional<Cell>> cells{};  // one per engine
};

std::string hash_text(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, hash);
    return text;
}

class SceneRunner {
  public:
    explicit SceneRunner(const ScenesOptions& options) : options_(options) {
        for (const EngineKind& kind : engine_kinds()) {
            if (wanted(kind)) engines_.push_back(&kind);
        }
        for (const std::string& name : options.engines) engine_named(name);
        if (options.scenes.empty()) {
            for (const CatalogueEntry& entry : catalogue()) {
                if (entry.by_default) scenes_.push_back(&entry);
            }
        }
        for (const std::string& name : options.scenes) scenes_.push_back(&scene_named(name));
    }

    int run() {
        explain_gaps();
        {
            Progress progress(static_cast<double>(scenes_.size()) * options_.runs);
            for (const CatalogueEntry* entry : scenes_) {
                rows_.push_back(run_scene(*entry, progress));
                if (options_.output.json)
                    print_json(rows_.back());  // in case the run is interrupted
            }
        }
        print_table();
        if (!options_.output.svg.empty()) write_svg(chart(), options_.output.svg);
        warn_when_busy();
        return hashes_agree() ? 0 : 1;
    }

  private:
    bool wanted(const EngineKind& kind) const {
        if (options_.engines.empty()) return true;
        for (const std::string& name : options_.engines) {
            if (name == kind.name) return true;
        }
        return false;
    }

    bool able(const EngineKind& kind) const {
        return kind.make && options_.threads <= kind.max_threads;
    }

    /// Whether the table has a column with the ratio to Box2D.
    bool compared(const EngineKind& kind) const {
        const auto is_box2d = [](const EngineKind* other) { return other->name == "box2d"; };
        return kind.name != "box2d" && std::ranges::any_of(engines_, is_box2d);
    }

    /// Prints which figures will be missing, and why.
    void explain_gaps() const {
        for (const EngineKind* kind : engines_) {
            if (!kind->make) {
                std::cerr << kind->name << ": not built in; install " << kind->package
                          << " and build again\n";
            } else if (!able(*kind)) {
                std::cerr << kind->name << ": runs on " << kind->max_threads
                          << " thread at most, not on " << options_.threads << "\n";
            }
        }
    }

    Row run_scene(const CatalogueEntry& entry, Progress& progress) {
        Scene scene = entry.make();
        if (options_.steps > 0) scene.steps = options_.steps;
        Row row{.scene = scene.name, .steps = scene.steps};
        row.cells.resize(engines_.size());
        // The bounds hold for a complete scene on one thread.
        if (entry.over_box2d > 0 && options_.steps == 0 && options_.threads == 1)
            row.bound = at_most(entry.over_box2d);
        for (int run = 0; run < options_.runs; ++run) {
            progress.begin(scene.name + ", run " + std::to_string(run + 1) + " of " +
                           std::to_string(options_.runs));
            run_once(scene, run, row, progress);
        }
        return row;
    }

    /// One run: the engines take turns, each with a twentieth of the steps, so that disturbances of
    /// the machine affect all of them.
    void run_once(const Scene& scene, int run, Row& row, Progress& progress) {
        constexpr int turns = 20;
        const std::size_t count = engines_.size();
        std::vector<std::unique_ptr<Simulation>> simulations(count);
        std::vector<StepTime> time(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (!able(*engines_[i]) || !scene.runs_on(engines_[i]->name)) continue;
            simulations[i] = std::make_unique<Simulation>(scene, *engines_[i]);
            simulations[i]->engine().set_threads(options_.threads);
            simulations[i]->advance(1);  // not counted, because the first step finds every pair
        }
        for (int turn = 1; turn <= turns; ++turn) {
            const int goal = 1 + (scene.steps - 1) * turn / turns;
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t i = (k + static_cast<std::size_t>(turn + run)) % count;
                if (simulations[i])
                    time[i] += simulations[i]->advance(goal - simulations[i]->steps());
                progress.add(1.0 / static_cast<double>(turns * count));
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!simulations[i]) continue;
            if (!row.cells[i]) row.cells[i].emplace();
            Cell& cell = *row.cells[i];
            cell.ms.push_back(measured(time[i]) / std::max(1, scene.steps - 1));
            busy_ = std::max(busy_, time[i].wall_ms / time[i].thread_ms);
            cell.bodies = simulations[i]->engine().bodies();
            cell.contacts = simulations[i]->engine().contacts();
            cell.hash = simulations[i]->hash();
        }
    }

    double measured(const StepTime& time) const {
        return options_.processor_time ? time.thread_ms : time.wall_ms;
    }

    const Cell* cell(const Row& row, std::string_view engine) const {
        for (std::size_t i = 0; i < engines_.size(); ++i) {
            if (engines_[i]->name == engine && row.cells[i]) return &*row.cells[i];
        }
        return nullptr;
    }

    void print_json(const Row& row) const {
        for (std::size_t i = 0; i < engines_.size(); ++i) {
            if (!row.cells[i]) continue;
            const Cell& cell = *row.cells[i];
            std::cout << json_line({{"scene", row.scene},
                                    {"engine", std::string(engines_[i]->name)},
                                    {"threads", static_cast<long long>(options_.threads)},
                                    {"steps", static_cast<long long>(row.steps)},
                                    {"bodies", static_cast<long long>(cell.bodies)},
                                    {"contacts", static_cast<long long>(cell.contacts)},
                                    {"ms", cell.step_ms()},
                                    {"hash", hash_text(cell.hash)}})
                      << std::endl;
        }
    }

    void print_table() const {
        std::vector<std::string> headers = {"ms a step", "bodies", "contacts", "steps"};
        for (const EngineKind* kind : engines_) headers.emplace_back(kind->name);
        for (const EngineKind* kind : engines_) {
            if (compared(*kind)) headers.push_back(std::string(kind->name) + "/box2d");
        }
        if (bounded()) headers.emplace_back("bound");
        Verdict verdict("scenes");
        Table table(headers);
        for (const Row& row : rows_) {
            std::size_t bodies = 0, contacts = 0;  // of the first engine
            for (auto cell = row.cells.rbegin(); cell != row.cells.rend(); ++cell) {
                bodies = *cell ? (*cell)->bodies : bodies;
                contacts = *cell ? (*cell)->contacts : contacts;
            }
            std::vector<std::string> line = {row.scene, std::to_string(bodies),
                                             std::to_string(contacts), std::to_string(row.steps)};
            for (const auto& cell : row.cells) line.push_back(cell ? figure(cell->step_ms()) : "");
            const Cell* peer = cell(row, "box2d");
            for (std::size_t i = 0; i < engines_.size(); ++i) {
                if (!compared(*engines_[i])) continue;
                if (!peer || !row.cells[i]) {
                    line.emplace_back();
                    continue;
                }
                const double ratio = row.cells[i]->step_ms() / peer->step_ms();
                const Bound bound = engines_[i]->name == "fettle" ? row.bound : Bound{};
                line.push_back(
                    verdict.mark(row.scene, ratio, bound, figure(ratio), "of Box2D's time"));
            }
            if (bounded()) line.push_back(row.bound.text());
            table.add(std::move(line));
        }
        if (!options_.output.json) std::cout << table.text();
        verdict.print(options_.output.json ? std::cerr : std::cout);
    }

    /// Whether the table has a column with bounds.
    bool bounded() const {
        return std::ranges::any_of(engines_, [this](const EngineKind* kind) {
            return kind->name == "fettle" && compared(*kind);
        });
    }

    Chart chart() const {
        Chart chart{.title = "Time of a step, median of " + std::to_string(options_.runs) +
                             (options_.runs == 1 ? " run, " : " runs, ") +
                             std::to_string(options_.threads) +
                             (options_.threads == 1 ? " thread" : " threads"),
                    .unit = "ms"};
        for (const EngineKind* kind : engines_) chart.series.emplace_back(kind->name);
        for (const Row& row : rows_) {
            Chart::Group group{.label = row.scene};
            for (const auto& cell : row.cells) {
                group.values.push_back(cell ? std::optional(cell->step_ms()) : std::nullopt);
            }
            chart.groups.push_back(std::move(group));
        }
        return chart;
    }

    void warn_when_busy() const {
        if (options_.threads != 1 || options_.processor_time || busy_ < 1.2) return;
        std::cerr << "this machine was busy: steps took up to " << figure(busy_, 2)
                  << " times the time they had a processor; --processor-time measures that\n";
    }

    /// Checks that hosting in the tree does not change the simulation.
    bool hashes_agree() const {
        bool agree = true;
        for (const Row& row : rows_) {
            const Cell* bare = cell(row, "fettle");
            const Cell* hosted = cell(row, "hosted");
            if (!bare || !hosted || bare->hash == hosted->hash) continue;
            std::cerr << row.scene
                      << ": the hosted world ended in another state than the bare one\n";
            agree = false;
        }
        return agree;
    }

    const ScenesOptions& options_;
    std::vector<const EngineKind*> engines_;
    std::vector<const CatalogueEntry*> scenes_;
    std::vector<Row> rows_;
    double busy_ = 1;  // largest ratio of wall time to processor time
};

}  // namespace

int run_scenes(const ScenesOptions& options) {
    return SceneRunner(options).run();
}

}  // namespace fettle::bench
