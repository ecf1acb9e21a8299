#pragma once
// State of a console, and the receivers of an event in order: the toggle key, a widget of Dear
// ImGui, the prompt, the game.

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fettle/console/console.h>

#include <branches/comparison.h>
#include <in_game/context_menu.h>
#include <in_game/ghosts.h>
#include <in_game/onion_skins.h>
#include <inspector/inspector.h>
#include <look/imgui_backend.h>
#include <look/rect.h>
#include <observed/waits.h>
#include <panel/held_keys.h>
#include <panel/observing.h>
#include <prompt/history.h>
#include <prompt/prompt.h>
#include <settings/settings.h>
#include <text/log.h>
#include <views/compare_view.h>
#include <views/frame_view.h>
#include <views/log_view.h>
#include <views/overlay_bar.h>
#include <views/plot_view.h>
#include <views/prompt_view.h>
#include <views/time_bar.h>
#include <views/tweak_list.h>
#include <views/watch_list.h>

namespace fettle::console {

/// Stores copied text if there is no system clipboard.
class MemoryClipboard : public app::Clipboard {
  public:
    std::string read() override { return text_; }
    void write(std::string_view text) override { text_ = text; }

  private:
    std::string text_;
};

/// The views of the console, in the order of its panel.
struct Views {
    LogView log_view;
    PromptView prompt_view;
    TimeBar time_bar;
    TweakList tweak_list;
    WatchList watch_list{};
    PlotView plot_view{};
    FrameView frame_view{};
    CompareView compare_view{};
    OverlayBar overlay_bar;
};

/// A box that is drawn in the game, in pixels.
struct DrawnBox {
    float from_x = 0, from_y = 0, to_x = 0, to_y = 0;
};

/// Keys and buttons that the player holds down, and events that wait for the next frame.
struct Input {
    HeldKeys keys, buttons;
    bool shift_held = false, control_held = false;
    std::optional<DrawnBox> box;
    bool keys_to_selection = false;  // the last click was into the game
    bool swallow_text = false;       // the character of the toggle key follows and is dropped
    // The toggle key has typed no character yet: it may be a dead key, which takes the next letter
    // away or puts an accent on it.
    bool may_be_dead = false;
    char32_t letter = 0;  // of the key that was pressed next; 0: none, or it was typed
    // Since the last frame.
    bool fed_button = false, fed_key = false, fed_text = false, fed_move = false;
};

/// The surface, and where the windows are on it.
struct Screen {
    float width = 0, height = 0;  // of the surface; 0 before the first draw
    Rect panel_rect, inspector_rect, filter_rect;
    Rect height_edge, width_edge;        // of the panel and of the inspector, to be dragged
    Rect plot_edge;                      // the upper edge of the plot
    Rect paused_sign;                    // while the console is closed
    bool inspector_left_out = false;     // it is on, and not shown
    bool inspector_has_no_room = false;  // neither beside the panel nor below it
    ImVec2 ems;                          // the size of the surface in the size of the text
    bool popup_open = false;
    bool building = false;     // a frame is being built; no other may begin inside it
    std::string part_problem;  // the last one in the log
};

/// Things that the console has done in this run, and states of the last frame.
struct Status {
    bool was_open = false;
    bool greeted = false;
    bool drawn = false;               // since it was opened
    bool inspector_over_log = false;  // in a window that has no other room for it
    bool used =
        false;  // it was opened, a key has run a command, or the program has paused the game
    bool pausing = false;  // the console has paused the game's time
    bool time_was_paused = false;
    bool restored = false;                  // what was pinned and plotted in earlier runs
    std::string selected_path;              // of the selected instance when it was last seen
    std::vector<std::string> breaks{};      // conditions of the run before a restart
    std::vector<std::string> overlays{};    // the same for overlays that were shown
    std::size_t edits_without_undo = 0;     // of which the log has told
    bool goes_on = false;                   // a pause ends before the next frame
    std::optional<std::string> terminal{};  // whose command runs now; "" has no name
};

struct Continuation {
    std::deque<LogLine> lines;
    bool open = false;
    std::string selected_path{};
    std::map<std::string, std::string> keys{}, aliases{};  // with their commands
    std::vector<std::string> breaks{};                     // conditions
    std::vector<std::string> overlays{};                   // names in `view.show`
};

struct Console::State {
    State(property::Tree& tree, Interpreter interpreter, Options options);

    // --- Events (input.cpp)
    bool handle(const app::InputEvent& event);
    bool press_key(const app::InputEvent& event);
    bool release_key(const app::InputEvent& event);
    bool type_text(const app::InputEvent& event);
    /// Notes the letter of a key that follows the toggle key.
    void note_letter(const app::InputEvent& event);
    /// Types the noted letter if a dead key has taken it away.
    void type_letter();
    bool mouse(const app::InputEvent& event);
    void prompt_key(const app::InputEvent& event);
    void lose_focus();
    /// Passes an event to the widgets. Events that one frame could not distinguish, such as a press
    /// and a release, are separated by an extra frame.
    void feed(const app::InputEvent& event);
    bool widgets_have_keyboard();
    bool leaves_menu(char32_t character);
    bool over_windows(float x, float y) const;
    bool click_game(float x, float y, bool menu);
    /// Selects the instances in the box that was drawn with Shift.
    void end_box();
    /// Keys for the selection, after a click into the game: arrows move it, Delete deletes it.
    bool selection_key(const app::InputEvent& event);
    /// Keys for a check box or a list of the inspector that has the keyboard.
    bool focused_widget_key(const app::InputEvent& event);
    void wait_for_focus();
    /// Runs the command of a key, if it has one. Function keys work while the console is open, the
    /// others only while it is closed.
    bool run_key(const app::InputEvent& event);

    // --- Actions (console.cpp)
    bool is_open() { return settings.flag("open"); }
    /// Whether `view.show` has the overlay and shows it.
    bool shows(std::string_view overlay) const;
    void show_overlay(std::string_view overlay, bool on);
    void open(bool opened);
    void follow_settings();
    void pause_time(bool paused);
    /// Select instances, and return a line about it, which the log gets, too, if `logs`.
    std::string choose(property::Handle instance, bool logs = true);
    std::string choose_all(const std::vector<property::Handle>& instances, bool logs = true);
    /// If the selected instance was deleted, and there is one at its path again (the game has made
    /// it anew), that is selected.
    void find_selected_again();
    void connect();
    // --- For scripts and terminals (serving.cpp)
    void serve_scripts();
    std::string go_on();
    std::vector<std::string> bookmark_lines() const;
    script::Evaluation answer_terminal(std::string_view command, std::string_view who);
    void connect_log();
    void connect_inspector();
    void connect_context_menu();
    void connect_lists();
    void connect_time();
    // --- Kept for the player (kept_layout.cpp)
    void take_settings(const Layout& layout);
    void restore_observed();
    Layout layout() const;
    void keep_layout();
    std::vector<std::string> chosen_overlays() const;
    /// The value of an expression; none if it is no number. Throws what is wrong with it.
    std::optional<double> calculated(const std::string& expression);
    /// Runs a command of a button, a menu or a key as if it were typed.
    void run(const std::string& command);
    /// Notes it if an edit, of the inspector or of an attached terminal, was too large to be
    /// undone. The prompt tells it of its commands.
    void note_lost_undo();
    /// Shows the log in place of the list of tweaks and of the inspector.
    void show_log();
    // --- Files (exporting.cpp)
    void export_plots();
    std::string export_table();
    std::string export_picture();
    void draw_plot_alone(app::Surface& surface);

    /// Shows where a value was written: prints the lines of the script, or goes to the step.
    void go_to_write(const property::Cause& cause, const std::string& path);
    void look_at_step(std::uint64_t step);
    void follow_link(std::string_view path, bool insert);
    bool is_link(std::string_view path) const;

    // --- While it is closed (paused_sign.cpp)
    bool hides_pause() const;
    void draw_paused_sign(app::Surface& surface);
    bool click_paused_sign(const app::InputEvent& event);

    // --- Appearance (layout.cpp, title.cpp)
    void frame(double seconds);
    float text_size();
    property::Seen seen() const;
    property::Handle pointed();
    void draw_outlines();
    void draw_box();
    void draw_part(const std::function<void()>& part);
    float panel_height();
    float room_beside_panel() const;
    bool inspector_is_beside();
    float inspector_width();
    float free_above() const;
    float legend_room() const;
    float free_for_inspector() const;
    float least_plot_height() const;
    float lowest_plot_height() const;
    float comparison_height();
    app::ClipRectangle free_area(const app::ClipRectangle& whole) const;
    void draw_panel(float width, float height, float cell);
    void draw_log(float log_height, float cell);
    void draw_filter(float& right, float em);
    void draw_title(float cell);
    void draw_title_buttons(float& right);
    void draw_inspector_button(float& right);
    /// Moves `at` behind the path.
    void draw_selected_path(ImVec2& at, float right, float cell);
    bool title_button(const char* label, bool lit, float& right);
    void draw_height_handle();
    void draw_time_bar(float right);
    void draw_in_game();
    void draw_observed(float right);
    void draw_frames(float right);
    void draw_comparison(double seconds);
    void draw_inspector(float left, float width);
    // --- In small windows (narrow_inspector.cpp)
    void draw_inspector_below();
    void note_size_of_window();
    bool inspector_fits_in_panel();
    bool inspector_is_in_panel();
    float height_with_inspector();
    void draw_inspector_in_panel(float height);
    void draw_width_handle();
    void draw_plot_handle(float plot_height);

    property::Tree& tree;
    Interpreter interpreter;
    Options options;
    MemoryClipboard memory_clipboard;
    app::Clipboard* clipboard;
    Settings settings;
    Log log;
    History history;
    Prompt prompt;
    ImGuiBackend ui;
    Inspector inspector;
    TimeMarks time_marks{tree};
    ContextMenu context_menu;
    Observing observing;
    Comparison comparison{tree, log};
    Waits waits{tree};
    Ghosts ghosts{tree};
    OnionSkins onion_skins{tree};
    Views views;
    Input input;
    Screen screen;
    Status status;
};

}  // namespace fettle::console
