#include <inspector/instance_search.h>

#include <algorithm>
#include <functional>

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>
#include <fettle/script/fuzzy.h>

namespace fettle::console {

using property::Handle;

namespace {

/// Steps of work in a frame; looking at a name is one, as is an operation of a condition.
constexpr std::size_t work_in_a_frame = 8000;
constexpr std::size_t most_similar = 200;
constexpr std::size_t shortest_similar = 3;  // letters

/// Whether the class derives from one of that name. Not from Object, as all of them do.
bool derives_from(const property::Class& of, std::string_view name) {
    for (const property::Class* base = of.base(); base != nullptr && base->base() != nullptr;
         base = base->base())
        if (base->name().size() == name.size() &&
            property::contains_ignoring_case(base->name(), name))
            return true;
    return false;
}

/// The next one in the order of `each_below`; null after the last.
Handle next_of(const property::Tree& tree, Handle at) {
    if (const Handle child = tree.first_child(at)) return child;
    for (; at; at = tree.parent(at))
        if (const Handle next = tree.next_sibling(at)) return next;
    return {};
}

}  // namespace

void InstanceSearch::begin(std::string_view text) {
    text_ = text;
    found_.clear();
    problem_.clear();
    condition_.reset();
    at_ = {};
    first_ = true;
    if (text_.empty()) return;
    if (property::Condition::is_meant(text_)) {
        try {
            condition_.emplace(text_);
        } catch (const property::Error& error) {
            problem_ = error.what();
            return;
        }
    }
    begin_again();
}

void InstanceSearch::begin_again() {
    if (text_.empty() || (property::Condition::is_meant(text_) && !condition_)) return;
    matches_.clear();
    similar_.clear();
    at_ = tree_.root();
}

bool InstanceSearch::advance() {
    if (!at_) return false;
    if (!tree_.alive(at_)) {  // the next instance was deleted
        begin_again();
        return false;
    }
    const std::size_t each = condition_ ? 1 + condition_->weight() : 4;
    for (std::size_t work = 0; at_ && work < work_in_a_frame; work += each) {
        look_at(at_);
        at_ = next_of(tree_, at_);
    }
    if (!at_)
        end();
    else if (first_ && found_.size() != matches_.size())
        found_.insert(found_.end(), matches_.begin() + static_cast<std::ptrdiff_t>(found_.size()),
                      matches_.end());
    else
        return false;
    return true;
}

void InstanceSearch::look_at(Handle instance) {
    if (condition_) {
        if (condition_->holds(tree_, instance)) matches_.push_back(instance);
        return;
    }
    const std::string name = tree_.name(instance);
    const bool by_path = text_.find('.') != std::string::npos;
    const property::Class& of = tree_.class_of(instance);
    if (property::contains_ignoring_case(name, text_) ||
        property::contains_ignoring_case(of.name(), text_) || derives_from(of, text_) ||
        (by_path && property::contains_ignoring_case(tree_.path(instance), text_))) {
        matches_.push_back(instance);
    } else if (text_.size() >= shortest_similar && similar_.size() < 10 * most_similar) {
        if (const auto match = script::fuzzy_match(text_, name))
            similar_.emplace_back(match->score, instance);
    }
}

void InstanceSearch::end() {
    std::ranges::stable_sort(similar_, std::greater(), &std::pair<int, Handle>::first);
    if (similar_.size() > most_similar) similar_.resize(most_similar);
    found_ = std::move(matches_);
    for (const auto& [score, instance] : similar_) found_.push_back(instance);
    matches_.clear();
    first_ = false;
    problem_ = condition_ && found_.empty() ? condition_->problem(tree_) : std::string();
}

}  // namespace fettle::console
