#pragma once
// The rows of the outline: unfolded instances, or instances that match a search. Only handles are
// stored. The drawing code reads names and values only for visible rows, so the cost per frame does
// not depend on the number of instances.

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

#include <inspector/instance_search.h>

namespace fettle::console {

class InstanceTree {
  public:
    struct Row {
        property::Handle instance;
        std::uint32_t depth;
        bool has_children;
        bool unfolded;
    };

    explicit InstanceTree(const property::Tree& tree);

    /// Rows in order. The list is made again when folding, the search or the number of instances
    /// changed, and from time to time because instances may be moved or renamed. `now`: real time
    /// in seconds, increasing.
    const std::vector<Row>& rows(double now);
    /// Searches by name, class or condition (instance_search.h); "" shows the outline.
    void search(std::string_view text);
    const std::string& searched() const { return search_; }
    /// The error in the text of the search; "" if it has none.
    const std::string& problem() const { return matches_.problem(); }
    bool searching() const { return matches_.running(); }
    void fold(property::Handle instance, bool unfolded);
    /// Unfolds all parents of the instance.
    void reveal(property::Handle instance);
    /// Row of an instance, or -1.
    std::ptrdiff_t row_of(property::Handle instance) const;

  private:
    void take_outline();
    void take_matches();
    bool unfolded(property::Handle instance) const;

    const property::Tree& tree_;
    std::vector<Row> rows_;
    std::unordered_set<std::uint64_t> unfolded_;
    std::string search_;
    InstanceSearch matches_;
    bool stale_ = true;
    double taken_at_ = 0;
    std::size_t taken_size_ = 0;
};

}  // namespace fettle::console
