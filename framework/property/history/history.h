#pragma once
// The history of a tree. Edits are stored as cells with their states before and after; created and
// deleted instances are stored as images of all their cells. Undo brings an instance back with its
// old slot and generation, so old handles to it work again. Its slot stays reserved while the
// history contains it.

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
    /// Whether a write by this writer is an edit by a person.
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
    /// Must be called whenever the writer changes or an edit begins or ends.
    void note_recording();
    void begin(std::string name, bool scripts);
    void end();

    CellState capture(Handle instance, const Property& property) const;
    /// The current state of a cell that is about to be edited, if the edit is recorded. Names and
    /// parents are recorded as moves instead.
    std::optional<CellState> before_edit(Handle instance, const Property& property) const {
        if (!structure_.changes.recording() || property.binding.kind == BindingKind::node ||
            is_of_present(instance, property))
            return {};
        return capture(instance, property);
    }
    void edited(Handle instance, const Property& property, CellState before);
    void moved(Handle instance, const Position& before);
    void instance_created(Handle instance);
    /// Called before an instance is deleted. Reserves the slots for undo.
    void instance_deleting(Handle instance);

    UndoResult undo();
    UndoResult redo();
    /// All entries, the latest first. Undone entries come before those that were not undone.
    std::vector<HistoryEntry> entries() const;
    void set_limit(std::size_t bytes);
    /// Approximate memory of the lists.
    std::size_t bytes() const;
    /// Bytes of all entries that were ever added. Entries that are no longer in the lists may still
    /// be in older images.
    std::size_t bytes_ever() const { return bytes_ever_; }
    std::size_t edits_without_undo() const { return edits_without_undo_; }

    /// Bytes that the states of the observer in all images took when they were made.
    std::size_t observed_bytes() const { return observed_bytes_; }

    /// The current lists, for `restore`, and the state of the observer. The cost does not depend on
    /// the length of the lists.
    Memory image() const;
    /// An image of another tree, or null, puts back nothing: an empty history. Edits hold classes
    /// and formulas of their tree.
    void restore(const Memory& image);
    /// Whether the image is one of this tree.
    bool owns(const Memory& image) const;
    /// Frees reserved slots that no entry of the history needs any more. A restored state may
    /// reserve slots for entries that were forgotten since.
    void free_unclaimed();
    std::uint64_t version() const { return version_; }

  private:
    struct Lists {
        Transactions done, undone;
    };
    struct Image {
        std::weak_ptr<const Tree*> of;
        Lists lists;
        Memory observed;  // state of the observer
    };
    /// While it lives and instances are deleted, the references of living instances are known as
    /// they were before the first deletion.
    class References {
      public:
        References(History& history, bool wanted);
        ~References();
        References(const References&) = delete;

      private:
        History& history_;
        bool before_;
    };

    /// An edit that has changed nothing yet does not count: every console command is an edit, also
    /// `undo()`.
    bool edit_is_open() const { return depth_ > 0 && (!open_.steps.empty() || open_.too_large); }
    /// A transaction that takes more bytes than this is forgotten at once.
    std::size_t max_edit_bytes() const { return limit_ - limit_ / 4; }
    void add(EditStep step, const std::string& name);
    void close();
    void put(Transactions& list, Transaction transaction);
    UndoResult carry_over(Transactions& from, Transactions& to, bool back);
    Transaction take(Transactions& list);
    /// Calls `what(observer)` if there is an observer, which must not destroy the tree.
    template <class What>
    void inform(What what) {
        if (observer_ == nullptr) return;
        const Pin pin(structure_.changes.lifetime, "an observer of edits");
        ++version_;
        what(*observer_);
    }
    void clear(Transactions& list);
    void forget(const Transaction& transaction);
    void make_void(Transaction& transaction);
    void trim();
    std::vector<DeletedInstance> deleted_below(Handle top) const;
    void note_references();
    CellState before_deletion(Handle instance, const Property& property) const;
    UndoResult run(Transaction& transaction, bool back);
    std::vector<DeletedInstance> made_by(const Transaction& transaction) const;
    void give_back(const std::vector<DeletedInstance>& taken, UndoResult& result);
    void give_back(const DeletedInstance& taken, UndoResult& result);
    void apply(CellEdit& edit, bool back, UndoResult& result);
    void add_change(Handle instance, const Property& property, const CellState& from,
                    UndoResult& result) const;
    void apply(ExistenceEdit& existence, bool back, UndoResult& result);
    void apply(MoveEdit& move, bool back, UndoResult& result);
    void set_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result);
    bool would_be_too_deep(const ExistenceEdit& existence) const;
    void revive(ExistenceEdit& existence, UndoResult& result);
    void delete_again(ExistenceEdit& existence, UndoResult& result);
    void place(Handle instance, const Position& at, UndoResult& result);

    Structure& structure_;
    Instances& instances_;
    Nodes& nodes_;
    Tree& tree_;
    EditObserver* observer_ = nullptr;
    Lists lists_;
    std::uint64_t version_ = 0;  // counts changes of both lists, and calls of the observer
    Transaction open_;
    std::size_t open_bytes_ = 0;
    // For each cell, the step of the open edit that wrote it. Cleared when an instance is created
    // or deleted.
    std::unordered_map<Cell, std::size_t, CellHash> written_;
    // The target of each reference before the first of several instances was deleted. Modules may
    // clear references to deleted instances.
    std::unordered_map<Cell, Handle, CellHash> references_;
    bool needs_references_ = false;
    bool has_references_ = false;
    /// A cell whose saved state refers to a deleted instance. The state is written when that
    /// instance is back, unless the cell was written otherwise meanwhile.
    struct Unresolved {
        Handle instance;
        Symbol property;
        CellState state;
        std::optional<CellState> meanwhile{};  // state of the cell until then
    };
    std::vector<Unresolved> unresolved_;
    void resolve(UndoResult& result);
    bool may_resolve(const Unresolved& cell) const;
    CellState capture(Handle instance, Symbol name) const;
    /// Whether neither saved games nor going back in time change the property, such as
    /// `view.show.names` and `console.height`: writing it is not an edit of the game.
    bool is_of_present(Handle instance, const Property& property) const {
        return property.transient && tree_.class_of(instance).snapshots() == Snapshots::never;
    }
    void write_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result);
    int depth_ = 0;
    std::vector<bool> scripts_;     // for each open edit: whether writes by scripts belong to it
    std::size_t script_edits_ = 0;  // number of true values in `scripts_`
    bool applying_ = false;
    mutable std::optional<std::size_t> bytes_ = 0;  // bytes of both lists, if known
    std::size_t bytes_ever_ = 0;
    std::size_t edits_without_undo_ = 0;  // ever
    mutable std::size_t observed_bytes_ = 0;
    std::size_t limit_ = std::size_t{64} << 20;
};

}  // namespace fettle::property
