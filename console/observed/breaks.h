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

    /// Returns why the condition cannot be computed now; "" if it can.
    std::string add(script::Observed condition);
    void clear() { all_.clear(); }
    std::size_t size() const { return all_.size(); }
    /// The conditions as they were typed, but for functions: the text of a function does not
    /// contain the variables that it uses.
    std::vector<std::string> texts() const;
    /// Computes all conditions. Returns lines for the log about those that have become true (or,
    /// for a value that is not a boolean, have changed) since the last call.
    std::vector<std::string> look();

  private:
    struct Break {
        script::Observed condition;
        property::Value last;
        bool failed = false;
    };
    std::string text_of(const property::Value& value) const;
    void describe(const Break& broken, const property::Value& before,
                  std::vector<std::string>& lines) const;

    property::Tree& tree_;
    std::vector<Break> all_;
};

/// The paths of properties in an expression.
std::vector<std::string> paths_in(const property::Tree& tree, std::string_view expression);

}  // namespace fettle::console
