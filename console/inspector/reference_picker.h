#pragma once
// A list to choose an instance from: those a reference property takes, narrowed by typing.

#include <optional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

class ReferencePicker {
  public:
    explicit ReferencePicker(const property::Tree& tree) : tree_(tree) {}

    /// A small button that opens the list. What was chosen: a null handle for none, offered when
    /// the property takes nil.
    std::optional<property::Handle> draw(const property::Property& property,
                                         property::Handle current);

  private:
    void take_candidates(const property::Property& property);

    const property::Tree& tree_;
    std::string search_, taken_for_;
    std::vector<property::Handle> candidates_;
    bool stale_ = true;
};

}  // namespace fettle::console
