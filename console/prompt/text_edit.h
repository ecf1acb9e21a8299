#pragma once
// The text being typed: cursor, selection, motions by character, word and line, and undo. It does
// not depend on keys or pixels. Offsets are bytes at code point boundaries.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fettle::console {

enum class Motion {
    left,
    right,
    word_left,
    word_right,
    line_start,
    line_end,
    line_up,
    line_down,
    text_start,
    text_end
};

class TextEdit {
  public:
    static constexpr std::size_t max_bytes = std::size_t{1} << 20;

    const std::string& text() const { return text_; }
    bool empty() const { return text_.empty(); }
    std::size_t cursor() const { return cursor_; }
    bool selecting() const { return cursor_ != anchor_; }
    /// Begin and end of the selection; without one, both are the cursor.
    std::pair<std::size_t, std::size_t> selection() const;
    std::string_view selected() const;

    /// Replaces the whole text and moves the cursor to the end.
    void assign(std::string_view text);
    /// There is nothing to undo or redo any more.
    void clear_steps() {
        undo_.clear();
        redo_.clear();
        typing_ = false;
    }
    /// Bytes that may take the place of the selection.
    std::size_t room() const { return max_bytes - (text_.size() - selected().size()); }
    /// Replaces the selection. Text beyond `max_bytes` is dropped.
    void insert(std::string_view text);
    void replace(std::size_t from, std::size_t to, std::string_view text);
    void move(Motion motion, bool select);
    /// Deletes the selection or, without one, the text that the motion would skip.
    void erase(Motion motion);
    void place(std::size_t offset, bool select);
    void select(std::size_t from, std::size_t to);
    void select_all() { select(0, text_.size()); }
    void select_word(std::size_t offset);
    bool undo();
    bool redo();

    // Lines count from 0, columns in code points from 0.
    std::size_t line_count() const;
    std::size_t line_of(std::size_t offset) const;
    std::size_t column_of(std::size_t offset) const;
    std::size_t offset_at(std::size_t line, std::size_t column) const;
    std::string_view line(std::size_t index) const;

  private:
    struct State {
        std::string text;
        std::size_t cursor, anchor;
    };
    std::size_t target(Motion motion) const;
    void save_for_undo(bool typing);
    void restore(std::vector<State>& from, std::vector<State>& to);
    std::size_t line_begin(std::size_t offset) const;
    std::size_t line_finish(std::size_t offset) const;

    std::string text_;
    std::size_t cursor_ = 0, anchor_ = 0;
    std::vector<State> undo_, redo_;
    bool typing_ = false;  // more typing is the same step of undo
};

}  // namespace fettle::console
