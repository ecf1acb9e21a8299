#include "transactions.h"

#include <values/weight.h>

namespace fettle::property {
namespace {

// Bytes per allocation that the allocator and a shared pointer add.
constexpr std::size_t overhead = 32;

std::size_t size_of(const CellState& state) {
    return sizeof state + size_of(state.value) + (state.formula ? bytes_of(*state.formula) : 0);
}

std::size_t size_of(const DeletedInstance& deleted) {
    std::size_t bytes = sizeof deleted + overhead;
    for (const auto& [symbol, state] : deleted.cells) bytes += sizeof symbol + size_of(state);
    return bytes;
}

}  // namespace

std::size_t bytes_of(const EditStep& step) {
    std::size_t bytes = sizeof step;
    if (const auto* edit = std::get_if<CellEdit>(&step))
        bytes += size_of(edit->before) + size_of(edit->after);
    if (const auto* existence = std::get_if<ExistenceEdit>(&step))
        for (const DeletedInstance& deleted : existence->deleted) bytes += size_of(deleted);
    return bytes;
}

std::size_t Transaction::bytes() const {
    std::size_t sum = sizeof *this + 3 * overhead + name.size() + cause.where.size();
    for (const EditStep& step : steps) sum += bytes_of(step);
    for (const DeletedInstance& instance : taken) sum += size_of(instance);
    return sum;
}

Transactions::Link::Link(Transaction transaction, std::shared_ptr<Link> rest)
    : what(std::move(transaction)), bytes(what.bytes() + sizeof(Link)), below(std::move(rest)) {}

/// Destroys the links in a loop. Recursion over a list of a hundred thousand links would overflow
/// the stack.
Transactions::Link::~Link() {
    while (below != nullptr && below.use_count() == 1) below = std::exchange(below->below, nullptr);
}

void Transactions::push(Transaction transaction) {
    transaction.steps.shrink_to_fit();
    top_ = std::make_shared<Link>(std::move(transaction), std::move(top_));
}

void Transactions::pop() {
    top_ = std::shared_ptr<Link>(top_)->below;
}

void Transactions::each(const std::function<void(const Transaction&)>& visit) const {
    for (const Link* link = top_.get(); link != nullptr; link = link->below.get())
        visit(link->what);
}

std::size_t Transactions::bytes() const {
    std::size_t sum = 0;
    for (const Link* link = top_.get(); link != nullptr; link = link->below.get())
        sum += link->bytes;
    return sum;
}

bool Transactions::trim(std::size_t limit,
                        const std::function<void(const Transaction&)>& forgotten) {
    std::size_t left = limit;
    std::shared_ptr<Link>* rest = &top_;
    for (; *rest != nullptr && (*rest)->bytes <= left; rest = &(*rest)->below)
        left -= (*rest)->bytes;
    if (*rest == nullptr) return false;
    std::shared_ptr<Link> cut = std::exchange(*rest, nullptr);
    for (const Link* link = cut.get(); link != nullptr; link = link->below.get())
        forgotten(link->what);
    return true;
}

}  // namespace fettle::property
