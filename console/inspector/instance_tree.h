#pragma once
// The instances as rows of an outline: the unfolded ones, and those that match a search. Only a
// list of handles is kept; the drawing code reads names and values of the visible rows, so that 100
// 000 instances cost no more than a screenful.

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

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

    /// Rows in order. Taken anew when folding, search or the number of instances changed, and from
    /// time to time for what moved or was renamed; `now`: real seconds, growing.
    const std::vector<Row>& rows(double now);
    /// By name or class, letter case ignored; "" shows the outline.
    void search(std::string_view text);
    const std::string& searched() const { return search_; }
    void fold(property::Handle instance, bool unfolded);
    /// Unfolds everything above the instance.
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
    bool stale_ = true;
    double taken_at_ = 0;
    std::size_t taken_size_ = 0;
};

}  // namespace fettle::console
