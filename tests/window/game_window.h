#pragma once
// A game in a window of a virtual display, played with real key and mouse events.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "picture.h"
#include "process.h"
#include "temporary_folder.h"

namespace fettle::test {

/// What is missing on this machine to run a test in a window; "" when nothing is.
std::string missing_tools();

class GameWindow {
  public:
    /// Starts a virtual display and in it `fettle run GAME`. Throws std::runtime_error when either
    /// does not come up.
    explicit GameWindow(const std::filesystem::path& game);
    ~GameWindow();

    /// Names of xdotool: "grave", "Return", "ctrl+a".
    void key(const std::string& name);
    void type(const std::string& text);
    void click(int x, int y);
    void move(int x, int y);

    Picture picture() const;
    /// What the program has printed so far.
    std::string printed() const;
    /// Waits until it is true; false when it does not become so within some seconds.
    bool eventually(const std::function<bool()>& condition);
    bool prints(const std::string& text);
    /// Waits until nothing changes in the picture for a while, but not for ever.
    Picture settled();
    bool running() { return program_.running(); }
    /// Sends SIGTERM; the exit status, -1 when it does not end in order.
    int asked_to_end() { return program_.asked_to_end(); }

  private:
    void start_display();
    void xdotool(const std::vector<std::string>& arguments) const;

    TemporaryFolder temporary_;
    const std::filesystem::path& folder_ = temporary_.path;
    std::map<std::string, std::string> environment_;
    Process display_, program_;
};

}  // namespace fettle::test
