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
    ++revision_;
}

void Selection::select_only(Handle instance) {
    drop_others();
    last_ = instance;
}

void Selection::clear() {
    others_.clear();
    keys_.clear();
    last_ = {};
    ++revision_;
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
    ++revision_;
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
    looked_at_ = tree_.structure();
    ++revision_;
}

void Selection::drop_deleted() {
    if (looked_at_ == tree_.structure()) return;
    looked_at_ = tree_.structure();
    const std::size_t dropped = std::erase_if(others_, [&](Handle each) {
        const bool deleted = !tree_.alive(each);
        if (deleted) keys_.erase(each.key());
        return deleted;
    });
    if (dropped > 0) ++revision_;
}

}  // namespace fettle::console
