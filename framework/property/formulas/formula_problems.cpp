// Errors of formulas, their reports, and explanations of computed values.

#include <algorithm>
#include <cctype>
#include <unordered_set>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/formula_problems.h>

#include "formulas.h"

namespace fettle::property {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The text without its numbers. Two errors that differ only in numbers count as the same error: a
/// formula may print its current value, which differs in each step. Numbers of lines (":5:") and in
/// names ("ball_2") stay.
std::string without_numbers(std::string_view text) {
    std::string rest;
    const auto is_part = [&](std::size_t i) {
        return is_digit(text[i]) || text[i] == '.' ||
               ((text[i] == '-' || text[i] == '+') && i > 0 && text[i - 1] == 'e') ||
               (text[i] == 'e' && i + 1 < text.size() &&
                (is_digit(text[i + 1]) || text[i + 1] == '-' || text[i + 1] == '+'));
    };
    for (std::size_t i = 0; i < text.size();) {
        const bool in_name =
            !rest.empty() &&
            (std::isalnum(static_cast<unsigned char>(rest.back())) || rest.back() == '_');
        if (!is_digit(text[i]) || in_name) {
            rest += text[i++];
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && is_part(end)) ++end;
        const bool is_line = i > 0 && text[i - 1] == ':' && end < text.size() && text[end] == ':';
        if (is_line)
            rest += text.substr(i, end - i);
        else if (rest.ends_with('-'))
            rest.pop_back();
        i = end;
    }
    return rest;
}

}  // namespace

/// Whether the formula fails only because it reads another formula that fails.
bool Formulas::fails_by_another(const Entry& e) const {
    return std::any_of(e.dependencies.begin(), e.dependencies.end(), [&](const Dependency& d) {
        const Entry* source = d.formula ? entry(d.cell) : nullptr;
        return source != nullptr && source != &e && !source->error.empty() &&
               e.error.find(source->error) != std::string::npos;
    });
}

void Formulas::report_problems() {
    if (!std::exchange(problems_changed_, false)) return;
    std::vector<FormulaProblem> new_problems;
    std::unordered_set<std::string> circles;
    for (const std::shared_ptr<Entry>& e : order_) {
        if (e->removed) continue;
        if (e->error.empty()) {
            reported_.erase(e->cell);
            continue;
        }
        // Formulas in a circle fail by themselves and by each other in turn.
        if (e->cycle.empty() && fails_by_another(*e)) continue;
        std::string problem = without_numbers(e->error);
        if (std::exchange(reported_[e->cell], problem) == problem) continue;
        if (!e->cycle.empty() && !circles.insert(e->error).second) continue;
        new_problems.push_back({e->instance, tree_.path(e->instance, *e->property), e->error});
    }
    for (const FormulaProblem& problem : new_problems)
        if (const auto sink = problem_sink; sink && !changes_.lifetime.ending) sink(problem);
}

void Formulas::problem_reported(Cell cell) {
    if (const Entry* e = entry(cell); e != nullptr && !e->error.empty())
        reported_[cell] = without_numbers(e->error);
}

std::string Formulas::problem(Cell cell) {
    const auto found = entries_.find(cell);
    if (found == entries_.end()) return {};
    const std::shared_ptr<Entry> e = found->second;
    try {
        settle(cell);
    } catch (const Error& error) {
        return e->error.empty() ? error.what() : e->error;
    }
    return {};
}

Explanation Formulas::why(Handle instance, const Property& property, std::vector<Cell>& seen,
                          int levels) {
    Explanation out;
    out.path = tree_.path(instance, property);
    const Cell cell{instance.index, property.symbol};
    out.problem = problem(cell);
    const std::string unit = property.unit.empty() ? "" : " " + property.unit;
    out.value = tree_.text(tree_.peek(instance, property), property.precision()) + unit;
    const Entry* e = entry(cell);
    if (e == nullptr) return out;
    out.source = e->formula.source.empty() ? "a function" : e->formula.source;
    if (std::find(seen.begin(), seen.end(), cell) != seen.end()) {
        out.repeated = true;
        return out;
    }
    seen.push_back(cell);
    if (levels == 0) {
        Explanation& rest = out.from.emplace_back();
        rest.path = "…";
        rest.value = "what is below is left out";
        return out;
    }
    const std::vector<Dependency> dependencies = e->dependencies;
    for (const Dependency& d : dependencies)
        if (d.property != nullptr && tree_.alive(d.instance))
            out.from.push_back(why(d.instance, *d.property, seen, levels - 1));
    return out;
}

}  // namespace fettle::property
