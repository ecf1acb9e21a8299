#pragma once
// What was edited, in steps of undo, and the lists that keep them.

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

/// What a dead instance was: all that is not as in one just made.
struct Buried {
    Handle handle;
    const Class* of = nullptr;
    Position position;
    std::vector<std::pair<Symbol, CellState>> cells;
};

/// An instance, and what is below it, came or went.
struct ExistenceEdit {
    Handle top;
    bool birth = false;  // else a death
    std::vector<Buried> buried;
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
    /// It took more memory than there is for all: what it did is not known any more.
    bool too_large = false;

    /// Memory it takes, about.
    std::size_t bytes() const;
};

std::size_t bytes_of(const EditStep& step);

/// Transactions, the latest on top. Copies share what is in them, so that a copy for each step of a
/// game costs nothing however long the list is; what is in a list never changes.
class Transactions {
  public:
    bool empty() const { return top_ == nullptr; }
    const Transaction& top() const { return top_->what; }
    std::size_t top_bytes() const { return top_->bytes; }
    void push(Transaction transaction);
    void pop();
    /// From the top down.
    void each(const std::function<void(const Transaction&)>& visit) const;
    /// Memory all of them take, about.
    std::size_t bytes() const;
    /// Forgets the lowest so that at most `most` bytes are left; copies made before keep them.
    /// `forgotten` hears of each. Whether there were any.
    bool trim(std::size_t most, const std::function<void(const Transaction&)>& forgotten);

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
