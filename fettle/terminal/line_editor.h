#pragma once
// Reads lines from a terminal, with editing, history and completion (libedit).

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fettle::program {

class LineEditor {
  public:
    struct Candidate {
        std::string text;              // replaces the line from `replace_from` to the cursor
        std::string label;             // as listed
        std::string detail;            // listed behind it
        std::size_t replace_from = 0;  // byte of the line
    };
    using Complete =
        std::function<std::vector<Candidate>(std::string_view line, std::size_t cursor)>;

    /// stdin must be a terminal. Lines of earlier runs are read from the file `history`, and it is
    /// written at the end; empty: they are not kept.
    LineEditor(std::filesystem::path history, Complete complete);
    ~LineEditor();
    LineEditor(const LineEditor&) = delete;

    enum class Next { read_on, drop_line, end };
    struct Line {
        std::string text;      // without its end
        bool dropped = false;  // `idle` returned `drop_line`; then the text is empty
    };

    /// Reads a line. None when the input ends, or when `idle` returns `end`. `idle` is called sixty
    /// times a second meanwhile. The text that it prints appears above the line.
    std::optional<Line> read(const std::string& prompt, const std::function<Next()>& idle);
    /// Erases the line that is being typed; `read` shows it again. `idle` must call it before it
    /// prints.
    void erase_typed_line();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fettle::program
