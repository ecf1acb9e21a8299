#include <prompt/completion_menu.h>

#include <algorithm>

#include <fettle/script/fuzzy.h>

#include <text/utf8.h>

namespace fettle::console {

namespace {

/// The text between the place that the candidate replaces and the cursor. False if the cursor is
/// before that place.
bool typed_part(const script::Completion& completion, std::string_view input, std::size_t cursor,
                std::string_view& typed) {
    if (completion.replace_from > cursor || cursor > input.size()) return false;
    typed = input.substr(completion.replace_from, cursor - completion.replace_from);
    return true;
}

}  // namespace

// The candidates are sorted, best first.
void CompletionMenu::show(std::vector<script::Completion> completions, std::string_view input,
                          std::size_t cursor) {
    candidates_.clear();
    for (script::Completion& completion : completions) {
        std::string_view typed;
        if (!typed_part(completion, input, cursor, typed)) continue;
        auto match = script::fuzzy_match(typed, completion.label);
        candidates_.push_back({std::move(completion), {}});
        if (match) candidates_.back().matched = std::move(match->positions);
    }
    selected_ = 0;
    open_ = !candidates_.empty();
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

bool CompletionMenu::select_continuation(std::string_view input, std::size_t cursor) {
    std::size_t found = candidates_.size();
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const script::Completion& each = candidates_[i].completion;
        std::string_view typed;
        if (!typed_part(each, input, cursor, typed) || typed.empty()) return false;
        if (!each.text.starts_with(typed)) continue;
        if (found < candidates_.size() || each.text == typed) return false;
        found = i;
    }
    select(found);
    return found < candidates_.size();
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
