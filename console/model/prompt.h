#pragma once
// The command line without its looks: what every key does to the text, the history, the candidates
// and the log. Driven by key names and characters, so that it works (and is tested) without a
// window.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/app/layer.h>
#include <fettle/console/interpreter.h>

#include <model/completion_menu.h>
#include <model/history.h>
#include <model/log.h>
#include <model/text_edit.h>

namespace fettle::console {

struct Key {
    std::string_view name;  // as in app::InputEvent
    bool control = false, shift = false, alt = false;
};

class Prompt {
  public:
    Prompt(Interpreter interpreter, Log& log, History& history, app::Clipboard* clipboard);

    /// False when the key means nothing here (the caller may scroll, close ...).
    bool key(const Key& key);
    void type(char32_t character);
    void paste(std::string_view text);
    /// Runs what is typed; a chunk that is not complete gets another line instead, unless forced.
    void submit(bool force);

    TextEdit& edit() { return edit_; }
    const TextEdit& edit() const { return edit_; }
    const CompletionMenu& menu() const { return menu_; }
    void accept_candidate(std::size_t index);
    void close_menu() { menu_.close(); }
    /// Of reverse search: what is looked for; nullopt outside of it.
    const std::optional<std::string>& search() const { return search_; }
    bool search_failed() const { return search_failed_; }
    /// The rest of the latest command that begins with what is typed, shown dim behind the cursor
    /// and taken by Right or End.
    std::string_view suggestion() const;

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

    // Walking the history: what was typed, and the entry shown (none: what was typed).
    std::optional<std::size_t> walk_at_;
    std::string walk_prefix_;

    std::optional<std::string> search_;
    std::string before_search_;
    std::size_t search_at_ = 0;
    bool search_failed_ = false;
};

}  // namespace fettle::console
