#pragma once
// Saving and loading a running game: its tree's snapshot, in slots.

#include <cstddef>
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
        /// False, as in a replay: what is saved is kept in memory, and found there by `load`.
        bool writes = true;
        /// Somebody shows the game and gives a picture of it to `finish`, after the next barrier.
        /// Without, saves have none and are made at the barrier.
        bool pictures = false;
        /// Told of a save that could not be written, or a snapshot that this game cannot restore:
        /// both happen at a barrier, where nobody can catch. Also told, once each, of formulas that
        /// a file cannot hold, and of what a loaded game could not take as it was.
        std::function<void(const std::string&)> warn{};
    };
    GameSaves(Tree& tree, Saves saves, Options options);
    /// Writes what waits for a picture.
    ~GameSaves();
    GameSaves(const GameSaves&) = delete;
    GameSaves& operator=(const GameSaves&) = delete;

    /// At the next barrier. A slot that is saved several times before it is saved once, as the last
    /// call wants it. What is saved is read back as `load` would before it is written. Throws
    /// Error(bad_name) for a slot that cannot be, Error(rejected) after `most_requests` calls
    /// between two barriers.
    void save(const std::string& slot);
    static constexpr std::size_t most_requests = 1000;
    /// Restores at the next barrier what was saved last in that slot: by a `save` that still waits
    /// for that barrier or for its picture, else what stands in the file, which is read and
    /// checked at once, as far as it can be before the barrier. Throws as `Saves::load` does, and
    /// Error(damaged, unknown_name, rejected) for a state that this game cannot restore, as it is
    /// when it is asked; the game goes on as it was.
    void load(const std::string& slot);
    /// Of the file and of a save that still waits. Throws as `Saves::remove` does.
    void remove(const std::string& slot);
    /// As `Saves::list`; a save that this game could not restore has a problem too.
    std::vector<SaveInfo> list() const;
    const Saves& slots() const { return saves_; }

    /// A save waits for a picture.
    bool waits() const { return !waiting_.empty(); }
    void finish(const Thumbnail& picture);

  private:
    struct Waiting {
        std::string slot;
        std::uint64_t step;
        std::shared_ptr<const std::vector<std::byte>> state;
    };
    void take(const std::string& slot, std::size_t request);
    Snapshot saved(const std::string& slot) const;
    void warn(const std::string& what) const;
    void warn_once(const std::string& what);
    Tree& tree() const;

    Tree& tree_;  // asked for by `tree`, which sees whether it lives
    std::weak_ptr<const Tree*> life_;
    Saves saves_;
    Options options_;
    std::size_t requests_ = 0;  // since the last barrier that made one come true
    std::map<std::string, std::size_t> requested_;  // the last one of each slot
    std::map<std::size_t, std::string>
        loaded_;                    // those that are loaded before the next of its slot
    std::vector<Waiting> waiting_;  // for a picture
    std::map<std::string, std::vector<std::byte>> unwritten_;  // by slot
    std::set<std::string> told_;                               // of formulas that are not saved
    /// What was asked for at a barrier may come when this is gone.
    std::shared_ptr<GameSaves*> alive_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
