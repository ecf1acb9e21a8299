// The functions through which the window uses the console of a session: whether it is open, the
// part of the window that it covers, and its state for the session after a restart.

#include <session/console_layer.h>
#include <session/session.h>

namespace fettle::program {

float Session::covered_below() const {
#ifdef FETTLE_WITH_CONSOLE
    return console_ ? console_->covered_below() : 0;
#else
    return 0;
#endif
}

app::ClipRectangle Session::free_area(const app::ClipRectangle& whole) const {
#ifdef FETTLE_WITH_CONSOLE
    if (console_) return console_->free_area(whole);
#endif
    return whole;
}

bool Session::console_is_open() const {
#ifdef FETTLE_WITH_CONSOLE
    return console_ && console_->is_open();
#else
    return false;
#endif
}

std::string Session::console_key() const {
#ifdef FETTLE_WITH_CONSOLE
    if (console_) return console_->shown_key();
#endif
    return {};
}

std::shared_ptr<const console::Continuation> Session::console_continuation() const {
#ifdef FETTLE_WITH_CONSOLE
    if (console_) return console_->continuation();
#endif
    return nullptr;
}

void Session::continue_console(
    [[maybe_unused]] const std::shared_ptr<const console::Continuation>& earlier) {
#ifdef FETTLE_WITH_CONSOLE
    if (console_ && earlier) console_->continue_from(*earlier);
#endif
}

}  // namespace fettle::program
