#pragma once
// Conditions that pause the game when they become true.

#include <string>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/observed.h>

namespace fettle::console {

class Breaks {
  public:
    explicit Breaks(property::Tree& tree) : tree_(tree) {}

    /// Adds a condition; one with the same text is replaced. Returns what it waits for, and the
    /// present value or why there is none.
    std::string add(script::Observed condition);
    /// Returns how many were removed; "" is all of them.
    std::size_t remove(const std::string& text);
    std::size_t size() const { return all_.size(); }
    /// The conditions as they were typed.
    std::vector<std::string> texts() const;
    /// Those that mean the same in another run.
    std::vector<std::string> texts_to_keep() const;
    /// The text of the break that waits for a change of the value of that path; "" if there is
    /// none.
    std::string set_on(const std::string& path) const;
    /// Computes all conditions. Returns lines for the log about those that have become true (or,
    /// for a value that is not a boolean, have changed) since the last call.
    std::vector<std::string> check();
    /// From now on, `check` compares with the present values: the last ones are of a future that
    /// was left.
    void begin_again();

    /// A value with as many digits as tell it from others.
    std::string text_of(const property::Value& value) const;

  private:
    struct Break {
        script::Observed condition;
        property::Value last;
        bool failed = false;

        property::Value compute();  ///< the present value; throws what the condition throws
    };
    void describe(const Break& broken, const property::Value& before,
                  std::vector<std::string>& lines) const;

    property::Tree& tree_;
    std::vector<Break> all_;
};

/// The paths of properties in an expression.
std::vector<std::string> paths_in(const property::Tree& tree, std::string_view expression);

}  // namespace fettle::console
