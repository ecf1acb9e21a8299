#pragma once
// The history of a tree. Edits are kept as cells with what they were before and after; births and
// deaths of instances as images of all their cells. An instance that is brought back gets its old
// slot and generation, so handles to it work again; its slot is kept free for it while the history
// remembers it.

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/edits.h>
#include <fettle/property/history.h>
#include <fettle/property/tree.h>

#include <structure/structure.h>

#include "transactions.h"

namespace fettle::property {

class History {
  public:
    explicit History(Structure& structure)
        : structure_(structure),
          instances_(structure.instances),
          nodes_(structure.nodes),
          tree_(structure.tree) {}

    void observe(EditObserver* observer) { observer_ = observer; }
    /// Whether what is written now is a person's edit.
    bool recording(Writer writer) const {
        if (applying_) return false;
        switch (writer) {
            case Writer::console:
            case Writer::inspector:
            case Writer::remote:
                return true;
            case Writer::script:
            case Writer::module:
                return script_edits_ != 0;
            default:
                return false;
        }
    }
    /// To be called whenever the writer is another, or an edit begins or ends.
    void note_recording();
    void begin(std::string name, bool scripts);
    void end();

    CellState capture(Handle instance, const Property& property) const;
    /// What the cell is now, where it is about to be edited and that is recorded. Names and parents
    /// are recorded as moves.
    std::optional<CellState> before_edit(Handle instance, const Property& property) const {
        if (!structure_.changes.recording() || property.binding.kind == BindingKind::node)
            return {};
        return capture(instance, property);
    }
    void edited(Handle instance, const Property& property, CellState before);
    void moved(Handle instance, const Position& before);
    void born(Handle instance);
    /// Before it dies. Its slots are kept for it.
    void dying(Handle instance);

    UndoResult undo();
    UndoResult redo();
    /// The latest first; what was undone is later than what was not.
    std::vector<HistoryEntry> entries() const;
    void set_limit(std::size_t bytes);
    /// Memory it takes, about.
    std::size_t bytes() const;
    /// Of all that was ever put into it; what is not in it now is forgotten, though images made
    /// before may hold it.
    std::size_t bytes_ever() const { return bytes_ever_; }

    /// The lists as they are, to be put back by `restore`; null puts back nothing: an empty
    /// history. Costs the same however long they are.
    Memory image() const;
    void restore(const Memory& image);
    /// Slots that are kept for the dead of edits that are forgotten: a state of the past may keep
    /// them for what was forgotten since.
    void free_unclaimed();
    std::uint64_t version() const { return version_; }

  private:
    struct Lists {
        Transactions done, undone;
    };
    /// While it lives and something is deleted, whom the living refer to is known as it was before.
    class References {
      public:
        References(History& history, bool wanted);
        ~References();
        References(const References&) = delete;

      private:
        History& history_;
        bool before_;
    };

    /// One that has changed nothing yet is none: `undo()` is a console command, and each is an
    /// edit.
    bool edit_is_open() const { return depth_ > 0 && (!open_.steps.empty() || open_.too_large); }
    /// What is more than this is forgotten as soon as it is made.
    std::size_t most_of_one() const { return limit_ - limit_ / 4; }
    void add(EditStep step, const std::string& name);
    void close();
    void put(Transactions& list, Transaction transaction);
    UndoResult carry_over(Transactions& from, Transactions& to, bool back);
    Transaction take(Transactions& list);
    void clear(Transactions& list);
    void forget(const Transaction& transaction);
    void make_void(Transaction& transaction);
    void trim();
    std::vector<Buried> buried_below(Handle top) const;
    void note_references();
    CellState before_deletion(Handle instance, const Property& property) const;
    UndoResult run(Transaction& transaction, bool back);
    void apply(CellEdit& edit, bool back, UndoResult& result);
    void apply(ExistenceEdit& existence, bool back, UndoResult& result);
    void apply(MoveEdit& move, bool back, UndoResult& result);
    void set_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result);
    bool hangs_too_deep(const ExistenceEdit& existence) const;
    void revive(ExistenceEdit& existence, UndoResult& result);
    void bury(ExistenceEdit& existence, UndoResult& result);
    void place(Handle instance, const Position& at, UndoResult& result);

    Structure& structure_;
    Instances& instances_;
    Nodes& nodes_;
    Tree& tree_;
    EditObserver* observer_ = nullptr;
    Lists lists_;
    std::uint64_t version_ = 0;  // counts changes of the two
    Transaction open_;
    std::size_t open_bytes_ = 0;
    // Which step of the open edit a cell was written by, since something came or went last.
    std::unordered_map<Cell, std::size_t, CellHash> written_;
    // Whom each cell referred to when the first instance of several was about to be deleted: the
    // modules of those that are left may forget it.
    std::unordered_map<Cell, Handle, CellHash> references_;
    bool wants_references_ = false;
    bool has_references_ = false;
    /// A cell that is to name an instance that is deleted: it gets its state when that instance
    /// is there again, unless something else has written the cell meanwhile.
    struct Unresolved {
        Handle instance;
        Symbol property;
        CellState state;
        std::optional<CellState> meanwhile{};  // what the cell holds until then
    };
    std::vector<Unresolved> unresolved_;
    void resolve(UndoResult& result);
    bool may_resolve(const Unresolved& cell) const;
    CellState capture(Handle instance, Symbol name) const;
    void write_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result);
    int depth_ = 0;
    std::vector<bool> scripts_;     // of each open edit, whether what scripts write belongs to it
    std::size_t script_edits_ = 0;  // how many of them that is true of
    bool applying_ = false;
    mutable std::optional<std::size_t> bytes_ = 0;  // of the lists, where it is known
    std::size_t bytes_ever_ = 0;
    std::size_t limit_ = std::size_t{64} << 20;
};

}  // namespace fettle::property
