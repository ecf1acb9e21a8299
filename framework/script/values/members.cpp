#include <utility>

#include <lua/tree_names.h>
#include <values/members.h>

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

DispatchTable& MemberTables::of(const property::Class& of) {
    if (of.id() >= tables_.size()) tables_.resize(of.id() + 1);
    auto& table = tables_[of.id()];
    if (!table) table = std::make_unique<DispatchTable>(tree_, of, open_);
    return *table;
}

void MemberTables::open(bool whether) {
    open_ = whether;
    for (const auto& table : tables_)
        if (table) table->open(whether);
}

const property::Method* MemberTables::method_of(lua_State* L, int index) const {
    // The function that calls a method has it as its upvalue.
    if (lua_iscfunction(L, index) == 0 || lua_getupvalue(L, index, 1) == nullptr) return nullptr;
    const auto found = methods.find(static_cast<const property::Method*>(lua_touserdata(L, -1)));
    lua_pop(L, 1);
    return found == methods.end() ? nullptr : found->first;
}

}  // namespace fettle::script
