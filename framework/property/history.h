#pragma once
// The history of a tree. Edits are kept as cells with what they were before and after; births and
// deaths of instances as images of all their cells. An instance that is brought back gets its old
// slot and generation, so handles to it work again; its slot is kept free for it while the history
// remembers it.

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fettle/property/edits.h>
#include <fettle/property/history.h>
#include <fettle/property/tree.h>

#include "nodes.h"
#include "watchers.h"

namespace fettle::property {

class History {
  public:
    explicit History(Tree& tree) : tree_(tree) {}

    using CellState = property::CellState;
    /// Where an instance hangs. `before`: the sibling in front of it.
    struct Position {
        Handle parent;
        Handle before;
        NodeName name;
        bool named = false;
    };

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
    bool recording() const;
    void begin(std::string name, bool scripts);
    void end();

    CellState capture(Handle instance, const Property& property) const;
    Position position(Handle instance) const;
    void edited(Handle instance, const Property& property, CellState before);
    void moved(Handle instance, const Position& before);
    void born(Handle instance);
    /// Before it dies. Its slots are kept for it.
    void dying(Handle instance);
    /// While an instance is deleted whose slots are kept.
    bool keeps_slots() const { return keep_slots_; }
    void watchers_lost(std::size_t count) { lost_watchers_ += count; }
    void keep_slots(bool keep) { keep_slots_ = keep; }
    void deletion_done() { keep_slots_ = false; }

    UndoResult undo();
    UndoResult redo();
    std::vector<HistoryEntry> entries() const;
    void set_limit(std::size_t bytes);
    std::size_t bytes() const { return bytes_; }
    void clear();

    /// The lists as they are, to be put back by `restore`; null puts back nothing: an empty
    /// history.
    Memory image() const;
    void restore(const Memory& image);
    std::uint64_t version() const { return version_; }

  private:
    struct CellEdit {
        Handle instance;
        Symbol property;
        CellState before, after;
    };
    struct Image {
        Handle handle;
        const Class* of = nullptr;
        Position position;
        std::vector<std::pair<Symbol, CellState>> cells;
    };
    struct Existence {
        Handle top;
        bool birth = false;  // else a death
        std::vector<Image> images;
        std::size_t lost_watchers = 0;
    };
    struct Move {
        Handle instance;
        Position before, after;
    };
    using Step = std::variant<CellEdit, Existence, Move>;
    struct Transaction {
        std::string name;
        Cause cause;
        std::vector<Step> steps;
        std::size_t bytes = 0;
    };

    void add(Step step, const std::string& name);
    void close();
    void forget(const Transaction& transaction);
    void trim();
    std::vector<Image> images_of(Handle top) const;
    UndoResult run(Transaction& transaction, bool back);
    void apply(CellEdit& edit, bool back, UndoResult& result);
    void apply(Existence& existence, bool back, UndoResult& result);
    void apply(Move& move, bool back, UndoResult& result);
    void set_cell(Handle instance, Symbol name, const CellState& state, UndoResult& result);
    bool hangs_too_deep(const Existence& existence) const;
    void revive(Existence& existence, UndoResult& result);
    void bury(Existence& existence, UndoResult& result);
    void place(Handle instance, const Position& at, UndoResult& result);

    Tree& tree_;
    EditObserver* observer_ = nullptr;
    // Never changed once they are in a list: snapshots share them.
    using Shared = std::shared_ptr<const Transaction>;
    std::deque<Shared> done_;
    std::vector<Shared> undone_;
    std::uint64_t version_ = 0;  // counts changes of the two
    Transaction open_;
    // Which step of the open edit a cell was written by, since something came or went last.
    std::unordered_map<Cell, std::size_t, CellHash> written_;
    int depth_ = 0;
    std::vector<bool> scripts_;     // of each open edit, whether what scripts write belongs to it
    std::size_t script_edits_ = 0;  // how many of them that is true of
    bool applying_ = false;
    bool keep_slots_ = false;
    std::size_t lost_watchers_ = 0;
    std::size_t bytes_ = 0;
    std::size_t limit_ = std::size_t{64} << 20;
};

}  // namespace fettle::property
