#pragma once
// Notices that another branch of the past has become the present one.

#include <cstdint>
#include <optional>
#include <string>

#include <fettle/property/tree.h>

namespace fettle::console {

class PresentBranch {
  public:
    explicit PresentBranch(property::Tree& tree) : tree_(tree) {}

    /// If another branch is the present one since the last call: the last step that both have in
    /// common, or -1 if that is not known. What is kept of later steps does not hold any more.
    std::optional<std::int64_t> left_after();

  private:
    property::Tree& tree_;
    std::string name_;  // "" before the first call
};

}  // namespace fettle::console
