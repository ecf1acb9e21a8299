#include "completion_menu.h"

#include <algorithm>

#include "fuzzy.h"
#include "utf8.h"

namespace fettle::console {

void CompletionMenu::show(std::vector<script::Completion> completions, std::string_view input,
                          std::size_t cursor) {
    candidates_.clear();
    candidates_.reserve(completions.size());
    for (script::Completion& completion : completions)
        candidates_.push_back({std::move(completion), {}, 0});
    keep_matching(input, cursor);
}

void CompletionMenu::narrow(std::string_view input, std::size_t cursor) {
    keep_matching(input, cursor);
}

void CompletionMenu::keep_matching(std::string_view input, std::size_t cursor) {
    for (Candidate& candidate : candidates_) {
        std::size_t from = candidate.completion.replace_from;
        candidate.score = -1;
        if (from > cursor || cursor > input.size()) continue;
        std::string_view typed = input.substr(from, cursor - from);
        // What is typed may be quoted or prefixed as in the text, or bare as in the label.
        auto in_label = fuzzy_match(typed, candidate.completion.label);
        if (!in_label && !fuzzy_match(typed, candidate.completion.text)) continue;
        candidate.score = in_label ? std::max(0, in_label->score) : 0;
        candidate.matched = in_label ? std::move(in_label->positions) : std::vector<std::size_t>{};
    }
    std::erase_if(candidates_, [](const Candidate& candidate) { return candidate.score < 0; });
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    open_ = !candidates_.empty();
    selected_ = 0;
}

void CompletionMenu::select(std::size_t index) {
    if (index < candidates_.size()) selected_ = index;
}

void CompletionMenu::step(std::ptrdiff_t rows) {
    auto count = static_cast<std::ptrdiff_t>(candidates_.size());
    if (count == 0) return;
    selected_ = static_cast<std::size_t>(
        ((static_cast<std::ptrdiff_t>(selected_) + rows) % count + count) % count);
}

void CompletionMenu::page(std::ptrdiff_t rows) {
    auto count = static_cast<std::ptrdiff_t>(candidates_.size());
    if (count == 0) return;
    selected_ = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(selected_) + rows, 0, count - 1));
}

std::string CompletionMenu::common_prefix() const {
    if (candidates_.empty()) return {};
    std::string_view common = candidates_.front().completion.text;
    for (const Candidate& candidate : candidates_) {
        if (candidate.completion.replace_from != candidates_.front().completion.replace_from)
            return {};
        const std::string& text = candidate.completion.text;
        auto end = std::mismatch(common.begin(), common.end(), text.begin(), text.end()).first;
        common = common.substr(0, static_cast<std::size_t>(end - common.begin()));
    }
    return std::string(common.substr(0, code_point_boundary(common, common.size())));
}

}  // namespace fettle::console
