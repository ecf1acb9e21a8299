#include "dispatch.h"

#include <utility>

namespace fettle::script {

const property::Property Dispatch::no_property{};

namespace {

const Dispatch nothing;

// So many that hardly two names have the same place.
constexpr std::size_t places_a_name = 8;

}  // namespace

DispatchTable::DispatchTable(property::Tree& in, const property::Class& its_class, bool is_open)
    : tree(in), of(its_class) {
    open(is_open);
}

void DispatchTable::open(bool whether) {
    open_ = whether ? entries_.get() : &nothing;
    open_mask_ = whether ? mask() : 0;
}

Dispatch& DispatchTable::free_or_of(const void* key) const {
    std::size_t i = (offset(key) & mask()) / sizeof(Dispatch);
    while (entries_[i].member != Member::none && entries_[i].key != key) i = (i + 1) & (size_ - 1);
    return entries_[i];
}

const Dispatch* DispatchTable::find(const void* key) const {
    const Dispatch& found = free_or_of(key);
    return found.member != Member::none ? &found : nullptr;
}

const Dispatch& DispatchTable::add(const Dispatch& entry) {
    if (++count_ * places_a_name > size_) {
        const auto before = std::exchange(entries_, std::make_unique<Dispatch[]>(2 * size_));
        const std::size_t size = std::exchange(size_, 2 * size_);
        for (std::size_t i = 0; i < size; ++i)
            if (before[i].member != Member::none) free_or_of(before[i].key) = before[i];
        open(open_mask_ != 0);
    }
    return free_or_of(entry.key) = entry;
}

}  // namespace fettle::script
