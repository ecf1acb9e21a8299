// `fettle-bench solvers`: the three solvers of the library in the stability scenes, with times per
// step and curves.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "commands/commands.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"
#include "solvers/experiments.h"
#include "stability/trial.h"

namespace fettle::bench {
namespace {

struct SolverRow {
    std::string scene;
    Figure figure;
    std::vector<double> values;  // one per solver
};

std::vector<SolverRow> accuracy_rows(const Trial& trial, Progress& progress) {
    std::vector<SolverRow> rows;
    for (const SolverKind& kind : solver_kinds()) {
        const std::vector<Figure> figures = trial.run(engine_of(kind));
        for (std::size_t i = 0; i < figures.size(); ++i) {
            if (rows.size() <= i) rows.push_back({std::string(trial.name), figures[i], {}});
            rows[i].values.push_back(figures[i].value);
        }
        progress.add(1.0 / static_cast<double>(solver_kinds().size()));
    }
    return rows;
}

std::vector<SolverRow> time_rows(Progress& progress) {
    const std::vector<std::pair<std::string, Scene>> scenes = {{"stack of 12", stack_of(12)},
                                                               {"pyramid of 55", pyramid_of(10)},
                                                               {"pyramid of 210", pyramid_of(20)},
                                                               {"chain of 31", chain_under(100)},
                                                               {"pile of 96", crowd_of(12, 8)}};
    std::vector<SolverRow> rows;
    for (const auto& [name, scene] : scenes) {
        SolverRow& row = rows.emplace_back(
            SolverRow{name, {.name = "time of a step", .value = 0, .unit = "ms"}, {}});
        for (const SolverKind& kind : solver_kinds()) {
            const auto engine = engine_of(kind).make(scene);
            row.values.push_back(step_time(*engine, 60));
        }
        progress.add(1);
    }
    return rows;
}

std::string table_of(const std::vector<SolverRow>& rows, Verdict& verdict) {
    std::vector<std::string> headers = {"scene", "figure", "unit", "bound"};
    for (const SolverKind& kind : solver_kinds()) headers.emplace_back(kind.name);
    Table table(headers);
    for (const SolverRow& row : rows) {
        std::vector<std::string> line = {row.scene, row.figure.name, row.figure.unit,
                                         text_with_note(row.figure.bound)};
        for (std::size_t k = 0; k < row.values.size(); ++k) {
            const double value = row.values[k];
            // The bounds hold for the default solver; the others are for comparison.
            const bool usual = solver_kinds()[k].solver == physics::Solver::soft_step;
            line.push_back(usual ? verdict.mark(row.scene + ", " + row.figure.name, value,
                                                row.figure.bound, figure(value), row.figure.unit)
                                 : figure(value));
        }
        table.add(std::move(line));
    }
    return table.text();
}

void print_json(const std::vector<SolverRow>& rows) {
    for (const SolverRow& row : rows) {
        for (std::size_t k = 0; k < row.values.size(); ++k) {
            std::cout << json_line({{"scene", row.scene},
                                    {"solver", std::string(solver_kinds()[k].name)},
                                    {"figure", row.figure.name},
                                    {"value", row.values[k]},
                                    {"unit", row.figure.unit}})
                      << "\n";
        }
    }
}

/// Writes the numbers of a plot, one point per line.
void write_data(const Plot& plot, const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::trunc);
    out << "# " << plot.title << ": solver, " << plot.x_label << ", " << plot.y_label << "\n";
    for (const Curve& curve : plot.curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            out << curve.name << "\t" << curve.x[i] << "\t" << curve.y[i] << "\n";
    }
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

void write_plots(const std::filesystem::path& folder, Progress& progress) {
    std::filesystem::create_directories(folder);
    for (const Experiment& experiment : experiments()) {
        progress.begin("plot " + std::string(experiment.name));
        const Plot plot = experiment.run();
        const std::string name = "solvers-" + std::string(experiment.name);
        write_svg(plot, folder / (name + ".svg"));
        write_data(plot, folder / (name + ".tsv"));
        progress.add(1);
    }
}

}  // namespace

int run_solvers(const SolversOptions& options) {
    std::vector<const Trial*> wanted;
    for (const std::string& name : options.scenes) wanted.push_back(&trial_named(name));
    const bool all = wanted.empty();
    if (all) {
        for (const Trial& trial : trials()) wanted.push_back(&trial);
    }
    std::vector<SolverRow> rows;
    {
        const bool plots = !options.plots.empty();
        Progress progress(static_cast<double>(wanted.size() + (all ? 5 : 0) +
                                              (plots ? experiments().size() : 0)));
        for (const Trial* trial : wanted) {
            progress.begin(std::string(trial->name));
            for (SolverRow& row : accuracy_rows(*trial, progress)) rows.push_back(std::move(row));
        }
        if (all) {
            progress.begin("time of a step");
            for (SolverRow& row : time_rows(progress)) rows.push_back(std::move(row));
        }
        if (plots) write_plots(options.plots, progress);
    }
    Verdict verdict("solvers");
    const std::string table = table_of(rows, verdict);
    if (options.json)
        print_json(rows);
    else
        std::cout << table;
    verdict.print(options.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
