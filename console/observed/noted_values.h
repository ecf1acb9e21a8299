#pragma once
// The values that people and scripts write, noted at one moment, to compare two moments.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

class NotedValues {
  public:
    static constexpr std::size_t most = 200'000;  ///< values

    NotedValues() = default;
    /// Notes the values of all instances, except those that the simulation computes or that are not
    /// saved.
    explicit NotedValues(const property::Tree& tree);
    /// Whether there were no more than `most`.
    bool complete() const { return complete_; }

    struct Noted {
        std::string name;
        property::Value value;
        std::string unit;
    };
    /// By the paths of the instances.
    const std::map<std::string, std::vector<Noted>>& instances() const { return instances_; }

  private:
    std::map<std::string, std::vector<Noted>> instances_;
    bool complete_ = true;
};

/// Lines for each property with values that differ, ordered by the paths of the first instances,
/// and for three instances each: "world.ball.mass: A 2 kg, B 5 kg; and in 3 others"; and a line for
/// each instance that only one of both has.
std::vector<std::string> differences(const property::Tree& tree, const NotedValues& a,
                                     const NotedValues& b);

}  // namespace fettle::console
