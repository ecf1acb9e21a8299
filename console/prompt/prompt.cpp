#include <prompt/prompt.h>

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include <fettle/property/exception_text.h>

#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr std::ptrdiff_t menu_page = 8;

struct MotionKey {
    std::string_view name;
    Motion plain, control;
};
constexpr std::array<MotionKey, 6> motions = {{
    {"left", Motion::left, Motion::word_left},
    {"right", Motion::right, Motion::word_right},
    {"home", Motion::line_start, Motion::text_start},
    {"end", Motion::line_end, Motion::text_end},
    {"up", Motion::line_up, Motion::text_start},
    {"down", Motion::line_down, Motion::text_end},
}};

/// While the user types one of these, candidates are shown; any other character ends a name.
bool continues_name(char32_t c) {
    return c >= 0x80 || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || c == ':';
}

/// Keys that move the cursor out of the typed name, or end the line. Keys with a character do not:
/// their text follows as a separate event.
bool moves_or_ends(const Key& key) {
    bool motion = std::any_of(motions.begin(), motions.end(),
                              [&](const MotionKey& m) { return m.name == key.name; });
    return motion || key.name == "enter" || key.name == "tab" || key.name == "delete" ||
           (key.control && key.name.size() == 1);
}

}  // namespace

Prompt::Prompt(Interpreter interpreter, Log& log, History& history, app::Clipboard* clipboard)
    : interpreter_(std::move(interpreter)),
      log_(log),
      history_(history),
      clipboard_(clipboard),
      signature_help_(interpreter_.complete) {}

bool Prompt::key(const Key& key) {
    if (search_ && search_key(key)) return true;
    if (menu_.open() && menu_key(key)) return true;
    if (key.name == "enter") {
        if (key.shift)
            new_line();
        else
            submit(key.control);
        return true;
    }
    if (key.name == "tab") {
        complete();
        return true;
    }
    if (key.name == "escape") {
        if (edit_.empty()) return false;
        if (edit_.selecting())
            edit_.place(edit_.cursor(), false);
        else
            edit_.assign("");
        text_changed();
        return true;
    }
    if (key.control && !key.alt && control_key(key)) return true;
    return motion_key(key) || erase_key(key);
}

void Prompt::type(char32_t c) {
    if (c < 0x20 || c == 0x7f) return;
    std::string character;
    append_code_point(character, c);
    if (search_) {
        *search_ += character;
        find_older(history_.entries().size());
        return;
    }
    edit_.insert(character);
    bool follow = menu_.open() && continues_name(c);
    text_changed();
    if (!follow) {
        menu_.close();
        return;
    }
    show_candidates();
}

void Prompt::paste(std::string_view text) {
    // Window systems hand long texts over in pieces, which SFML does not read: it gives no text.
    if (text.empty())
        return log_.note(
            "nothing is pasted: the clipboard has no text, or one that is too long (some programs "
            "hand over 256 KB at most)");
    std::string clean = clean_text(text);
    while (!clean.empty() && clean.back() == '\n') clean.pop_back();
    // The beginning of a command would do something else than the whole.
    if (clean.size() > edit_.room())
        return log_.note("nothing is pasted: the text has " + std::to_string(clean.size()) +
                         " bytes, and a command has at most " +
                         std::to_string(TextEdit::max_bytes) + "; exec(\"FILE\") runs a file");
    edit_.insert(clean);
    menu_.close();
    text_changed();
}

void Prompt::text_changed() {
    walk_at_.reset();
}

// --- Candidates

void Prompt::complete() {
    if (!interpreter_.complete) return;
    edit_.place(edit_.cursor(), false);
    show_candidates();
    if (menu_.candidates().size() == 1 || menu_.select_continuation(edit_.text(), edit_.cursor()))
        return apply_candidate();
    if (!menu_.open()) return;
    // The common beginning of all candidates is inserted, unless that would remove typed text.
    std::string common = menu_.common_prefix();
    std::size_t from = menu_.selection().replace_from;
    std::string_view typed = std::string_view(edit_.text()).substr(from, edit_.cursor() - from);
    if (common.size() > typed.size() && common.starts_with(typed)) {
        edit_.replace(from, edit_.cursor(), common);
        text_changed();
        show_candidates();
    }
}

void Prompt::show_candidates() {
    menu_.show(interpreter_.complete(edit_.text(), edit_.cursor()), edit_.text(), edit_.cursor());
}

void Prompt::apply_candidate() {
    const script::Completion& chosen = menu_.selection();
    edit_.replace(chosen.replace_from, edit_.cursor(), chosen.text);
    menu_.close();
    text_changed();
}

void Prompt::accept_candidate(std::size_t index) {
    if (!menu_.open() || index >= menu_.candidates().size()) return;
    menu_.select(index);
    apply_candidate();
}

bool Prompt::menu_key(const Key& key) {
    if (key.name == "up") {
        menu_.step(-1);
    } else if (key.name == "down") {
        menu_.step(1);
    } else if (key.name == "page_up") {
        menu_.page(-menu_page);
    } else if (key.name == "page_down") {
        menu_.page(menu_page);
    } else if (key.name == "tab") {
        if (key.shift)
            menu_.step(-1);
        else
            apply_candidate();
    } else if (key.name == "enter" && !key.control && !key.shift) {
        const script::Completion& chosen = menu_.selection();
        std::string_view typed =
            std::string_view(edit_.text())
                .substr(chosen.replace_from, edit_.cursor() - chosen.replace_from);
        if (typed == chosen.text) {  // nothing is left to complete, so Enter runs the command
            menu_.close();
            return false;
        }
        apply_candidate();
    } else if (key.name == "escape") {
        menu_.close();
    } else if (key.name == "backspace" && !edit_.selecting()) {
        edit_.erase(key.control ? Motion::word_left : Motion::left);
        text_changed();
        show_candidates();
    } else {
        if (moves_or_ends(key)) menu_.close();
        return false;
    }
    return true;
}

// --- History

void Prompt::walk(bool older) {
    if (!walk_at_) walk_prefix_ = edit_.text();
    std::optional<std::size_t> next;
    if (older)
        next = history_.older(walk_prefix_, walk_at_.value_or(history_.entries().size()),
                              walk_prefix_);
    else if (walk_at_)
        next = history_.newer(walk_prefix_, *walk_at_);
    if (next) {
        edit_.assign(history_.entries()[*next]);
        walk_at_ = next;
    } else if (!older && walk_at_) {
        edit_.assign(walk_prefix_);
        walk_at_.reset();
    }
}

std::string_view Prompt::suggestion() const {
    const std::string& text = edit_.text();
    if (text.empty() || search_ || menu_.open() || edit_.selecting() ||
        edit_.cursor() != text.size() || walk_at_)
        return {};
    auto found = history_.older(text, history_.entries().size(), text);
    if (!found) return {};
    std::string_view rest = std::string_view(history_.entries()[*found]).substr(text.size());
    return rest.find('\n') == std::string_view::npos ? rest : std::string_view();
}

void Prompt::find_older(std::size_t from) {
    auto found = history_.containing(*search_, from);
    search_failed_ = !found;
    if (!found) return;
    search_at_ = *found;
    edit_.assign(history_.entries()[*found]);
}

bool Prompt::search_key(const Key& key) {
    if (key.name == "r" && key.control) {
        find_older(search_failed_ ? history_.entries().size() : search_at_);
    } else if (key.name == "backspace") {
        search_->resize(previous_code_point(*search_, search_->size()));
        find_older(history_.entries().size());
    } else if (key.name == "escape" || (key.control && (key.name == "g" || key.name == "c"))) {
        search_.reset();
        edit_.assign(before_search_);
    } else if (moves_or_ends(key)) {
        search_.reset();
        text_changed();
        return key.name == "tab";  // only Tab keeps the key for itself
    }
    return true;
}

// --- Editing

bool Prompt::copy() {
    if (!edit_.selecting()) return false;
    if (clipboard_ != nullptr) clipboard_->write(edit_.selected());
    return true;
}

bool Prompt::control_key(const Key& key) {
    if (key.name == "a") {
        edit_.select_all();
    } else if (key.name == "c") {
        if (!copy() && !edit_.empty()) edit_.assign("");
    } else if (key.name == "x") {
        if (copy()) edit_.insert("");
    } else if (key.name == "v") {
        if (clipboard_ != nullptr) paste(clipboard_->read());
        return true;
    } else if (key.name == "z") {
        // Where nothing typed is left to undo, the game's last edit is undone.
        const bool done = key.shift ? edit_.redo() : edit_.undo();
        if (!done && edit_.empty()) run(key.shift ? "redo" : "undo");
    } else if (key.name == "y") {
        if (!edit_.redo() && edit_.empty()) run("redo");
    } else if (key.name == "u") {
        edit_.erase(Motion::line_start);
    } else if (key.name == "k") {
        edit_.erase(Motion::line_end);
    } else if (key.name == "w") {
        edit_.erase(Motion::word_left);
    } else if (key.name == "l") {
        log_.clear();
        return true;
    } else if (key.name == "r") {
        before_search_ = edit_.text();
        search_ = std::string();
        search_failed_ = false;
        search_at_ = history_.entries().size();
        return true;
    } else {
        return false;
    }
    text_changed();
    return true;
}

bool Prompt::motion_key(const Key& key) {
    bool vertical = key.name == "up" || key.name == "down";
    if (vertical && !key.control && !key.shift && !key.alt) {
        std::size_t line = edit_.line_of(edit_.cursor());
        bool leaves = key.name == "up" ? line == 0 : line + 1 == edit_.line_count();
        if (leaves || walk_at_) {
            walk(key.name == "up");
            return true;
        }
    }
    auto found = std::find_if(motions.begin(), motions.end(),
                              [&](const MotionKey& m) { return m.name == key.name; });
    if (found == motions.end() || key.alt) return false;
    if ((key.name == "right" || key.name == "end") && !key.shift && !suggestion().empty()) {
        std::string rest(suggestion());
        edit_.insert(rest);
        text_changed();
        return true;
    }
    edit_.move(key.control ? found->control : found->plain, key.shift);
    return true;
}

bool Prompt::erase_key(const Key& key) {
    if (key.name == "backspace")
        edit_.erase(key.control ? Motion::word_left : Motion::left);
    else if (key.name == "delete")
        edit_.erase(key.control ? Motion::word_right : Motion::right);
    else
        return false;
    text_changed();
    return true;
}

// --- Running

/// For Enter inside an open block: the next line gets the indentation of the current one.
void Prompt::new_line() {
    std::string_view line = edit_.line(edit_.line_of(edit_.cursor()));
    std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    edit_.insert("\n" + std::string(indent, ' '));
    menu_.close();
    text_changed();
}

void Prompt::submit(bool force) {
    std::string command = edit_.text();
    search_.reset();
    menu_.close();
    if (command.find_first_not_of(" \n") == std::string::npos) {
        edit_.assign("");
        return;
    }
    if (!interpreter_.evaluate) return;
    if (run(command, force)) {
        history_.add(command);
        if (std::string problem = history_.consume_problem(); !problem.empty()) log_.note(problem);
        edit_ = TextEdit();
        text_changed();
        return;
    }
    if (!edit_.selecting()) edit_.place(edit_.text().size(), false);
    new_line();
}

void Prompt::alias(const std::string& word, const std::string& command) {
    if (command.empty())
        aliases_.erase(word);
    else
        aliases_[word] = command;
}

std::size_t Prompt::alias_end(const std::string& command) const {
    const std::size_t begin = std::min(command.find_first_not_of(" \n"), command.size());
    std::size_t end = begin;
    while (end < command.size() && continues_name(static_cast<unsigned char>(command[end])) &&
           command[end] != '.' && command[end] != ':')
        ++end;
    if (!aliases_.contains(command.substr(begin, end - begin))) return 0;
    // An assignment to a variable of that name is not replaced.
    const std::size_t next = std::min(command.find_first_not_of(' ', end), command.size());
    return next < command.size() && command[next] == '=' ? 0 : end;
}

script::Evaluation Prompt::evaluate(const std::string& command) const {
    const std::size_t end = alias_end(command);
    if (end == 0) return interpreter_.evaluate(command);
    const std::size_t begin = command.find_first_not_of(" \n");
    const std::string word = command.substr(begin, end - begin);
    const std::string& meant = aliases_.at(word);
    script::Evaluation result = interpreter_.evaluate(meant + command.substr(end));
    if (!result.incomplete || command.find_first_not_of(" \n", end) != std::string::npos)
        return result;
    result.incomplete = false;
    result.error.emplace().message =
        word + " stands for " + lua_string(meant) + ": it needs more after it, in the same line";
    return result;
}

bool Prompt::run(const std::string& command, bool force, script::Evaluation* result) {
    if (!interpreter_.evaluate) return true;
    script::Evaluation evaluation;
    const std::uint64_t before = log_.end();
    try {
        evaluation = evaluate(command);
    } catch (const std::exception& error) {
        evaluation.error.emplace();
        evaluation.error->message = property::exception_text(error);
    }
    if (evaluation.incomplete && !force) return false;
    if (evaluation.incomplete && !evaluation.error)
        evaluation.error.emplace().message =
            "the command is not complete: something opened is not closed";
    log_.command(command, before);
    log_.output(evaluation);
    if (evaluation.error) log_.error(*evaluation.error);
    if (result != nullptr) *result = std::move(evaluation);
    clear_log_if_wanted();
    return true;
}

void Prompt::clear_log_if_wanted() {
    if (clears_) log_.clear();
    clears_ = false;
}

}  // namespace fettle::console
