#include <observed/waits.h>

#include <chrono>
#include <utility>

#include <fettle/property/exception_text.h>

#include <observed/game_time.h>
#include <observed/trace.h>

namespace fettle::console {

using property::Type;
using property::Value;

double Waits::now(std::string_view who) const {
    if (who.empty()) return passed_;
    if (clock) return clock();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double Waits::step_length() const {
    const Value dt = time_value(tree_, "dt");
    return dt.is(Type::number) ? dt.number() : 1.0 / 60;
}

void Waits::begin(std::string_view who, script::Wait wait) {
    Waiting its{.wait = std::move(wait), .first = {}};
    its.until = now(who) + its.wait.seconds;
    // A frame without a step comes before the first; half of a step, so that rounding adds none.
    if (who.empty()) its.until += 0.5 * step_length();
    if (const auto& condition = its.wait.condition) {
        try {
            condition->compute_formulas();
            its.first = condition->value();
        } catch (const std::exception& error) {
            its.result = {"✗ wait " + condition->text + ": " +
                          without_advice(property::exception_text(error))};
        }
    }
    all_.insert_or_assign(std::string(who), std::move(its));
}

void Waits::after_step() {
    for (auto& [who, its] : all_)
        if (!its.result) check_condition(its);
}

void Waits::between_frames() {
    passed_ += step_length();
    for (auto& [who, its] : all_)
        if (!its.result) check(who, its);
}

/// Where the game stands; "" if it runs.
std::string Waits::stands() const {
    const std::string step = " at step " + std::to_string(tree_.step());
    if (halted && halted()) return "the game stands after an error" + step;
    const Value paused = time_value(tree_, "paused");
    return paused.is(Type::boolean) && paused.boolean() ? "the game is paused" + step : "";
}

void Waits::check(std::string_view who, Waiting& its) const {
    check_condition(its);
    if (its.result) return;
    const bool only_time = !its.wait.condition && !its.wait.until_pause;
    if (const std::string where = only_time ? "" : stands(); !where.empty()) {
        its.result = {its.wait.until_pause ? where : "✗ wait: " + where + ": " + unmet(its)};
    } else if (now(who) >= its.until) {
        its.result.emplace();
        if (!only_time)
            its.result->push_back("✗ wait: after " + property::number_text(its.wait.seconds) +
                                  " s " + unmet(its));
    }
}

std::string Waits::unmet(const Waiting& its) const {
    if (its.wait.until_pause) return "the game runs on";
    const std::string& text = its.wait.condition->text;
    if (!its.problem.empty()) return text + " has no value: " + its.problem;
    return text + (its.first.is(Type::boolean) ? " is still false" : " has not changed");
}

void Waits::check_condition(Waiting& its) const {
    if (!its.wait.condition) return;
    const script::Observed& condition = *its.wait.condition;
    Value value;
    try {
        condition.compute_formulas();
        value = condition.value();
        its.problem.clear();
    } catch (const std::exception& error) {
        its.problem = without_advice(property::exception_text(error));
        return;
    }
    const bool boolean = value.is(Type::boolean) || its.first.is(Type::boolean);
    if (boolean ? !is_true(value) : value == its.first) return;
    its.result = {condition.text + (boolean ? " is true" : " has changed") + " at step " +
                  std::to_string(tree_.step())};
}

std::optional<std::vector<std::string>> Waits::result(std::string_view who) {
    const auto found = all_.find(std::string(who));
    if (found == all_.end()) return std::vector<std::string>();
    if (!found->second.result) return std::nullopt;
    std::vector<std::string> lines = std::move(*found->second.result);
    all_.erase(found);
    return lines;
}

}  // namespace fettle::console
