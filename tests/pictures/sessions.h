#pragma once
// Reads a session from a file and plays it. Each line is a command; empty lines and lines that
// begin with # are comments.
//
//   game PATH             the game, relative to the project; the first command
//   size WIDTH HEIGHT     of the picture, in pixels
//   prepare LUA           runs before the second step
//   wait SECONDS          the game goes on
//   move X Y SECONDS      the pointer moves there, in pixels from the upper left corner
//   press, release        the left button
//   click X Y SECONDS     moves there, presses and releases
//   key NAME              presses and releases a key
//   type TEXT             types ASCII text
//   expect LUA            the session fails unless the expression is true

#include <filesystem>

namespace fettle::pictures {

/// Writes the frames into the folder `frames`, or the last one into the picture of this name, and
/// returns how many were drawn. Throws std::runtime_error, which names the line, when a command is
/// wrong or an expectation does not hold.
int play_session(const std::filesystem::path& session, const std::filesystem::path& project,
                 const std::filesystem::path& frames);

}  // namespace fettle::pictures
