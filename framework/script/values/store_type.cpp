#include <values/store_type.h>

#include <utility>

#include <fettle/property/path.h>
#include <fettle/script/runtime.h>

#include <limits/limiters.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <text/columns.h>
#include <values/recording.h>
#include <values/short_text.h>

namespace fettle::script {

using property::Store;

namespace {

Store& store_of(lua_State* L) {
    Store* const store = machine_of(L).options.store;
    if (store == nullptr) throw Error(ErrorKind::rejected, "store: this game has no place for one");
    return *store;
}

[[noreturn]] void refuse_in_formula() {
    throw Error(ErrorKind::rejected,
                "the store cannot be read in a formula, which would not notice its changes: copy "
                "the value to a property");
}

const StoreBox& store_self(lua_State* L, const char* what) {
    const auto* box = store_at(L, 1);
    if (box == nullptr) refuse_argument(L, 1, what, "a table of the store");
    return *box;
}

using Content = std::shared_ptr<const Store::Content>;

void push_table(lua_State* L, Store::Table table, const Content& content) {
    auto* box = static_cast<StoreBox*>(lua_newuserdatauv(L, sizeof(StoreBox), 0));
    *box = {Tag::store, table, nullptr};
    push_registry(L, machine_of(L).boxes.store);
    lua_setmetatable(L, -2);
    // The content of the root is never replaced.
    if (content != nullptr) box->content = new Content(content);
}

int release_store(lua_State* L) {
    auto* box = static_cast<StoreBox*>(lua_touserdata(L, 1));
    if (box != nullptr && box->tag == Tag::store) delete std::exchange(box->content, nullptr);
    return 0;
}

/// Pushes a vector or a color with the table at `table` and the key at `key` from which it is read,
/// so that assigning a component writes there.
void push_stored(lua_State* L, const Value& value, int table, int key) {
    if (value.is(property::Type::vec2))
        push_vec(L, value.vec2(), 2);
    else
        push_color(L, value.color(), 2);
    lua_pushvalue(L, table);
    lua_setiuservalue(L, -2, 1);
    lua_pushvalue(L, key);
    lua_setiuservalue(L, -2, 2);
}

/// The entry with the key at `key` in the table of the store at `table`.
void push_entry(lua_State* L, const Store::Entry& entry, int table, int key) {
    if (entry.content)
        push_table(L, entry.table, entry.content);
    else if (entry.value.is(property::Type::vec2) || entry.value.is(property::Type::color))
        push_stored(L, entry.value, table, key);
    else
        push_value(L, entry.value);
}

using Entries = std::map<Store::Key, Store::Entry>;

/// What is in a table, or was in it when it was replaced or removed.
const Entries& entries_of(const Store& store, const StoreBox& box) {
    const bool kept = box.content != nullptr && !(*box.content)->forgotten;
    return kept ? (*box.content)->entries : store.entries(box.table);
}

const Store::Entry* find_in(const Store& store, const StoreBox& box, const Store::Key& key) {
    const auto& all = entries_of(store, box);
    const auto found = all.find(key);
    return found == all.end() ? nullptr : &found->second;
}

/// The key at `index`; throws for a value that is neither a text nor a whole number.
Store::Key key_at(lua_State* L, int index, const std::string& where) {
    if (lua_type(L, index) == LUA_TSTRING) return string_at(L, index);
    if (lua_isinteger(L, index)) return std::int64_t{lua_tointeger(L, index)};
    int whole = 0;
    const lua_Integer number =
        lua_type(L, index) == LUA_TNUMBER ? lua_tointegerx(L, index, &whole) : 0;
    if (whole != 0) return std::int64_t{number};
    const bool fraction = lua_type(L, index) == LUA_TNUMBER;
    throw Error(ErrorKind::wrong_type,
                where + ": a key in the store is a text or a whole number, not " +
                    (fraction ? short_text(L, index) : describe_type(L, index)));
}

/// Makes an entry of a value of Lua. A table may contain another one many times, so the
/// size is limited while the table is copied.
class Filling {
  public:
    Filling(lua_State* L, const std::string& path) : L_(L), path_(path) {}

    Store::Entry entry_at(int index, int depth, const std::string& path) {
        if (lua_type(L_, index) == LUA_TTABLE) return table_at(index, depth, path);
        if (const auto* box = store_at(L_, index)) return copy_of(entries_of(store_of(L_), *box));
        if (instance_at(L_, index) != nullptr || class_object_at(L_, index) != nullptr)
            throw Error(ErrorKind::wrong_type,
                        path + ": " + describe_type(L_, index) +
                            " cannot be in the store, because it ends with the run; put its name "
                            "or its values there");
        const int type = lua_type(L_, index);
        const bool plain = type == LUA_TNIL || type == LUA_TBOOLEAN || type == LUA_TNUMBER ||
                           type == LUA_TSTRING || vec_at(L_, index) != nullptr ||
                           color_at(L_, index) != nullptr || list_at(L_, index) != nullptr;
        if (!plain)
            throw Error(ErrorKind::wrong_type,
                        path + ": " + describe_type(L_, index) +
                            " cannot be in the store; it holds texts, numbers, booleans, vecs, "
                            "colors and tables of these");
        return entry_of(to_value(L_, index));
    }

  private:
    void put(Store::Entry& table, const Store::Key& key, Store::Entry entry) {
        machine_of(L_).limiters.budget.charge(L_, 10);
        bytes_ += Store::size_of(key, entry.value);
        if (bytes_ > Store::size_limit) Store::refuse_size(path_);
        table.content->entries[key] = std::move(entry);
    }

    Store::Entry entry_of(const Value& value) {
        if (!value.is(Type::list)) return {.value = value};
        Store::Entry table{.content = std::make_shared<Store::Content>()};
        std::int64_t place = 0;
        for (const Value& each : value.list()) put(table, ++place, entry_of(each));
        return table;
    }

    /// A copy of a table that is in the store already, or was.
    Store::Entry copy_of(const Entries& of) {
        Store::Entry table{.content = std::make_shared<Store::Content>()};
        for (const auto& [key, entry] : of)
            put(table, key, entry.content ? copy_of(entries_in(entry)) : entry);
        return table;
    }
    const Entries& entries_in(const Store::Entry& entry) const {
        Content content = entry.content;
        return entries_of(store_of(L_), {Tag::store, entry.table, &content});
    }

    Store::Entry table_at(int index, int depth, const std::string& path) {
        const void* const self = lua_topointer(L_, index);
        for (const auto& [outer, its_path] : around_)
            if (outer == self)
                throw Error(ErrorKind::rejected,
                            path + ": this is " + its_path +
                                " again; a table that contains itself has no end, and the store "
                                "holds copies");
        around_.emplace_back(self, path);
        if (depth >= Store::depth_limit || lua_checkstack(L_, 4) == 0)
            throw Error(ErrorKind::rejected, path + ": tables in the store are nested at most " +
                                                 std::to_string(Store::depth_limit) + " deep");
        Store::Entry table{.content = std::make_shared<Store::Content>()};
        for (lua_pushnil(L_); lua_next(L_, index) != 0; lua_pop(L_, 1)) {
            const Store::Key key = key_at(L_, -2, path);
            const auto* const name = std::get_if<std::string>(&key);
            const std::string inner =
                path + (name != nullptr ? property::path_suffix(*name)
                                        : "[" + std::to_string(std::get<std::int64_t>(key)) + "]");
            put(table, key, entry_at(lua_gettop(L_), depth + 1, inner));
        }
        around_.pop_back();
        return table;
    }

    lua_State* L_;
    const std::string& path_;                                    // of the whole entry
    std::vector<std::pair<const void*, std::string>> around_{};  // tables, with their paths
    std::size_t bytes_ = 0;
};

// --- Methods

int store_clear(lua_State* L) {
    if (store_self(L, "store:clear").table != Store::root)
        throw Error(ErrorKind::rejected, "clear: only the store itself has this function");
    store_of(L).clear();
    machine_of(L).recording.note({}, "store", "cleared");
    return 0;
}

int store_has(lua_State* L) {
    const StoreBox& self = store_self(L, "store:has");
    lua_pushboolean(L, find_in(store_of(L), self, key_at(L, 2, "store:has")) != nullptr);
    return 1;
}

/// Pushes the method of the store with the name at `index`. False if there is none.
bool push_store_method(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TSTRING) return false;
    const std::string_view name = view_at(L, index);
    if (name == "clear")
        lua_pushcfunction(L, guarded<effect<store_clear>>);
    else if (name == "has")
        lua_pushcfunction(L, guarded<varying<store_has>>);
    else
        return false;
    return true;
}

// --- Metamethods

int store_index(lua_State* L) {
    const StoreBox& self = store_self(L, "store");
    if (self.table == Store::root && push_store_method(L, 2)) return 1;
    if (machine_of(L).tree.in_formula()) refuse_in_formula();
    const Store& store = store_of(L);
    const bool possible = lua_type(L, 2) == LUA_TSTRING || lua_type(L, 2) == LUA_TNUMBER;
    const Store::Entry* entry = possible ? find_in(store, self, key_at(L, 2, "store")) : nullptr;
    if (entry == nullptr) {
        lua_pushnil(L);
    } else {
        push_entry(L, *entry, 1, 2);
    }
    return 1;
}

std::string entry_text(Machine& machine, const Store::Entry* entry) {
    if (entry == nullptr) return "nil";
    if (!entry->content) return cut(machine.tree.text(entry->value), 60);
    Content content = entry->content;
    return stored_text(machine, {Tag::store, entry->table, &content});
}

int store_newindex(lua_State* L) {
    const Store::Table self = store_self(L, "store").table;
    Machine& machine = machine_of(L);
    Store& store = store_of(L);
    if (self == Store::root && push_store_method(L, 2))
        throw Error(ErrorKind::bad_name, "store." + string_at(L, 2) +
                                             ": this is a function of the store; choose another "
                                             "name for the value");
    const Store::Key key = key_at(L, 2, "store");
    const std::string path = store.path(self, key);
    lua_settop(L, 3);
    // A table that is put where it is already stays the same, for all variables that hold it.
    const auto* const given = store_at(L, 3);
    const Store::Entry* const there = store.find(self, key);
    if (given != nullptr && there != nullptr && there->content && there->table == given->table)
        return 0;
    Store::Entry entry = Filling(L, path).entry_at(3, 0, path);
    const std::string before =
        machine.recording.active ? entry_text(machine, store.find(self, key)) : std::string();
    store.set(self, key, std::move(entry));
    if (machine.recording.active)
        machine.recording.note({}, path,
                               before + " → " + entry_text(machine, store.find(self, key)));
    return 0;
}

int store_length(lua_State* L) {
    const auto& all = entries_of(store_of(L), store_self(L, "#"));
    lua_Integer length = 0;
    for (auto at = all.find(std::int64_t{1});
         at != all.end() && at->first == Store::Key(std::int64_t{length + 1}); ++at)
        ++length;
    machine_of(L).limiters.budget.charge(L, static_cast<std::uint64_t>(length));
    lua_pushinteger(L, length);
    return 1;
}

int store_equal(lua_State* L) {
    const auto *a = store_at(L, 1), *b = store_at(L, 2);
    lua_pushboolean(L, a != nullptr && b != nullptr && a->table == b->table);
    return 1;
}

int store_tostring(lua_State* L) {
    push_text(L, stored_text(machine_of(L), store_self(L, "tostring")));
    return 1;
}

// Visits a copy of the keys, in their order. Upvalues: the keys, the position.
int next_stored(lua_State* L) {
    const StoreBox& self = store_self(L, "pairs");
    for (;;) {
        const lua_Integer place = lua_tointeger(L, lua_upvalueindex(2)) + 1;
        lua_pushinteger(L, place);
        lua_copy(L, -1, lua_upvalueindex(2));
        lua_pop(L, 1);
        if (lua_rawgeti(L, lua_upvalueindex(1), place) == LUA_TNIL) return 1;
        if (const Store::Entry* entry = find_in(store_of(L), self, key_at(L, -1, "pairs"))) {
            push_entry(L, *entry, 1, lua_gettop(L));
            return 2;
        }
        lua_pop(L, 1);  // removed meanwhile
    }
}

int store_pairs(lua_State* L) {
    const auto& all = entries_of(store_of(L), store_self(L, "pairs"));
    machine_of(L).limiters.budget.charge(L, all.size());
    lua_settop(L, 1);
    lua_createtable(L, static_cast<int>(all.size()), 0);
    lua_Integer place = 0;
    for (const auto& [key, entry] : all) {
        if (const auto* const name = std::get_if<std::string>(&key))
            push_text(L, *name);
        else
            lua_pushinteger(L, std::get<std::int64_t>(key));
        lua_rawseti(L, -2, ++place);
    }
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, guarded<next_stored>, 2);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

}  // namespace

Value stored_list(lua_State* L, const StoreBox& box) {
    if (machine_of(L).tree.in_formula()) refuse_in_formula();
    if (box.table == Store::root)
        throw Error(ErrorKind::wrong_type, "the whole store is not a value of a property");
    List list;
    for (const auto& [key, entry] : entries_of(store_of(L), box)) {
        machine_of(L).limiters.budget.charge(L, 1);
        if (const auto* const name = std::get_if<std::string>(&key)) refuse_named_keys(*name);
        if (std::get<std::int64_t>(key) != static_cast<std::int64_t>(list.size()) + 1)
            refuse_gaps();
        Content content = entry.content;
        list.push_back(content ? stored_list(L, {Tag::store, entry.table, &content}) : entry.value);
    }
    return list;
}

bool refresh_stored(lua_State* L) {
    if (lua_getiuservalue(L, 1, 1) != LUA_TUSERDATA) {
        lua_pop(L, 1);
        return false;
    }
    lua_getiuservalue(L, 1, 2);
    lua_gettable(L, -2);
    auto *vec = vec_at(L, 1), *now = vec_at(L, -1);
    auto *color = color_at(L, 1), *color_now = color_at(L, -1);
    if (vec != nullptr && now != nullptr) {
        vec->x = now->x;
        vec->y = now->y;
    } else if (color != nullptr && color_now != nullptr) {
        color->color = color_now->color;
    } else {
        throw Error(ErrorKind::rejected, stored_path(L) + ": is not a " +
                                             (vec != nullptr ? "vec" : "color") + " any more");
    }
    lua_pop(L, 2);
    return true;
}

void write_stored(lua_State* L) {
    lua_getiuservalue(L, 1, 1);
    lua_getiuservalue(L, 1, 2);
    lua_pushvalue(L, 1);
    lua_settable(L, -3);
    lua_pop(L, 1);
}

std::string stored_path(lua_State* L) {
    lua_getiuservalue(L, 1, 1);
    lua_getiuservalue(L, 1, 2);
    const Store::Table table = store_at(L, -2)->table;
    const Store::Key key = key_at(L, -1, "store");
    lua_pop(L, 2);
    return store_of(L).path(table, key);
}

std::string stored_text(Machine& machine, const StoreBox& box) {
    constexpr std::size_t longest = 200;
    const Store* const store = machine.options.store;
    const bool kept = box.content != nullptr && !(*box.content)->forgotten;
    if (store == nullptr || (!kept && !store->has(box.table)))
        return "(a table that is not in the store)";
    std::string text;
    std::int64_t next = 1;
    for (const auto& [key, entry] : entries_of(*store, box)) {
        if (text.size() > longest) {
            text += ", ...";
            break;
        }
        if (!text.empty()) text += ", ";
        if (const auto* const name = std::get_if<std::string>(&key))
            text +=
                (property::is_identifier(*name) ? *name : "[" + property::value_text(*name) + "]") +
                " = ";
        else if (std::get<std::int64_t>(key) != next++)
            text += "[" + std::to_string(std::get<std::int64_t>(key)) + "] = ";
        text += entry_text(machine, &entry);
    }
    return "{" + text + "}";
}

void open_store(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<store_index>(L, "__index");
    add_pure<effect<store_newindex>>(L, "__newindex");
    add_pure<varying<store_length>>(L, "__len");
    add_pure<store_equal>(L, "__eq");
    add_pure<release_store>(L, "__gc");
    add_pure<varying<store_tostring>>(L, "__tostring");
    add_pure<varying<store_pairs>>(L, "__pairs");
    name_metatable(L, "store");
    note_name(L, guarded<effect<store_clear>>, "clear");
    note_name(L, guarded<varying<store_has>>, "has");
    note_name(L, guarded<varying<store_pairs>>, "pairs");
    note_name(L, guarded<varying<store_tostring>>, "tostring");
    machine.boxes.store = luaL_ref(L, LUA_REGISTRYINDEX);
    push_table(L, Store::root, nullptr);
    machine.globals.store = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
