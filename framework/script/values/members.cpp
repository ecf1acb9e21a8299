#include <algorithm>
#include <utility>

#include <lua/tree_names.h>
#include <values/members.h>

namespace fettle::script {

const Dispatch& DispatchTable::add(const Dispatch& entry) {
    constexpr std::size_t places_a_name = 8;  // low load, so that collisions are rare
    if (++count_ * places_a_name > size_) {
        const auto before = std::exchange(entries_, std::make_unique<Dispatch[]>(2 * size_));
        const std::size_t size = std::exchange(size_, 2 * size_);
        for (std::size_t i = 0; i < size; ++i)
            if (before[i].key != nullptr) entries_[place_of(before[i].key)] = before[i];
    }
    return entries_[place_of(entry.key)] = entry;
}

void DispatchTable::clear() {
    std::fill_n(entries_.get(), size_, Dispatch{});
    count_ = 0;
}

void MemberTables::clear() {
    for (const auto& table : tables_)
        if (table) table->clear();
}

DispatchTable& MemberTables::of(const property::Class& of) {
    if (of.id() >= tables_.size()) tables_.resize(of.id() + 1);
    auto& table = tables_[of.id()];
    if (!table) table = std::make_unique<DispatchTable>(tree_, of, recording_);
    return *table;
}

const property::Method* MemberTables::method_of(lua_State* L, int index) const {
    // A function that calls a method has the method as its upvalue.
    if (lua_iscfunction(L, index) == 0 || lua_getupvalue(L, index, 1) == nullptr) return nullptr;
    const auto found = methods.find(static_cast<const property::Method*>(lua_touserdata(L, -1)));
    lua_pop(L, 1);
    return found == methods.end() ? nullptr : found->first;
}

}  // namespace fettle::script
