#pragma once
// The view of the log: wrapped to the width, colored, scrolled, selected and copied; paths in it
// are links. Only visible rows are processed, however long the log is.

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <text/highlight.h>
#include <text/log.h>
#include <text/log_rows.h>

namespace fettle::console {

class LogView {
  public:
    explicit LogView(const Log& log) : log_(log), rows_(log) {}

    /// Whether a path in the text leads to something; called only for the one under the mouse.
    std::function<bool(std::string_view path)> is_link;
    /// Called when a link is clicked. `insert`: control or shift is held.
    std::function<void(std::string_view path, bool insert)> follow;
    /// Called when a path is clicked with the right button.
    std::function<void(std::string_view path)> menu;
    /// Called when a file that a line names is clicked.
    std::function<void(const std::string& file)> take_file;
    /// Called when a fold is clicked; `index` of the lines of the log.
    std::function<void(std::size_t index)> unfold;

    /// Fills the window down to `height`. `cell`: width of a character in pixels.
    void draw(float height, float cell);
    /// Shows only lines that contain the text; "" shows all.
    void filter(std::string_view text) { rows_.filter(text); }
    void scroll_pages(float pages) { pages_ += pages; }
    void scroll_to_end() { stick_ = true; }
    /// Makes the line with this number the topmost one, as far as the lines below it allow.
    void scroll_to(std::uint64_t line) { top_line_ = line; }

    bool selecting() const { return selection_ && selection_->from != selection_->to; }
    void clear_selection() { selection_.reset(); }
    std::string selected() const;

    /// All rows as text, from the first column after the signs.
    std::vector<std::string> shown_rows() const { return rows_.texts(); }

    // Sizes of the last drawing, in pixels.
    float cell() const { return cell_; }
    float line_height() const { return line_height_; }
    float scrolled() const { return scrolled_; }
    /// The number of the topmost line that is seen.
    std::uint64_t top_line() const { return top_; }
    /// Left end of the position below the last line.
    ImVec2 text_end() const { return text_end_; }

    /// The path under the mouse; "" if there is none.
    std::string_view pointed_link() const;

  private:
    struct Point {
        std::uint64_t line = 0;
        std::size_t offset = 0;
        friend auto operator<=>(const Point&, const Point&) = default;  // NOLINT: no pointer here
    };
    struct Selection {
        Point from, to;  // in the order of selection; `from` may be after `to`
    };
    /// The link that was under the mouse last.
    struct Link {
        std::uint64_t line = 0;
        Span span{0, 0, Token::plain};
        bool hovered = false;  // it still is
    };
    void scroll(float line_height);
    void follow_output(float line_height);
    std::optional<float> place_after_reshaping(float line_height, float height);
    std::optional<float> top_of_high_error(float line_height) const;
    void mouse(ImVec2 origin, float line_height, float cell);
    /// Shows what is under the mouse: a link, a whole number, a file, a fold. Returns true if a
    /// click has copied a file's path or opened a fold.
    bool hover(Point point);
    void select_word(Point point);
    /// Calls `follow` for a path at that point.
    void follow_path(Point point);
    void draw_row(const LogRow& row, ImVec2 at, float line_height, float cell);
    void draw_selection(const LogRow& row, ImVec2 at, float line_height, float cell);
    Point point_at(std::ptrdiff_t row, float column) const;

    const Log& log_;
    LogRows rows_;
    std::optional<Selection> selection_;
    bool dragging_ = false;
    float pages_ = 0;
    bool stick_ = true;
    std::optional<std::uint64_t> top_line_;
    std::uint64_t followed_ = 0;        // lines with smaller numbers have been followed
    std::optional<float> held_;         // the scroll position at which an error is held in sight
    std::optional<float> reshaped_to_;  // the scroll position after a change of sizes
    std::uint64_t top_ = 0;             // the topmost line
    bool at_end_ = true;
    float cell_ = 0, line_height_ = 0, height_ = 0, scrolled_ = 0;
    ImVec2 text_end_{0, 0};
    Link link_{};
};

}  // namespace fettle::console
