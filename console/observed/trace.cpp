#include <observed/trace.h>

#include <algorithm>
#include <cmath>

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

}  // namespace

void Trace::sample(bool past) {
    if (rest_ > 0) {
        --rest_;
        return;
    }
    try {
        if (!past) what_.compute_formulas();
        value_ = what_.value();
        problem_.clear();
    } catch (const std::exception& error) {
        value_ = {};
        problem_ = property::exception_text(error);
        rest_ = rest_after_error;
    }
}

void Trace::forget_after(std::int64_t step) {
    while (!samples_.empty() && samples_.back().step > step) samples_.pop_back();
}

void Trace::take(std::int64_t step, bool past) {
    forget_after(step - 1);
    sample(past);
    Sample sample{step, 0, 0};
    if (problem_.empty() && sample_of(value_, sample, vector_)) samples_.push_back(sample);
    if (samples_.size() > max_samples) samples_.pop_front();
}

std::string short_problem(const property::Tree& tree, const Trace& trace) {
    const std::string& problem = trace.problem();
    try {
        if (!trace.what().path.empty()) property::resolve(tree, trace.what().path);
    } catch (const property::Error&) {
        return problem.empty() ? problem : "deleted";
    }
    return problem.substr(0, problem.find(';'));
}

double Trace::largest(std::size_t last) const {
    double found = 0;
    for (std::size_t i = samples_.size() - std::min(samples_.size(), last); i < samples_.size();
         ++i)
        found = std::max({found, std::abs(samples_[i].x), vector_ ? std::abs(samples_[i].y) : 0});
    return found;
}

}  // namespace fettle::console
