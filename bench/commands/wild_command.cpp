// `fettle-bench wild`: random worlds, and the invariants that they violate.

#include <sys/time.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <iostream>
#include <stdexcept>

#include "commands/commands.h"
#include "engines/engine.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "wild/survey.h"

namespace fettle::bench {
namespace {

using wild::Finding;
using wild::Found;
using wild::Invariant;
using wild::Survey;
using wild::SurveyOptions;
using wild::WorldPlan;

/// The seed of the world that runs, for the message of a crash.
std::uint64_t running_seed = 0;

/// Processor time after which a world counts as hung, s. The time for minimizing its findings is
/// included, which is half a minute at most.
constexpr long longest = 300;

void limit_time(long seconds) {
    const itimerval limit{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Reports the seed of the world and ends the process. Calls only functions that a signal handler
/// may call.
extern "C" void report_crash(int signal) {
    std::array<char, 160> text{};
    char* at =
        std::ranges::copy(std::string_view(signal == SIGPROF ? "\nhang" : "\ncrash"), text.data())
            .out;
    at = std::ranges::copy(std::string_view(": fettle-bench wild --count 1 --seed "), at).out;
    at = std::to_chars(at, text.data() + text.size() - 1, running_seed).ptr;
    *at++ = '\n';
    [[maybe_unused]] const auto written =
        write(STDERR_FILENO, text.data(), std::size_t(at - text.data()));
    _exit(1);
}

void watch_for_crashes() {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGPROF})
        std::signal(signal, report_crash);
}

/// True if one of the engines is Box2D. Throws std::invalid_argument for an engine that cannot run
/// these worlds.
bool has_box2d(const WildOptions& options) {
    for (const std::string& name : options.engines) {
        if (name == "fettle") continue;
        if (name != "box2d")
            throw std::invalid_argument("worlds run in fettle and box2d, not in \"" + name + "\"");
        if (!wild::run_in_box2d(WorldPlan{}))
            throw std::invalid_argument("box2d is not built in; install " +
                                        std::string(engine_named(name).package) +
                                        " and build again");
        return true;
    }
    return false;
}

std::vector<std::string> names_of(const Survey& survey) {
    std::vector<std::string> names;
    for (const Invariant& invariant : wild::invariants()) names.push_back(invariant.name);
    names.insert(names.end(), {"same", "throws"});
    for (const Found& found : survey.found)
        if (std::ranges::count(names, found.finding.invariant) == 0)
            names.push_back(found.finding.invariant);
    return names;
}

void print_summary(bool box2d, const Survey& survey) {
    std::cout << survey.worlds << " worlds, " << survey.steps << " steps, "
              << figure(survey.seconds) << " s, " << survey.found.size() << " findings\n";
    std::vector<std::string> headers = {"invariant", "findings"};
    if (box2d) {
        std::cout << survey.peer_worlds << " of them in Box2D too\n";
        headers.insert(headers.end(), {"in Box2D", "Box2D holds", "of"});
    }
    std::cout << "\n";
    Table table(headers);
    for (const std::string& name : names_of(survey)) {
        const auto of_name = [&](const Found& found) { return found.finding.invariant == name; };
        const auto count = [&](const auto& matches) {
            return std::to_string(std::ranges::count_if(survey.found, [&](const Found& found) {
                return of_name(found) && matches(found);
            }));
        };
        std::vector<std::string> row = {name, count([](const Found&) { return true; })};
        if (box2d) {
            row.push_back(std::to_string(
                std::ranges::count(survey.peer_findings, name, &Finding::invariant)));
            row.push_back(count([](const Found& found) { return found.peer_holds; }));
            row.push_back(count([](const Found& found) { return found.peer_ran; }));
        }
        table.add(row);
    }
    std::cout << table.text();
}

void print(const Found& found) {
    std::cout << "seed " << found.seed << ", " << found.finding.invariant << ": "
              << found.finding.what << " (step " << found.finding.step << ")"
              << (found.peer_holds ? "; Box2D holds" : "") << "\n"
              << found.minimized << std::endl;
}

void print_json(const Found& found) {
    std::cout << json_line({{"seed", static_cast<long long>(found.seed)},
                            {"invariant", found.finding.invariant},
                            {"step", static_cast<long long>(found.finding.step)},
                            {"what", found.finding.what},
                            {"box2d", !found.peer_ran    ? JsonField()
                                      : found.peer_holds ? "holds"
                                                         : "fails"},
                            {"minimized", found.minimized}})
              << std::endl;
}

void print_json_summary(const Survey& survey) {
    std::cout << json_line({{"worlds", static_cast<long long>(survey.worlds)},
                            {"steps", survey.steps},
                            {"seconds", survey.seconds},
                            {"findings", static_cast<long long>(survey.found.size())}})
              << "\n";
}

}  // namespace

int run_wild(const WildOptions& options) {
    const bool box2d = has_box2d(options);
    watch_for_crashes();
    SurveyOptions wanted{.seed = options.seed,
                         .count = options.count,
                         .seconds = options.seconds,
                         .invariants = options.invariants,
                         .box2d = box2d,
                         .minimized = options.minimized};
    Survey result;
    {
        Progress progress(options.count);
        const auto begins = [&](std::uint64_t seed, std::size_t found) {
            running_seed = seed;
            limit_time(longest);
            if ((seed - wanted.seed) % 100 == 0)
                progress.begin("seed " + std::to_string(seed) + ", " + std::to_string(found) +
                               " findings");
            progress.add(1);
        };
        const auto finds = [&](const Found& found) {
            options.json ? print_json(found) : print(found);
        };
        result = survey(wanted, {begins, finds});
        limit_time(0);
    }
    options.json ? print_json_summary(result) : print_summary(box2d, result);
    return result.found.empty() ? 0 : 1;
}

}  // namespace fettle::bench
