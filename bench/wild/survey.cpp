#include "wild/survey.h"

#include <algorithm>
#include <map>

#include "measure/timing.h"
#include "report/table.h"
#include "wild/checks/facts.h"
#include "wild/generator/random_world.h"
#include "wild/minimize.h"
#include "wild/plans/cpp_text.h"
#include "wild/same_runs.h"

namespace fettle::bench::wild {
namespace {

bool has(const PlanRun& result, const std::string& invariant) {
    return std::ranges::count(result.findings, invariant, &Finding::invariant) > 0;
}

class Surveyor {
  public:
    Surveyor(const SurveyOptions& options, const Listener& listener)
        : options_(options), listener_(listener), watched_(invariants_named(options.invariants)) {
        const auto& names = options.invariants;
        compare_ = names.empty() || std::ranges::count(names, "same") > 0;
    }

    void run_seed(std::uint64_t seed, Survey& survey) {
        const WorldPlan plan = random_world(seed, options_.size);
        const PlanRun result = try_in_fettle(plan, watched_, compare_);
        ++survey.worlds;
        survey.steps += result.steps;
        PlanRun peer;
        const bool peer_ran = options_.box2d && try_in_peer(plan, peer);
        survey.peer_worlds += peer_ran;
        for (const Finding& finding : peer.findings) survey.peer_findings.push_back(finding);
        // The time of one world varies by chance, but hardly by a factor of two and a second.
        if (peer_ran && can_rest(plan) && result.awake > 2 * peer.awake + 1)
            add(survey, {seed,
                         {"slower to rest", plan.steps,
                          "awake for " + figure(result.awake) + " s, in Box2D for " +
                              figure(peer.awake) + " s"},
                         true,
                         true,
                         {}});
        for (const Finding& finding : result.findings) {
            Found found{seed, finding, peer_ran, peer_ran && !has(peer, finding.invariant), {}};
            if (minimized_[finding.invariant]++ < options_.minimized)
                found.minimized = minimize(plan, found.finding);
            add(survey, std::move(found));
        }
    }

  private:
    bool try_in_peer(const WorldPlan& plan, PlanRun& result) const {
        if (!run_in_box2d(plan)) return false;
        result = try_plan(plan, run_in_box2d, watched_);
        return true;
    }

    /// The finding in the smaller world replaces `finding`.
    std::string minimize(const WorldPlan& plan, Finding& finding) const {
        const std::string& name = finding.invariant;
        std::vector<Invariant> one;
        std::ranges::copy_if(watched_, std::back_inserter(one),
                             [&](const Invariant& each) { return each.name == name; });
        const auto run = [&](const WorldPlan& candidate) {
            return try_in_fettle(candidate, one, name == "same");
        };
        const float fault = fault_at_start(plan);
        const WorldPlan small = minimized(plan, [&](const WorldPlan& candidate) {
            return has(run(candidate), name) && fault_at_start(candidate) <= fault;
        });
        for (const Finding& each : run(small).findings)
            if (each.invariant == name) finding = each;
        return cpp_text(small);
    }

    void add(Survey& survey, Found found) const {
        if (listener_.finds) listener_.finds(found);
        survey.found.push_back(std::move(found));
    }

    const SurveyOptions& options_;
    const Listener& listener_;
    std::vector<Invariant> watched_;
    bool compare_ = false;
    std::map<std::string, int> minimized_;
};

}  // namespace

PlanRun try_in_fettle(const WorldPlan& plan, std::span<const Invariant> watched, bool compare) {
    PlanRun result = try_plan(plan, run_in_fettle, watched);
    if (compare && !has(result, "throws")) {
        if (auto finding = compare_runs(plan)) result.findings.push_back(std::move(*finding));
    }
    return result;
}

Survey survey(const SurveyOptions& options, const Listener& listener) {
    const WallClock clock;
    Survey survey;
    Surveyor surveyor(options, listener);
    for (int i = 0; i < options.count; ++i) {
        if (options.seconds > 0 && clock.elapsed_ms() > 1000 * options.seconds) break;
        const std::uint64_t seed = options.seed + std::uint64_t(i);
        if (listener.begins) listener.begins(seed, survey.found.size());
        surveyor.run_seed(seed, survey);
    }
    survey.seconds = clock.elapsed_ms() / 1000;
    return survey;
}

}  // namespace fettle::bench::wild
