#pragma once
// The values of an observed expression, step by step.

#include <cstdint>
#include <deque>
#include <string>

#include <fettle/property/tree.h>
#include <fettle/property/value.h>
#include <fettle/script/observed.h>

namespace fettle::console {

class Trace {
  public:
    static constexpr std::size_t max_samples = 36'000;

    struct Sample {
        std::int64_t step;
        double x, y;  // y: of vectors only
    };

    explicit Trace(script::Observed what);

    const script::Observed& what() const { return what_; }
    /// Computes the value and stores it as that of the step. Later samples are dropped, because the
    /// game went back and goes on from here.
    /// `past`: the past is shown, so formulas are not computed.
    void take(const property::Tree& tree, std::int64_t step, bool past = false);
    /// Drops the samples of later steps.
    void forget_after(std::int64_t step);
    /// Computes the value without storing it.
    void sample(const property::Tree& tree, bool past = false);
    /// The same for an expression that has just failed, which otherwise is not tried in each step.
    void sample_at_once(const property::Tree& tree) {
        rest_ = 0;
        sample(tree);
    }
    /// Why there is no value now, in few words; "" if there is one. For the path of an instance
    /// that is not there: "deleted", "not yet there", or what it is renamed to. Otherwise the
    /// problem without its advice.
    std::string short_problem(const property::Tree& tree) const;

    /// The last computed value; nil if that failed, and then `problem` is the reason.
    const property::Value& value() const { return value_; }
    const std::string& problem() const { return problem_; }
    /// Ascending by step. Only numbers, vectors and booleans (0 and 1) have samples.
    const std::deque<Sample>& samples() const { return samples_; }
    bool is_vector() const { return vector_; }
    /// The largest size of a number in the last samples; 0 without samples.
    double largest(std::size_t last = max_samples) const;
    /// Whether the kept past is to be read for this trace.
    bool needs_past = true;

  private:
    void locate(const property::Tree& tree);
    std::string absence(const property::Tree& tree) const;

    script::Observed what_;
    bool is_path_ = false;       // the text has the form of a path
    property::Handle instance_;  // the instance with the property, when there was a value last
    std::string home_;           // its path then; "" without such an instance
    bool located_ = false;       // `instance_` and `home_` are those of the present value
    std::int64_t first_ = -1;    // the earliest step with a value; -1: there was none yet
    property::Value value_;
    std::string problem_;
    std::deque<Sample> samples_;
    bool vector_ = false;
    int rest_ = 0;  // calls without computing, after an error
};

/// The text of an error without what follows a semicolon, which is advice for scripts.
std::string without_advice(const std::string& problem);

/// As Lua: everything but nil and false.
inline bool is_true(const property::Value& value) {
    return !value.is_nil() && !(value.is(property::Type::boolean) && !value.boolean());
}

}  // namespace fettle::console
