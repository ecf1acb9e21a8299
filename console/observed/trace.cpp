#include <observed/trace.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>

namespace fettle::console {

using property::Type;

namespace {

// An expression that fails may take long to fail, so it is not tried in each step.
constexpr int rest_after_error = 30;

bool sample_of(const property::Value& value, Trace::Sample& sample, bool& vector) {
    vector = value.is(Type::vec2);
    if (vector) {
        sample.x = value.vec2().x;
        sample.y = value.vec2().y;
    } else if (value.is(Type::boolean)) {
        sample.x = value.boolean() ? 1 : 0;
    } else if (value.is_numeric()) {
        sample.x = value.as_double();
    } else {
        return false;
    }
    return std::isfinite(sample.x) && std::isfinite(sample.y);
}

bool has_form_of_path(const std::string& text) {
    try {
        return !property::parse_path(text).empty();
    } catch (const property::Error&) {
        return false;
    }
}

bool leads_to_something(const property::Tree& tree, const std::string& path) {
    try {
        property::resolve(tree, path);
        return true;
    } catch (const property::Error&) {
        return false;
    }
}

/// The path without its last name; "" for a path of one name.
std::string path_above(const std::string& path) {
    const std::size_t names = property::parse_path(path).size();
    for (std::size_t end = path.size(); end-- > 1;) {
        std::string above = path.substr(0, end);
        if ((path[end] == '.' || path[end] == '[') && has_form_of_path(above) &&
            property::parse_path(above).size() + 1 == names)
            return above;
    }
    return {};
}

/// What has become of an instance with that path: it has another name or parent, or one of those
/// that it is in. The names after the changed one are left out.
std::string change_of_path(const std::string& from, const std::string& to) {
    std::string was = from, now = to, above = path_above(was), above_now = path_above(now);
    while (was.substr(above.size()) == now.substr(above_now.size()) && !above.empty() &&
           !above_now.empty() && above != above_now) {
        was = std::exchange(above, path_above(above));
        now = std::exchange(above_now, path_above(above_now));
    }
    return (above == above_now ? "renamed to " : "moved to ") + now;
}

}  // namespace

std::string without_advice(const std::string& problem) {
    return problem.substr(0, problem.find(';'));
}

Trace::Trace(script::Observed what)
    : what_(std::move(what)), is_path_(has_form_of_path(what_.text)) {}

void Trace::sample(const property::Tree& tree, bool past) {
    if (rest_ > 0) {
        --rest_;
        return;
    }
    try {
        if (!past) what_.compute_formulas();
        value_ = what_.value();
        problem_.clear();
        const auto step = static_cast<std::int64_t>(tree.step());
        if (first_ < 0 || step < first_) first_ = step;
        if (is_path_ && !located_) locate(tree);
    } catch (const std::exception& error) {
        value_ = {};
        problem_ = property::exception_text(error);
        located_ = false;
        // A path fails at once.
        rest_ = is_path_ ? 0 : rest_after_error;
    }
}

/// The instance may be made long after the path was given.
void Trace::locate(const property::Tree& tree) {
    located_ = true;
    try {
        const property::Place place = property::resolve(tree, what_.text);
        instance_ = place.instance;
        home_ = tree.path(instance_);
        if (place.property == nullptr) return;
        what_.path = what_.text;
        what_.unit = place.property->unit;
    } catch (const property::Error&) {
        // A variable of a script.
    }
}

std::string Trace::absence(const property::Tree& tree) const {
    const bool lives = tree.alive(instance_) && tree.is_below(instance_, tree.root());
    if (lives && tree.path(instance_) != home_) return change_of_path(home_, tree.path(instance_));
    return first_ < 0 || static_cast<std::int64_t>(tree.step()) < first_ ? "not yet there"
                                                                         : "deleted";
}

std::string Trace::short_problem(const property::Tree& tree) const {
    if (problem_.empty() || !is_path_ || leads_to_something(tree, what_.text))
        return without_advice(problem_);
    if (!home_.empty()) return absence(tree);
    // There was no value yet: a name that resembles another one is probably misspelled.
    const bool misspelled = problem_.find("(did you mean") != std::string::npos;
    const bool owned = leads_to_something(tree, path_above(what_.text));
    return misspelled || owned ? without_advice(problem_) : absence(tree);
}

void Trace::forget_after(std::int64_t step) {
    while (!samples_.empty() && samples_.back().step > step) samples_.pop_back();
}

void Trace::take(const property::Tree& tree, std::int64_t step, bool past) {
    forget_after(step - 1);
    sample(tree, past);
    Sample sample{step, 0, 0};
    if (problem_.empty() && sample_of(value_, sample, vector_)) samples_.push_back(sample);
    if (samples_.size() > max_samples) samples_.pop_front();
}

double Trace::largest(std::size_t last) const {
    double found = 0;
    for (std::size_t i = samples_.size() - std::min(samples_.size(), last); i < samples_.size();
         ++i)
        found = std::max({found, std::abs(samples_[i].x), vector_ ? std::abs(samples_[i].y) : 0});
    return found;
}

}  // namespace fettle::console
