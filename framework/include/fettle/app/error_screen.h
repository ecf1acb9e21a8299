#pragma once
// The error screen: a script went wrong, or does not come back, and its author sees where, why and
// with which values.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fettle/app/export.h>
#include <fettle/app/layer.h>
#include <fettle/script/runtime.h>

FETTLE_APP_BEGIN

namespace fettle::app {

class ErrorScreen : public Layer {
  public:
    struct Actions {
        std::function<void()> reload;  // R
        std::function<void()> go_on;   // escape: the game goes on as if nothing had happened
        std::function<void(std::string)> copy{};  // C: the whole text, for a clipboard
    };
    explicit ErrorScreen(Actions actions) : actions_(std::move(actions)) {}

    /// Shows an error; one that is shown already stays, since the first is the cause of the rest.
    void show(const script::ScriptError& error);
    void hide() { error_.reset(); }
    bool visible() const { return error_.has_value() || running_.has_value(); }

    /// Shows where a script is that does not come back, and asks what is to become of it; to be
    /// called again and again while it goes on.
    void show_running(const script::LongCall& call);
    /// Whether it is to be stopped.
    bool stop_wanted() const { return stop_wanted_; }
    /// It has come back.
    void came_back();
    const std::optional<script::ScriptError>& error() const { return error_; }

    bool handle(const InputEvent& event) override;
    void draw(Surface& surface, double seconds) override;

  private:
    struct FETTLE_APP_PRIVATE Line;
    std::vector<Line> lines() const;
    std::vector<Line> lines_of_error() const;
    std::vector<Line> lines_of_running() const;
    bool handle_key(const std::string& key);

    Actions actions_;
    std::optional<script::ScriptError> error_;
    std::size_t further_errors_ = 0;
    std::optional<script::LongCall> running_;
    bool stop_wanted_ = false;
    bool waits_ = false;  // the author knows, and does not want to be told more than that
    int scroll_ = 0;      // lines
};

/// As it is written to stderr: message, where, source line, traceback, local variables.
std::string error_text(const script::ScriptError& error);

}  // namespace fettle::app

FETTLE_APP_END
