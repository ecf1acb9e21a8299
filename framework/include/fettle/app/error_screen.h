#pragma once
// The error screen: a script went wrong, and its author sees where, why and with which values.

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
    bool visible() const { return error_.has_value(); }
    const std::optional<script::ScriptError>& error() const { return error_; }

    bool handle(const InputEvent& event) override;
    void draw(Surface& surface, double seconds) override;

  private:
    struct FETTLE_APP_PRIVATE Line;
    std::vector<Line> lines() const;

    Actions actions_;
    std::optional<script::ScriptError> error_;
    std::size_t further_errors_ = 0;
    int scroll_ = 0;  // lines
};

/// As it is written to stderr: message, where, source line, traceback, local variables.
std::string error_text(const script::ScriptError& error);

}  // namespace fettle::app

FETTLE_APP_END
