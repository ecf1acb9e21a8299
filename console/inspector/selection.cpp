#include <inspector/selection.h>

#include <algorithm>

namespace fettle::console {

using property::Handle;

std::vector<Handle> Selection::all() const {
    std::vector<Handle> all = others_;
    all.push_back(last_);
    std::erase_if(all, [&](Handle each) { return !tree_.alive(each); });
    return all;
}

bool Selection::contains(Handle instance) const {
    return instance == last_ || keys_.contains(instance.key());
}

bool Selection::of_one_class() {
    // Compares addresses: comparing the names takes a millisecond for 100,000 instances.
    const property::Class* const kind = &tree_.class_of(last_);
    if (compared_ != revision_ || compared_with_ != kind) {
        of_one_class_ = std::ranges::all_of(others_, [&](Handle each) {
            return !tree_.alive(each) || &tree_.class_of(each) == kind;
        });
        compared_ = revision_;
        compared_with_ = kind;
    }
    return of_one_class_;
}

void Selection::drop_others() {
    if (others_.empty()) return;
    others_.clear();
    keys_.clear();
    others_changed();
}

void Selection::select_only(Handle instance) {
    drop_others();
    last_ = instance;
}

void Selection::clear() {
    others_.clear();
    keys_.clear();
    last_ = {};
    others_changed();
}

void Selection::select(Handle instance) {
    if (instance == last_) return;
    if (!contains(instance)) return select_only(instance);
    std::erase(others_, instance);
    keys_.erase(instance.key());
    if (tree_.alive(last_)) {
        others_.push_back(last_);
        keys_.insert(last_.key());
    }
    last_ = instance;
    others_changed();
}

void Selection::select(const std::vector<Handle>& instances) {
    std::vector<Handle> all;
    std::unordered_set<std::uint64_t> keys;
    for (const Handle each : instances)
        if (tree_.alive(each) && keys.insert(each.key()).second) all.push_back(each);
    if (all.empty()) return;
    last_ = all.back();
    all.pop_back();
    keys.erase(last_.key());
    others_ = std::move(all);
    keys_ = std::move(keys);
    others_changed();
}

void Selection::others_changed() {
    ++revision_;
    unchecked_ = others_.size();
}

/// Each creation and each destruction makes it necessary to look at all again.
void Selection::drop_deleted() {
    if (looked_at_ != tree_.structure()) {
        looked_at_ = tree_.structure();
        unchecked_ = others_.size();
    }
    if (unchecked_ == 0) return;
    if (next_ >= others_.size()) next_ = 0;
    const std::size_t count = std::min({unchecked_, checked_in_a_frame, others_.size() - next_});
    unchecked_ -= count;
    const auto first = others_.begin() + static_cast<std::ptrdiff_t>(next_);
    const auto end = first + static_cast<std::ptrdiff_t>(count);
    const auto kept = std::remove_if(first, end, [&](Handle each) {
        const bool deleted = !tree_.alive(each);
        if (deleted) keys_.erase(each.key());
        return deleted;
    });
    next_ += static_cast<std::size_t>(kept - first);
    if (kept == end) return;
    const bool alike = of_one_class_ && compared_ == revision_;
    others_.erase(kept, end);
    ++revision_;
    if (alike) compared_ = revision_;  // without some of them, they still are
}

}  // namespace fettle::console
