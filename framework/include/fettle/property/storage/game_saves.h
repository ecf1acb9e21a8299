#pragma once
// Saving and loading a running game: its tree's snapshot, in slots.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/storage/saves.h>
#include <fettle/property/tree.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// May outlive the tree: `save`, `load` and `list` throw Error(deleted) then.
class GameSaves {
  public:
    struct Options {
        /// False in a replay and in a test: saves are kept in memory, and there are no others;
        /// files are neither read nor written.
        bool writes = true;
        /// The game is shown, and `finish` gets a picture of it after the next barrier. Otherwise
        /// saves have no picture and are made at the barrier.
        bool pictures = false;
        /// Bytes of all files of saved games together; a save beyond it is not written. 0: no
        /// limit.
        std::uintmax_t space = 0;
        /// Receives the slot whose picture is another one now.
        std::function<void(const std::string&)> changed{};
        /// Receives the errors of a save that could not be written, or of a snapshot that this game
        /// cannot restore: both happen at a barrier, where no caller can catch them. Also receives,
        /// once each, the formulas that a file cannot hold, and what a loaded game could not
        /// restore.
        std::function<void(const std::string&)> warn{};
    };
    GameSaves(Tree& tree, Saves saves, Options options);
    /// Writes the saves that wait for a picture.
    ~GameSaves();
    GameSaves(const GameSaves&) = delete;
    GameSaves& operator=(const GameSaves&) = delete;

    /// Saves at the next barrier. If a slot is saved several times before it, only the last call
    /// counts. The save is read back as by `load` before it is written. Throws Error(bad_name) for
    /// a name that no slot can have, Error(rejected) after `max_requests` calls between two
    /// barriers, or `max_limited_requests` if the space is limited.
    void save(const std::string& slot);
    static constexpr std::size_t max_requests = 1000, max_limited_requests = 4;
    /// Restores the last save of that slot at the next barrier: from a `save` that still waits for
    /// that barrier or for its picture, otherwise from the file. The file is read at once and
    /// checked as far as possible before the barrier. Throws as `Saves::load` does, and
    /// Error(damaged, unknown_name, rejected) for a state that this game cannot restore at the time
    /// of the call; the game then continues unchanged.
    void load(const std::string& slot);
    /// Removes the file and a save that still waits. Throws as `Saves::remove` does.
    void remove(const std::string& slot);
    /// Removes a save that has no file. False if there is none.
    bool discard(const std::string& slot);
    /// Like `Saves::list`; in addition, a save that this game cannot restore has a problem.
    std::vector<SaveInfo> list() const;
    const Saves& slots() const { return saves_; }
    /// The picture of that slot; none if it has no picture or cannot be read.
    Thumbnail picture(const std::string& slot) const;

    /// True if a save waits for a picture.
    bool waits() const { return !waiting_.empty(); }
    void finish(const Thumbnail& picture);

    /// Whether they are of that tree, and it lives.
    bool are_of(const Tree& tree) const { return !life_.expired() && &tree_ == &tree; }

  private:
    struct Waiting {
        std::string slot;
        std::uint64_t step;
        std::shared_ptr<const std::vector<std::byte>> state;
    };
    struct Unwritten {
        std::uint64_t step = 0;
        std::int64_t time = 0;  // s since 1970
        std::vector<std::byte> state{};
    };
    void save_at_barrier(const std::string& slot, std::size_t request);
    std::vector<SaveInfo> list_unwritten() const;
    std::string problem_of(const std::vector<std::byte>& state) const;
    [[noreturn]] void refuse_unknown(const std::string& slot) const;
    Snapshot saved(const std::string& slot) const;
    void warn(const std::string& what) const;
    void warn_once(const std::string& what);
    Tree& tree() const;

    Tree& tree_;  // use `tree`, which checks that the tree lives
    std::weak_ptr<const Tree*> life_;
    Saves saves_;
    Options options_;
    std::size_t requests_ = 0;                      // since the last barrier that executed one
    std::map<std::string, std::size_t> requested_;  // the last request of each slot
    std::map<std::size_t, std::string>
        loaded_;                    // requests that are loaded before the next save of the slot
    std::vector<Waiting> waiting_;  // saves without their picture
    std::map<std::string, Unwritten> unwritten_;  // by slot, if nothing is written
    std::set<std::string> reported_;              // reported formulas
    /// A request may reach its barrier after this object is destroyed.
    std::shared_ptr<GameSaves*> alive_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
