// `fettle-bench stability`: figures of small scenes with a known result, for every engine.

#include <iostream>
#include <optional>

#include "commands/commands.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "stability/trial.h"

namespace fettle::bench {
namespace {

struct FigureRow {
    std::string scene;
    Figure figure;                              // name, unit, bound
    std::vector<std::optional<double>> values;  // one per engine
};

std::vector<const EngineKind*> engines_of(const StabilityOptions& options) {
    std::vector<const EngineKind*> engines;
    for (const std::string& name : options.engines) engines.push_back(&engine_named(name));
    if (engines.empty())
        engines = {&engine_named("fettle"), &engine_named("box2d"), &engine_named("chipmunk")};
    for (const EngineKind* kind : engines) {
        if (!kind->make)
            std::cerr << kind->name << ": not built in; install " << kind->package
                      << " and build again\n";
    }
    return engines;
}

std::vector<FigureRow> rows_of(const Trial& trial, const std::vector<const EngineKind*>& engines,
                               Progress& progress) {
    std::vector<FigureRow> rows;
    for (std::size_t e = 0; e < engines.size(); ++e) {
        if (engines[e]->make) {
            const std::vector<Figure> figures = trial.run(*engines[e]);
            for (std::size_t i = 0; i < figures.size(); ++i) {
                if (rows.size() <= i) {
                    rows.push_back({std::string(trial.name), figures[i], {}});
                    rows[i].values.resize(engines.size());
                }
                rows[i].values[e] = figures[i].value;
            }
        }
        progress.add(1.0 / static_cast<double>(engines.size()));
    }
    return rows;
}

std::string table_of(const std::vector<FigureRow>& rows,
                     const std::vector<const EngineKind*>& engines, Verdict& verdict) {
    std::vector<std::string> headers = {"scene", "figure", "unit", "bound"};
    for (const EngineKind* kind : engines) headers.emplace_back(kind->name);
    Table table(headers);
    for (const FigureRow& row : rows) {
        std::vector<std::string> line = {row.scene, row.figure.name, row.figure.unit,
                                         text_with_note(row.figure.bound)};
        for (std::size_t e = 0; e < engines.size(); ++e) {
            const std::string shown = row.values[e] ? figure(*row.values[e]) : "";
            // The bounds hold for Fettle only; the other engines are for comparison.
            const bool own = row.values[e] && engines[e]->name == "fettle";
            line.push_back(own ? verdict.mark(row.scene + ", " + row.figure.name, *row.values[e],
                                              row.figure.bound, shown, row.figure.unit)
                               : shown);
        }
        table.add(std::move(line));
    }
    return table.text();
}

void print_json(const std::vector<FigureRow>& rows, const std::vector<const EngineKind*>& engines) {
    for (const FigureRow& row : rows) {
        for (std::size_t e = 0; e < engines.size(); ++e) {
            if (!row.values[e]) continue;
            std::cout << json_line({{"scene", row.scene},
                                    {"engine", std::string(engines[e]->name)},
                                    {"figure", row.figure.name},
                                    {"value", *row.values[e]},
                                    {"unit", row.figure.unit}})
                      << "\n";
        }
    }
}

Chart chart_of(const std::vector<FigureRow>& rows, const std::vector<const EngineKind*>& engines) {
    Chart chart{.title = "Stability: shorter is better, but for dominoes", .unit = ""};
    for (const EngineKind* kind : engines) chart.series.emplace_back(kind->name);
    for (const FigureRow& row : rows) {
        chart.groups.push_back(
            {row.scene + ": " + row.figure.name + ", " + row.figure.unit, row.values});
    }
    return chart;
}

}  // namespace

int run_stability(const StabilityOptions& options) {
    const std::vector<const EngineKind*> engines = engines_of(options);
    std::vector<const Trial*> wanted;
    for (const std::string& name : options.scenes) wanted.push_back(&trial_named(name));
    if (wanted.empty()) {
        for (const Trial& trial : trials()) wanted.push_back(&trial);
    }
    std::vector<FigureRow> rows;
    {
        Progress progress(static_cast<double>(wanted.size()));
        for (const Trial* trial : wanted) {
            progress.begin(std::string(trial->name));
            for (FigureRow& row : rows_of(*trial, engines, progress))
                rows.push_back(std::move(row));
        }
    }
    Verdict verdict("stability");
    const std::string table = table_of(rows, engines, verdict);
    if (options.output.json)
        print_json(rows, engines);
    else
        std::cout << table;
    verdict.print(options.output.json ? std::cerr : std::cout);
    if (!options.output.svg.empty()) write_svg(chart_of(rows, engines), options.output.svg);
    return 0;
}

}  // namespace fettle::bench
