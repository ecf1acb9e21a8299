#pragma once
// Instances whose name or parent differs from what the game's files and scripts say. The path in
// those files and scripts is the *home path*. The path of a new instance may be the home path of an
// instance that was moved away. The home path of the new one then contains a marked name, which no
// instance can have.

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <values/instance_paths.h>

namespace fettle::property {

/// Moves of instances, each with its complete home path and its complete current path. If both a
/// parent and its child moved, the paths of the child begin with those of the parent.
class InstanceMoves {
  public:
    void add(const std::string& home, const std::string& now);
    /// The home path of the instance at `now`. Without a move it is the same path, marked if it is
    /// the home path of another instance.
    std::string home(const std::string& now) const;
    /// The current path of an instance whose home is below `home`; "" if there is none.
    std::string moved_out_of(const std::string& home) const;
    /// The current path of the instance with that home path; "" if it was not moved.
    std::string moved_from(const std::string& home) const;
    /// Whether the current path of a moved instance is `now`.
    bool moves_to(const std::string& now) const { return homes_.contains(now); }
    /// The current path of the instance with that home path.
    std::string now(const std::string& home) const;

  private:
    std::unordered_map<std::string, std::string> homes_;  // by current path
    std::unordered_map<std::string, std::string> nows_;   // by home path
};

/// Whether the path, or a path above it, is the marked home path of a new instance.
bool is_marked(const std::string& home);
std::string without_marks(const std::string& home);
/// Whether a text in JSON may hold a marked path.
bool may_have_marked_path(std::string_view json);

/// One of several moves; `which` is the number of the instance.
struct MoveStep {
    std::size_t which;
    std::string from, to;  // paths
};

/// The same moves in an order in which they can be made one by one: an instance below another one
/// moves first, and no instance moves to a path that is still occupied. If instances exchange their
/// paths, one of them gets a free path in between. `from` of each is its path before all moves.
std::vector<MoveStep> in_order(const std::vector<MoveStep>& moves);
/// The result of all moves. `to` of each is its path before the others are made. Throws Error if
/// together they move an instance below itself.
InstanceMoves combined_moves(const std::vector<MoveStep>& moves);

}  // namespace fettle::property
