#include <inspector/instance_tree.h>

#include <algorithm>

namespace fettle::console {

using property::Handle;

namespace {

constexpr double refresh_seconds = 0.2;       // after instances were created or deleted
constexpr double slow_refresh_seconds = 1.0;  // in case instances were moved or renamed
constexpr std::size_t slow_refresh_rows = 5000;

}  // namespace

InstanceTree::InstanceTree(const property::Tree& tree) : tree_(tree), matches_(tree) {
    fold(tree.root(), true);
    if (Handle world = tree.child(tree.root(), "world")) fold(world, true);
}

bool InstanceTree::unfolded(Handle instance) const {
    return unfolded_.contains(instance.key());
}

void InstanceTree::fold(Handle instance, bool unfolded) {
    if (unfolded)
        unfolded_.insert(instance.key());
    else
        unfolded_.erase(instance.key());
    stale_ = true;
}

void InstanceTree::reveal(Handle instance) {
    for (Handle above = tree_.parent(instance); above; above = tree_.parent(above))
        if (!unfolded(above)) fold(above, true);
    stale_ = true;  // it may have been moved there
}

void InstanceTree::search(std::string_view text) {
    if (text == search_) return;
    search_ = text;
    matches_.begin(search_);
    stale_ = true;
}

const std::vector<InstanceTree::Row>& InstanceTree::rows(double now) {
    double age = now - taken_at_;
    bool changed = tree_.size() != taken_size_ && age > refresh_seconds;
    bool old = age > slow_refresh_seconds && tree_.size() < slow_refresh_rows;
    if (!search_.empty()) {
        // Values that a condition reads change all the time; a search is a part of a frame's work.
        if (!matches_.running() && (changed || age > slow_refresh_seconds)) {
            matches_.begin_again();
            taken_at_ = now;
            taken_size_ = tree_.size();
        }
        if (matches_.advance() || stale_) take_matches();
        stale_ = false;
    } else if (stale_ || changed || old) {
        rows_.clear();
        take_outline();
        stale_ = false;
        taken_at_ = now;
        taken_size_ = tree_.size();
    }
    return rows_;
}

void InstanceTree::take_outline() {
    // A loop without recursion. The next row is the first child, or the next sibling, or the next
    // sibling of the nearest parent that has one.
    Handle at = tree_.root();
    std::uint32_t depth = 0;
    while (at) {
        Handle child = tree_.first_child(at);
        bool open = child && unfolded(at);
        rows_.push_back({at, depth, static_cast<bool>(child), open});
        if (open) {
            at = child;
            ++depth;
            continue;
        }
        while (at && depth > 0 && !tree_.next_sibling(at)) {
            at = tree_.parent(at);
            --depth;
        }
        at = depth > 0 ? tree_.next_sibling(at) : Handle{};
    }
}

void InstanceTree::take_matches() {
    rows_.clear();
    for (const Handle instance : matches_.found()) rows_.push_back({instance, 0, false, false});
}

std::ptrdiff_t InstanceTree::row_of(Handle instance) const {
    auto found = std::find_if(rows_.begin(), rows_.end(),
                              [&](const Row& row) { return row.instance == instance; });
    return found == rows_.end() ? -1 : found - rows_.begin();
}

}  // namespace fettle::console
