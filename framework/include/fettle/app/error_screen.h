#pragma once
// The error screen, for a script that has an error or does not return. It shows the place, the
// reason and the values to the author of the script.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/app/export.h>
#include <fettle/app/layer.h>
#include <fettle/script/runtime.h>

FETTLE_APP_BEGIN

namespace fettle::app {

class ErrorScreen : public Layer {
  public:
    struct Actions {
        std::function<void()> reload;             // R
        std::function<void()> go_on;              // escape: continue the game
        std::function<void(std::string)> copy{};  // C: the whole text, for a clipboard
        /// Pixels at the lower edge of the window that another layer covers.
        std::function<float()> covered_below{};
        /// The part of the window, in pixels, that other layers leave free. The text is drawn
        /// there.
        std::function<ClipRectangle(const ClipRectangle& whole)> free_area{};
        /// True while the user looks at the state before the error. Only a strip shows the error
        /// then, so that the game is visible.
        std::function<bool()> viewing_past{};
        /// Left and right: goes by this number of steps through the timeline.
        std::function<void(int steps)> travel{};
        /// Whether the console is open, which then gets all keys.
        std::function<bool()> console_is_open{};
        /// The key that opens and closes the console, as it is shown; "": there is no console.
        std::function<std::string()> console_key{};
    };
    explicit ErrorScreen(Actions actions) : actions_(std::move(actions)) {}

    /// Shows an error; an error that is already shown stays, since the first is the cause of the
    /// others.
    void show(const script::ScriptError& error);
    void hide() {
        error_.reset();
        over_.reset();
    }
    /// Shows an error in a strip over the game, which goes on and gets all input: one of files that
    /// changed while the game runs, or another that `heading` explains.
    void show_over(const script::ScriptError& error,
                   std::string heading = "The files have an error; the game goes on as it was") {
        over_ = error;
        heading_over_ = std::move(heading);
    }
    bool visible() const { return error_.has_value() || running_.has_value(); }

    /// Shows the place of a script that does not return, and asks whether to stop it; to be called
    /// repeatedly while the script runs.
    void show_running(const script::LongCall& call);
    /// True if the user has chosen to stop the script.
    bool stop_wanted() const { return stop_wanted_; }
    /// To be called when the script has returned.
    void script_returned();
    const std::optional<script::ScriptError>& error() const { return error_; }

    bool handle(const InputEvent& event) override;
    void draw(Surface& surface, double seconds) override;
    ClipRectangle free_area(const ClipRectangle& whole) const override;

  private:
    struct FETTLE_APP_PRIVATE Line;
    std::vector<Line> lines() const;
    std::vector<Line> lines_of_error() const;
    std::vector<Line> lines_of_running() const;
    bool handle_key(const std::string& key);
    ClipRectangle free_part(const Surface& surface) const;
    void draw_text(Surface& surface, float bottom);
    std::vector<std::string> keys() const;
    void draw_keys(Surface& surface, float bottom) const;
    /// These two return the upper edge of what they have drawn.
    float draw_strip(Surface& surface, float bottom) const;
    float draw_over(Surface& surface, float bottom) const;

    Actions actions_;
    std::optional<script::ScriptError> error_;
    std::optional<script::ScriptError> over_;
    std::string heading_over_;
    std::size_t further_errors_ = 0;
    std::optional<script::LongCall> running_;
    bool stop_wanted_ = false;
    bool waits_ = false;  // the user has chosen to wait, and gets no more messages
    int scroll_ = 0;      // lines
    // What was drawn at the lower edge, in pixels; infinite: nothing.
    float strip_top_ = std::numeric_limits<float>::infinity();
};

/// The error as it is written to stderr: message, place, source line, traceback, local variables.
std::string error_text(const script::ScriptError& error);

}  // namespace fettle::app

FETTLE_APP_END
