#pragma once
// Undo steps, and the lists that store them.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/edits.h>
#include <fettle/property/symbol.h>

#include <instances/nodes.h>

namespace fettle::property {

struct CellEdit {
    Handle instance;
    Symbol property;
    CellState before, after;
};

/// State of a deleted instance: all cells that differ from those of a new instance.
struct DeletedInstance {
    Handle handle;
    const Class* of = nullptr;
    Position position;
    std::vector<std::pair<Symbol, CellState>> cells;
};

/// An instance was created or deleted, with everything below it.
struct ExistenceEdit {
    Handle top;
    bool birth = false;  // false: a deletion
    std::vector<DeletedInstance> deleted;
    std::size_t lost_watchers = 0;
};

struct MoveEdit {
    Handle instance;
    Position before, after;
};

using EditStep = std::variant<CellEdit, ExistenceEdit, MoveEdit>;

/// One step of undo.
struct Transaction {
    std::string name;
    Cause cause;
    std::vector<EditStep> steps;
    /// What undoing it has taken away: its new instances, and those below them, as they were then.
    /// The game may have changed them after the edit.
    std::vector<DeletedInstance> taken;
    /// It took more memory than the limit, so its steps were dropped.
    bool too_large = false;

    /// Approximate memory that it takes.
    std::size_t bytes() const;
};

std::size_t bytes_of(const EditStep& step);

/// A stack of transactions. Copies share the transactions, so a copy for each step of a game costs
/// the same however long the list is. A transaction in a list never changes.
class Transactions {
  public:
    bool empty() const { return top_ == nullptr; }
    const Transaction& top() const { return top_->what; }
    std::size_t top_bytes() const { return top_->bytes; }
    void push(Transaction transaction);
    void pop();
    /// Visits all transactions from the top down.
    void each(const std::function<void(const Transaction&)>& visit) const;
    /// Approximate memory of all transactions.
    std::size_t bytes() const;
    /// Forgets the oldest transactions until at most `limit` bytes are left; older copies keep
    /// them. Calls `forgotten` for each. Returns whether there were any.
    bool trim(std::size_t limit, const std::function<void(const Transaction&)>& forgotten);

  private:
    struct Link {
        Transaction what;
        std::size_t bytes = 0;
        std::shared_ptr<Link> below;

        Link(Transaction transaction, std::shared_ptr<Link> rest);
        ~Link();
        Link(const Link&) = delete;
    };
    std::shared_ptr<Link> top_;
};

}  // namespace fettle::property
