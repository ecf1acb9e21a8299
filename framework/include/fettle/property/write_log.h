#pragma once
// A log of all changes of a tree from outside the simulation, for replay. Between two states of the
// modules it contains the changes by scripts, formulas, handlers and people.

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

/// A piece of the log. Only usable in its process and its tree.
struct LoggedWrites {
    std::vector<std::byte> bytes;
    std::vector<Formula> formulas;  // formulas in the log; entries refer to their indices
    Memory history;                 // history at the end of the piece, if it has changed
    std::size_t history_bytes = 0;  // bytes of the edits in the piece
    bool too_much = false;          // more changes than the limit: it cannot be played
    bool empty() const { return bytes.empty() && history == nullptr; }
    std::size_t memory() const;  // its memory in bytes, estimated
};

/// Logs all changes while it lives. Logging a write costs about as much as copying its data. The
/// log may outlive the tree; then only its destructor may be called.
class WriteLog : public Observer {
  public:
    explicit WriteLog(Tree& tree);
    ~WriteLog() override;
    WriteLog(const WriteLog&) = delete;

    /// Returns the log since the last call.
    LoggedWrites take();
    /// Must be called when all changes of a step were made and taken: the last writer of a value is
    /// asked for at a step, and later changes are not in its state.
    void end_step();
    /// True if there is something to take.
    bool any() const { return !bytes_.empty() || !kept_.empty(); }
    /// Bytes it holds now.
    std::size_t memory() const;
    /// Limit of one piece in bytes, 32 MiB by default. Further changes are not logged and set
    /// `too_much`.
    void set_limit(std::size_t bytes) { limit_ = bytes; }
    /// Repeats a piece: in the `go_on` of `Tree::restore`, in the state at the beginning of the
    /// piece. Throws Error(rejected) for a piece of another tree, Error(deleted) if its tree is
    /// destroyed. It does not check that the bytes come from `take`: they contain addresses.
    void play(const LoggedWrites& piece);

    void wrote(Handle instance, const Property& property, const Value& now) override;
    void wrote_element(Handle instance, const Property& property, std::size_t index,
                       const Value* element, const Value& now) override;
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
    /// Logs the last number that was used for a name of that stem below `parent`.
    void numbered(Handle parent, Symbol stem, std::uint32_t last);

  private:
    enum class EntryKind : std::uint8_t;
    class FETTLE_PROPERTY_PRIVATE Player;
    void note(EntryKind what, Handle instance, const Property& property);
    /// The values of the properties from which it derives, if the write has changed them.
    void note_sources(Handle instance, const Property& property);

    /// Plain writes that belong after the first `at` bytes. They are copied only once, when the
    /// log is taken.
    struct Kept {
        std::size_t at;
        PlainWrites writes;
    };
    static constexpr std::size_t worth_keeping = 128;              // fewer are copied at once
    static constexpr std::size_t max_kept = std::size_t{1} << 20;  // bytes of the reused buffer

    /// True if changes are to be logged now.
    bool notes();
    void forget();
    void note_history();
    std::vector<std::byte> joined() const;
    static void put_plain(std::vector<std::byte>& bytes, std::span<const PlainWrite> writes);

    Tree& tree_;
    std::weak_ptr<const Tree*> life_;  // of the tree
    std::size_t limit_ = std::size_t{32} << 20;
    bool too_much_ = false;
    std::vector<std::byte> bytes_;
    std::vector<Kept> kept_;
    std::size_t kept_count_ = 0;  // number of writes in `kept_`
    std::vector<Formula> formulas_;
    std::size_t formula_bytes_ = 0;
    std::uint64_t history_version_ = 0;
    std::size_t history_bytes_ = 0;
    bool call_noted_ = false;
    int calls_ = 0;             // running method calls; they repeat their changes of the tree
    std::vector<Handle> made_;  // instances made by the outermost call
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
