#pragma once
// A log of everything that is done to a tree from outside the simulation, so that it can be done
// again: between two states of the modules it says what scripts, formulas, handlers and people did.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <fettle/property/observer.h>
#include <fettle/property/tree.h>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// A piece of the log. Only of use in the process, and the tree, that made it.
struct LoggedWrites {
    std::vector<std::byte> bytes;
    std::vector<Formula> formulas;  // that the bytes speak of, by number
    Memory history;                 // of edits, as it was at the end, where it has changed
    std::size_t history_bytes = 0;  // of what was edited meanwhile
    bool too_much = false;          // more was done than a log should hold: it cannot be done again
    bool empty() const { return bytes.empty() && history == nullptr; }
    std::size_t memory() const;  // bytes it takes, about
};

/// Notes what is done while it lives. Costs a write about as much as copying what was written. It
/// may be destroyed after the tree; nothing else may be done with it then.
class WriteLog : public Observer {
  public:
    explicit WriteLog(Tree& tree);
    ~WriteLog() override;
    WriteLog(const WriteLog&) = delete;

    /// What was noted since the last call.
    LoggedWrites take();
    /// Whether there is something to take.
    bool any() const { return !bytes_.empty() || !kept_.empty(); }
    /// Bytes it holds now.
    std::size_t memory() const;
    /// Bytes one piece may take, 32 MiB unless told. What is more is not noted: `too_much`.
    void set_most(std::size_t bytes) { most_ = bytes; }
    /// Does a piece again: in the `go_on` of `Tree::restore`, in the state it was noted in. Throws
    /// Error(rejected) for a piece of another tree, Error(deleted) when its own is gone. That the
    /// bytes are those that `take` gave is not checked: they hold addresses.
    void play(const LoggedWrites& piece);

    void wrote(Handle instance, const Property& property, const Value& now) override;
    void wrote_plain(const PlainWrites& writes) override;
    void was_reset(Handle instance, const Property& property) override;
    void removed(Handle instance, const Property& property) override;
    void formula_changed(Handle instance, const Property& property) override;
    void created(Handle instance) override;
    void destroying(Handle instance) override;
    void moved(Handle instance) override;
    void call_begins(Handle instance, const Method& method,
                     std::span<const Value> arguments) override;
    void call_ends(Handle instance, const Method& method) override;
    void refreshing(SnapshotPart& part, std::uint64_t what) override;
    void restored() override;
    /// The last number that was given to a name of that stem below `parent`.
    void numbered(Handle parent, Symbol stem, std::uint32_t last);

  private:
    enum class Did : std::uint8_t;
    class FETTLE_PROPERTY_PRIVATE Player;
    void note(Did what, Handle instance, const Property& property);

    /// Plain writes come between the first `at` bytes and the others. Where they are kept they need
    /// be copied once only, when all is taken.
    struct Kept {
        std::size_t at;
        PlainWrites writes;
    };
    static constexpr std::size_t worth_keeping = 128;               // fewer are sooner copied
    static constexpr std::size_t most_kept = std::size_t{1} << 20;  // bytes, for the next piece

    /// Whether what is done now is to be noted.
    bool notes();
    void forget();
    void note_history();
    std::vector<std::byte> joined() const;
    static void put_plain(std::vector<std::byte>& bytes, std::span<const PlainWrite> writes);

    Tree& tree_;
    std::weak_ptr<const Tree*> life_;  // of the tree
    std::size_t most_ = std::size_t{32} << 20;
    bool too_much_ = false;
    std::vector<std::byte> bytes_;
    std::vector<Kept> kept_;
    std::size_t kept_count_ = 0;  // of writes
    std::vector<Formula> formulas_;
    std::size_t formula_bytes_ = 0;
    std::uint64_t history_version_ = 0;
    std::size_t history_bytes_ = 0;
    bool call_noted_ = false;
    int calls_ = 0;             // that run; what they do to the tree is done by them again
    std::vector<Handle> made_;  // by the outermost of them
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
