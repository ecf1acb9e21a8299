#pragma once
// The list of completion candidates under the prompt. Tab opens it; typing updates it.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::console {

class CompletionMenu {
  public:
    struct Candidate {
        script::Completion completion;
        std::vector<std::size_t> matched;  // bytes of the label that match the typed text
    };

    bool open() const { return open_; }
    void close() { open_ = false; }
    /// Shows the candidates; closes the list if there are none.
    void show(std::vector<script::Completion> completions, std::string_view input,
              std::size_t cursor);

    const std::vector<Candidate>& candidates() const { return candidates_; }
    std::size_t selected() const { return selected_; }
    const script::Completion& selection() const { return candidates_[selected_].completion; }
    void select(std::size_t index);
    /// Moves by a number of rows; wraps around at the ends.
    void step(std::ptrdiff_t rows);
    void page(std::ptrdiff_t rows);  // stops at the ends

    /// Selects the only candidate that begins with the typed text and is longer, if there is one:
    /// the others only resemble it.
    bool select_continuation(std::string_view input, std::size_t cursor);
    /// The common beginning of all candidates, if all replace text from the same position.
    std::string common_prefix() const;

  private:
    std::vector<Candidate> candidates_;
    std::size_t selected_ = 0;
    bool open_ = false;
};

}  // namespace fettle::console
