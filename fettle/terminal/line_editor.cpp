#include <terminal/line_editor.h>

#include <histedit.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cwchar>
#include <optional>
#include <system_error>
#include <utility>

#include <fettle/property/utf8.h>

namespace fettle::program {
namespace {

constexpr int kept_lines = 1000;
constexpr int frame_milliseconds = 16;
constexpr std::size_t most_listed = 24;

/// From now on a read of the terminal returns 0 if there is no character. Ctrl+C empties the queue
/// of the terminal, so a character that `poll` has reported may be gone. A read that waits for one
/// would then delay the effect of Ctrl+C until the next key.
void do_not_wait_for_characters() {
    termios settings{};
    if (::tcgetattr(STDIN_FILENO, &settings) != 0 || settings.c_cc[VMIN] == 0) return;
    settings.c_cc[VMIN] = 0;
    settings.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &settings);
}

/// What all candidates begin with that begin as typed; those that only resemble it do not count. ""
/// if there is none.
std::string common_beginning(const std::vector<LineEditor::Candidate>& candidates,
                             const std::string& typed) {
    std::optional<std::string> common;
    for (const LineEditor::Candidate& candidate : candidates) {
        if (!candidate.text.starts_with(typed)) continue;
        if (!common) common = candidate.text;
        const auto end = std::ranges::mismatch(*common, candidate.text).in1;
        common->erase(end, common->end());
    }
    return common.value_or("");
}

}  // namespace

struct LineEditor::State {
    std::filesystem::path file;
    Complete complete;
    EditLine* editor = nullptr;
    History* history = nullptr;
    HistEvent event{};
    std::string prompt;
    std::function<Next()> idle;
    bool reading = false, printed = false, dropped = false;

    static State& of(EditLine* editor) {
        void* data = nullptr;
        el_get(editor, EL_CLIENTDATA, &data);
        return *static_cast<State*>(data);
    }

    /// Returns the next character of the terminal; frames of the game are made until there is one.
    static int read_character(EditLine* editor, wchar_t* character) {
        State& state = of(editor);
        std::mbstate_t part{};
        do_not_wait_for_characters();
        for (;;) {
            pollfd input = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
            const int ready = ::poll(&input, 1, frame_milliseconds);
            const Next next = state.idle();
            state.dropped = next == Next::drop_line;
            if (next != Next::read_on) return 0;
            if (std::exchange(state.printed, false)) el_set(editor, EL_REFRESH);
            if (ready <= 0) continue;
            char byte = 0;
            const ssize_t count = ::read(STDIN_FILENO, &byte, 1);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0 || (count == 0 && (input.revents & POLLHUP) != 0)) return 0;
            if (count == 0) continue;
            const std::size_t used = std::mbrtowc(character, &byte, 1, &part);
            if (used == static_cast<std::size_t>(-1))
                part = {};  // no UTF-8: the byte is dropped
            else if (used != static_cast<std::size_t>(-2))
                return 1;
        }
    }

    static unsigned char complete_word(EditLine* editor, int) {
        State& state = of(editor);
        const LineInfo* const info = el_line(editor);
        const auto length = static_cast<std::size_t>(info->lastchar - info->buffer);
        const auto cursor = static_cast<std::size_t>(info->cursor - info->buffer);
        const std::string line(info->buffer, length);
        const std::vector<Candidate> found = state.complete(line, cursor);
        if (found.empty()) return CC_ERROR;
        const std::size_t from = std::min(found.front().replace_from, cursor);
        const std::string typed = line.substr(from, cursor - from);
        const bool alike = std::ranges::all_of(found, [&](const Candidate& c) {
            return c.replace_from == found.front().replace_from;
        });
        const std::string text = found.size() == 1 ? found.front().text
                                 : alike           ? common_beginning(found, typed)
                                                   : typed;
        if (found.size() == 1 || text.size() > typed.size()) {
            el_deletestr(editor, static_cast<int>(property::code_point_count(typed)));
            if (!text.empty() && el_insertstr(editor, text.c_str()) != 0) return CC_ERROR;
            return CC_REFRESH;
        }
        state.list(found);
        return CC_REDISPLAY;
    }

    void list(const std::vector<Candidate>& found) const {
        std::printf("\n");
        std::size_t width = 0;
        const std::size_t count = std::min(found.size(), most_listed);
        for (std::size_t i = 0; i < count; ++i)
            width = std::max(width, property::code_point_count(found[i].label));
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t gap = width - property::code_point_count(found[i].label) + 2;
            std::printf("  %s%*s%s\n", found[i].label.c_str(), static_cast<int>(gap), "",
                        found[i].detail.c_str());
        }
        if (count < found.size()) std::printf("  and %zu more\n", found.size() - count);
        std::fflush(stdout);
    }
};

LineEditor::LineEditor(std::filesystem::path history, Complete complete)
    : state_(std::make_unique<State>()) {
    std::setlocale(LC_CTYPE, "");  // characters of more than one byte
    State& state = *state_;
    state.file = std::move(history);
    state.complete = std::move(complete);
    state.editor = el_init("fettle", stdin, stdout, stderr);
    state.history = history_init();
    if (state.editor == nullptr || state.history == nullptr)
        throw std::system_error(ENOTTY, std::generic_category(), "the terminal");
    ::history(state.history, &state.event, H_SETSIZE, kept_lines);
    ::history(state.history, &state.event, H_SETUNIQUE, 1);
    if (!state.file.empty()) ::history(state.history, &state.event, H_LOAD, state.file.c_str());
    el_set(state.editor, EL_CLIENTDATA, &state);
    el_set(
        state.editor, EL_PROMPT,
        +[](EditLine* editor) -> char* { return State::of(editor).prompt.data(); });
    el_set(state.editor, EL_EDITOR, "emacs");
    el_set(state.editor, EL_HIST, ::history, state.history);
    el_set(state.editor, EL_GETCFN, &State::read_character);
    el_set(state.editor, EL_ADDFN, "complete", "Completes the word", &State::complete_word);
    el_set(state.editor, EL_BIND, "^I", "complete", nullptr);
    // The terminal passes each key on unchanged, also between two lines. Otherwise it would handle
    // some keys itself that are typed while a command runs: Ctrl+D would be lost or become a
    // letter.
    el_set(state.editor, EL_SETTY, "-x", "-icanon", "-echo", nullptr);
    el_set(state.editor, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    el_source(state.editor, nullptr);
}

LineEditor::~LineEditor() {
    State& state = *state_;
    if (!state.file.empty()) {
        std::error_code error;
        std::filesystem::create_directories(state.file.parent_path(), error);
        if (!error) ::history(state.history, &state.event, H_SAVE, state.file.c_str());
    }
    history_end(state.history);
    el_end(state.editor);
}

std::optional<LineEditor::Line> LineEditor::read(const std::string& prompt,
                                                 const std::function<Next()>& idle) {
    State& state = *state_;
    state.prompt = prompt;
    state.idle = idle;
    state.reading = true;
    state.dropped = false;
    int count = 0;
    const char* const text = el_gets(state.editor, &count);
    state.reading = false;
    if (state.dropped) {
        std::printf("^C\n");
        std::fflush(stdout);
        return Line{.text = {}, .dropped = true};
    }
    if (text == nullptr || count <= 0) return std::nullopt;
    std::string line(text, static_cast<std::size_t>(count));
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    if (!line.empty()) ::history(state.history, &state.event, H_ENTER, line.c_str());
    return Line{.text = std::move(line)};
}

void LineEditor::erase_typed_line() {
    State& state = *state_;
    if (!state.reading || std::exchange(state.printed, true)) return;
    std::printf("\r\x1b[J");
    std::fflush(stdout);
}

}  // namespace fettle::program
