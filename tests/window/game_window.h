#pragma once
// A game in a window of a virtual display, controlled with real key and mouse events.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "picture.h"
#include "process.h"
#include "temporary_folder.h"

namespace fettle::test {

/// The programs that a test in a window needs and that this machine does not have; "" if it has
/// all.
std::string missing_tools();

class GameWindow {
  public:
    /// Starts a virtual display and `fettle run GAME` in it; without a game, `fettle`, which
    /// opens the gallery.
    /// `environment` is added to that of the program; `keyboard` is a layout of setxkbmap. Throws
    /// std::runtime_error if either does not start.
    explicit GameWindow(const std::filesystem::path& game,
                        const std::map<std::string, std::string>& environment = {},
                        const std::string& window_manager = "", const std::string& keyboard = "");
    ~GameWindow();

    /// The id of the window that is active and has the keyboard; "" if there is none.
    std::string active_window() const;

    /// Key names of xdotool: "grave", "Return", "ctrl+a".
    void key(const std::string& name);
    void hold(const std::string& name, bool down);
    void type(const std::string& text);
    void click(int x, int y);
    void move(int x, int y);
    /// Presses the left button of the mouse where it is, or lets it go.
    void hold_button(bool down);
    /// Gives the keyboard to the window of the game, which may be another one by now.
    void focus();

    Picture picture() const;
    /// The folder that has the copy of the game (`game`) and the files of the player (`data`).
    const std::filesystem::path& folder() const { return folder_; }
    /// The output of the program so far.
    std::string printed() const;
    /// Waits until the condition is true; false if it is not within some seconds.
    bool eventually(const std::function<bool()>& condition);
    bool prints(const std::string& text);
    /// Waits until the picture no longer changes, for a limited time.
    Picture settled();
    bool running() { return program_.running(); }
    /// Sends SIGTERM; returns the exit status, or -1 if the program does not end in order.
    int asked_to_end() { return program_.asked_to_end(); }

  private:
    void start_display();
    void start_manager(const std::string& name);
    void set_layout(const std::string& keyboard);
    void xdotool(const std::vector<std::string>& arguments) const;

    TemporaryFolder temporary_;
    const std::filesystem::path& folder_ = temporary_.path;
    std::map<std::string, std::string> environment_;
    Process display_, manager_, program_;
};

}  // namespace fettle::test
