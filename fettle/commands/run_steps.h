#pragma once
// Functions for all kinds of runs: with a window, without one, and of a recording.

#include <memory>
#include <string>

#include <fettle/app/loudspeaker.h>
#include <fettle/app/screen.h>
#include <fettle/script/runtime.h>

#include <ending/exit_status.h>
#include <game/run_options.h>
#include <session/session.h>

namespace fettle::program {

/// Prints the message to stderr, and returns the status.
int complain(ExitStatus status, const std::string& message);

/// Notifies the game that the run ends, as when its window is closed.
void close(Session& session);

/// Writes the requested results of the run: the hash to stdout, and the picture of the last frame.
/// Returns the exit status.
int finish(Session& session, const RunOptions& options, app::Screen* screen);

/// Picture of a run without a window; null if none is wanted.
std::unique_ptr<app::Screen> picture_of(Session& session, const RunOptions& options);

/// Applies the time limit of `--budget`, or that of a sandbox, to each call into the scripts.
/// Returns false if there is none.
bool limit_calls(script::Runtime& runtime, const RunOptions& options);

/// The longest time of a turn of the loop in a sandbox, s; 0 for a trusted game.
double longest_turn(const RunOptions& options);

/// Plays the voices of the game. Reports once why they cannot be heard.
void play_sounds(app::Loudspeaker& loudspeaker, Session& session);

}  // namespace fettle::program
