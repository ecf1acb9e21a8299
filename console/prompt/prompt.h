#pragma once
// The command line without its appearance: the effect of every key on the text, the history, the
// candidates and the log. Its input is key names and characters, so it works (and is tested)
// without a window.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/app/layer.h>
#include <fettle/console/interpreter.h>

#include <prompt/completion_menu.h>
#include <prompt/history.h>
#include <prompt/signature_help.h>
#include <prompt/text_edit.h>
#include <text/log.h>

namespace fettle::console {

struct Key {
    std::string_view name;  // as in app::InputEvent
    bool control = false, shift = false, alt = false;
};

class Prompt {
  public:
    Prompt(Interpreter interpreter, Log& log, History& history, app::Clipboard* clipboard);

    /// False if the key has no effect here; the caller may use it.
    bool key(const Key& key);
    void type(char32_t character);
    void paste(std::string_view text);
    /// Runs the typed command. An incomplete chunk gets another line instead, unless forced.
    void submit(bool force);
    /// Runs a command, logs it with its output, and stores the evaluation in `result`. An
    /// incomplete command does not run and returns false, unless forced.
    bool run(const std::string& command, bool force = true, script::Evaluation* result = nullptr);
    /// Replaces the word at the beginning of later commands by `command`; an empty `command` ends
    /// this.
    void alias(const std::string& word, const std::string& command);
    const std::map<std::string, std::string>& aliases() const { return aliases_; }
    void take_aliases(std::map<std::string, std::string> aliases) { aliases_ = std::move(aliases); }
    /// Evaluates the command, with an alias at its beginning replaced. An alias alone whose command
    /// needs more after it is an error and not incomplete: the next line is another command.
    script::Evaluation evaluate(const std::string& command) const;
    /// The log is emptied when the running command has ended.
    void clear_log_afterwards() { clears_ = true; }
    /// Empties the log if the command that has ended wanted that.
    void clear_log_if_wanted();

    TextEdit& edit() { return edit_; }
    const TextEdit& edit() const { return edit_; }
    const CompletionMenu& menu() const { return menu_; }
    void accept_candidate(std::size_t index);
    void close_menu() { menu_.close(); }
    /// The text of the reverse search; nullopt outside a search.
    const std::optional<std::string>& search() const { return search_; }
    bool search_failed() const { return search_failed_; }
    /// The rest of the latest command that begins with the typed text. It is shown dim after the
    /// cursor, and Right or End accepts it.
    std::string_view suggestion() const;
    /// The signature of the call around the cursor; none outside of calls.
    std::optional<SignatureHelp::Shown> signature() {
        return signature_help_.at(edit_.text(), edit_.cursor());
    }

  private:
    bool menu_key(const Key& key);
    bool search_key(const Key& key);
    bool control_key(const Key& key);
    bool motion_key(const Key& key);
    bool erase_key(const Key& key);
    void complete();
    void show_candidates();
    void apply_candidate();
    void text_changed();
    void walk(bool older);
    void find_older(std::size_t from);
    void new_line();
    bool copy();

    Interpreter interpreter_;
    Log& log_;
    History& history_;
    app::Clipboard* clipboard_;
    TextEdit edit_;
    CompletionMenu menu_;
    SignatureHelp signature_help_;

    // Stepping through the history: the typed text, and the index of the shown entry (nullopt: the
    // typed text is shown).
    std::optional<std::size_t> walk_at_;
    std::string walk_prefix_;

    std::optional<std::string> search_;
    std::string before_search_;
    std::size_t search_at_ = 0;
    bool search_failed_ = false;

    /// The end of the word at the beginning of the command, if it is an alias; 0 otherwise.
    std::size_t alias_end(const std::string& command) const;

    std::map<std::string, std::string> aliases_;
    bool clears_ = false;
};

}  // namespace fettle::console
