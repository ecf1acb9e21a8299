#pragma once
// The candidates of a completion: those that fit what is typed, the best ones first.

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fettle/property/natural_order.h>
#include <fettle/script/fuzzy.h>
#include <fettle/script/reference.h>
#include <fettle/script/runtime.h>

namespace fettle::script {

// Order of completions while no letter is typed: values, then functions, then the rest.
enum class Group : int { value, function, other };

// Adds detail and documentation to a candidate that has its text and its label. Called for those
// that are listed, after all have been compared.
using Describe = std::function<void(Completion& candidate)>;

inline Describe described(std::string detail, std::string doc = {}) {
    return [detail = std::move(detail), doc = std::move(doc)](Completion& candidate) mutable {
        candidate.detail = std::move(detail);
        candidate.doc = std::move(doc);
    };
}

class Candidates {
  public:
    Candidates(std::string_view typed, std::size_t replace_from)
        : typed_(typed), replace_from_(replace_from) {}

    void add(std::string_view label, Describe describe, Group group) {
        add_as(label, {}, replace_from_, std::move(describe), group);
    }
    /// `text`: what is typed for it; "" for its label.
    void add_as(std::string_view label, std::string_view text, std::size_t from, Describe describe,
                Group group) {
        // First, because thousands of names are compared and few of them fit.
        const std::optional<int> fits = fuzzy_score(typed_, label);
        if (!fits) return;
        entries_.push_back({.score = *fits + (expected_ ? 10'000 : 0),
                            .group = group,
                            .order = entries_.size(),
                            .from = from,
                            .label = std::string(label),
                            .text = std::string(text),
                            .describe = std::move(describe)});
    }
    /// Entries that are added after `expect(true)` fit this place best and come first.
    void expect(bool expected) { expected_ = expected; }
    std::string_view typed() const { return typed_; }
    std::size_t replace_from() const { return replace_from_; }

    /// The best ones, `most` at most. Of those with the same label, the best one, or else the
    /// first.
    std::vector<Completion> best(std::size_t most) {
        // A heap, because only the few entries that are listed have to be ordered.
        std::vector<Entry*> heap;
        for (Entry& entry : entries_) heap.push_back(&entry);
        const auto worse = [](const Entry* a, const Entry* b) {
            if (std::tie(a->score, b->group) != std::tie(b->score, a->group))
                return std::tie(a->score, b->group) < std::tie(b->score, a->group);
            if (a->label != b->label) return property::NaturalOrder{}(b->label, a->label);
            return b->order < a->order;
        };
        std::ranges::make_heap(heap, worse);
        std::vector<Completion> result;
        std::unordered_set<std::string> labels;
        for (; !heap.empty() && result.size() < most; heap.pop_back()) {
            std::ranges::pop_heap(heap, worse);
            Entry& entry = *heap.back();
            if (!labels.insert(entry.label).second) continue;
            Completion& taken = result.emplace_back(
                Completion{.text = entry.text.empty() ? entry.label : std::move(entry.text),
                           .label = std::move(entry.label),
                           .detail = {},
                           .doc = {},
                           .replace_from = entry.from});
            if (entry.describe) entry.describe(taken);
            taken.doc = shown_doc(taken.doc);
        }
        return result;
    }

  private:
    struct Entry {
        int score;
        Group group;
        std::size_t order, from;
        std::string label, text;
        Describe describe;
    };
    std::string_view typed_;
    std::size_t replace_from_;
    std::deque<Entry> entries_;  // grows without moving what it has
    bool expected_ = false;
};

}  // namespace fettle::script
