#pragma once
// Instances that have other names or parents now than the game's files and scripts give them. The
// path that those give is the *home path* of an instance. Something new may have the path of what
// has moved away, which is at home there; the name in the home path of the new one is marked, as no
// name of an instance can be.

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <scenes/instance_paths.h>

namespace fettle::property {

/// Moves of instances, each with its whole home path and its whole path now: where both a parent
/// and its child have moved, the child's paths begin with those of the parent.
class InstanceMoves {
  public:
    void add(const std::string& home, const std::string& now);
    /// Where the game makes what is at `now`; the same path where nothing was moved, marked where
    /// that is the home of something else.
    std::string home(const std::string& now) const;
    /// The path now of something whose home is below `home`; "": of nothing.
    std::string moved_out_of(const std::string& home) const;
    /// Where the instance of that home path is now; "": it was not moved.
    std::string moved_from(const std::string& home) const;
    /// Where what the game makes at `home` is now.
    std::string now(const std::string& home) const;

  private:
    std::unordered_map<std::string, std::string> homes_;  // by the path now
    std::unordered_map<std::string, std::string> nows_;   // by the home path
};

/// Whether the path is the marked one of something new, or of something below that.
bool is_marked(const std::string& home);
std::string without_marks(const std::string& home);
/// Whether a text in JSON may hold a marked path.
bool may_hold_marks(std::string_view json);

/// One move among several: of the instance number `which`.
struct MoveStep {
    std::size_t which;
    std::string from, to;  // paths
};

/// The same moves, each by itself: what is below an instance before the instance, and no instance
/// onto the path of another one that has still to move. Where instances change places, one of them
/// gets a free path in between. `from` of each is its path before all of them.
std::vector<MoveStep> in_order(const std::vector<MoveStep>& moves);
/// Where everything is when all of them are made. `to` of each is its path before the others.
/// Throws Error if together they move something below itself.
InstanceMoves whole_moves(const std::vector<MoveStep>& moves);

}  // namespace fettle::property
