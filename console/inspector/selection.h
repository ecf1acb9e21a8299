#pragma once
// The selected instances. A hundred thousand of them take almost no time in a frame: data that
// depends on all of them is computed only when they change.

#include <cstdint>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

class Selection {
  public:
    explicit Selection(const property::Tree& tree) : tree_(tree) {}

    /// The instance that was selected last; it stays when it is deleted. Null: there is none.
    property::Handle last() const { return last_; }
    /// The other selected instances.
    const std::vector<property::Handle>& others() const { return others_; }
    /// A number that changes whenever `others` does.
    std::uint64_t revision() const { return revision_; }
    /// All selected instances that are alive; `last` is at the end.
    std::vector<property::Handle> all() const;
    std::size_t count() const { return others_.size() + (last_ ? 1 : 0); }
    bool contains(property::Handle instance) const;
    /// Whether all are of the class of the last one, which must be alive.
    bool of_one_class();

    /// Makes it the last one. The others stay selected if it was one of them.
    void select(property::Handle instance);
    void select_only(property::Handle instance);
    void clear();
    /// Selects these; the last one that is alive is `last`.
    void select(const std::vector<property::Handle>& instances);
    /// Call once a frame: the others that were deleted are dropped. It looks at some of them, so
    /// that in a game that makes and deletes instances in each frame thousands cost no more than a
    /// few; until all were looked at, `others` may have deleted ones.
    void drop_deleted();
    static constexpr std::size_t checked_in_a_frame = 5000;

  private:
    void drop_others();
    void others_changed();

    const property::Tree& tree_;
    property::Handle last_;
    std::vector<property::Handle> others_;
    std::unordered_set<std::uint64_t> keys_;  // of the others
    std::uint64_t revision_ = 0;
    std::uint64_t looked_at_ = 0;  // structure of the tree when deleted ones were looked for
    std::size_t unchecked_ = 0;    // how many are to be looked at since then
    std::size_t next_ = 0;         // the index of the next one
    std::uint64_t compared_ = ~std::uint64_t{0};  // revision when the classes were compared
    const property::Class* compared_with_ = nullptr;
    bool of_one_class_ = true;
};

}  // namespace fettle::console
