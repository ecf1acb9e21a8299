// Terminals attach to the game's console while `console.listen` is set.

#include <fettle/property/exception_text.h>

#include <attach/protocol.h>
#include <session/console_layer.h>
#include <session/session.h>

namespace fettle::program {

/// A replay and a test must give the same result each time, so no terminal may type into them. A
/// game that is not trusted must not open a socket.
std::string Session::reason_not_to_listen() const {
    if (options_.sandbox) return "nothing may attach to a game in a sandbox";
    if (replayed_ != nullptr) return "nothing may attach to a replay";
    if (isolated()) return "nothing may attach to a test, or to a game without a path";
    return {};
}

#ifdef FETTLE_WITH_CONSOLE

/// Starts or stops listening as `console.listen` says, and answers the requests of terminals.
/// Called between two frames, so that a recording contains commands of terminals like typed ones.
void Session::listen() {
    if (!console_) return;
    if (!console_->listens()) return listener_.reset();
    if (!listener_) begin_to_listen();
    if (listener_) listener_->frame();
}

Listener::Callbacks Session::answers_of_terminals() {
    return {.evaluate = [this](std::string_view command,
                               std::string_view who) { return evaluate(command, who); },
            .complete =
                [this](std::string_view input, std::size_t cursor) {
                    return runtime_->complete(input, cursor, most_candidates);
                },
            .note = [this](const std::string& what) { note(what); },
            .answers_later =
                [this](std::string_view who) { return console_ && console_->answers_later(who); },
            .waited = [this](std::string_view who) { return waited(who); },
            .stop_waiting = [this](std::string_view who) { stop_waiting(who); }};
}

void Session::begin_to_listen() {
    std::string problem = reason_not_to_listen();
    if (problem.empty()) {
        try {
            listener_ = std::make_unique<Listener>(options_.game, answers_of_terminals());
            return note("fettle repl --attach " + std::to_string(listener_->place().process) +
                        " attaches a terminal");
        } catch (const std::exception& error) {
            problem = property::exception_text(error);
        }
    }
    console_->listen(false);
    note("console.listen: " + problem);
}

std::unique_ptr<Listener> Session::release_listener() {
    return std::move(listener_);
}

void Session::continue_listening(std::unique_ptr<Listener> earlier) {
    if (!earlier || !console_) return;
    listener_ = std::move(earlier);
    listener_->answer_with(answers_of_terminals());
    listener_->print("the game begins again");
    console_->listen(true);
}

#else

void Session::listen() {}

std::unique_ptr<Listener> Session::release_listener() {
    return nullptr;
}

void Session::continue_listening(std::unique_ptr<Listener>) {}

#endif

}  // namespace fettle::program
