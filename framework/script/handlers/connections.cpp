#include <algorithm>

#include <handlers/connections.h>
#include <handlers/timers.h>
#include <lua/guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/values.h>

namespace fettle::script {

using property::Connection;

namespace {

enum class Source : std::uint8_t { tree, timer };

struct ConnectionBox {
    Tag tag;
    Source source;
    std::uint64_t id;
};

void push_connection(lua_State* L, Source source, std::uint64_t id) {
    auto* box = static_cast<ConnectionBox*>(lua_newuserdatauv(L, sizeof(ConnectionBox), 0));
    *box = {Tag::connection, source, id};
    push_registry(L, machine_of(L).boxes.connection);
    lua_setmetatable(L, -2);
}

ConnectionBox& connection_at(lua_State* L, const char* what) {
    auto* box = box_at<ConnectionBox>(L, 1, Tag::connection);
    if (!box)
        throw Error(ErrorKind::wrong_type, std::string(what) + ": needs a connection, not " +
                                               describe_type(L, 1) + "; call it with a colon");
    return *box;
}

int connection_stop(lua_State* L) {
    const ConnectionBox& box = connection_at(L, "stop");
    Machine& machine = machine_of(L);
    if (box.source == Source::tree)
        machine.connections.stop(box.id);
    else
        machine.timers.stop(box.id);
    return 0;
}

int connection_active(lua_State* L) {
    const ConnectionBox& box = connection_at(L, "active");
    Machine& machine = machine_of(L);
    lua_pushboolean(L, box.source == Source::tree ? machine.connections.active(box.id)
                                                  : machine.timers.active(box.id));
    return 1;
}

int connection_index(lua_State* L) {
    return push_method(L, "a connection");
}

}  // namespace

void push_timer_connection(lua_State* L, std::uint64_t timer) {
    push_connection(L, Source::timer, timer);
}

Connections::~Connections() {
    clear();
}

void Connections::clear() {
    for (auto& [id, connection] : connections_) connection.stop();
    connections_.clear();
    noted_.clear();
}

std::uint64_t Connections::insert(Connection connection) {
    if (connections_.size() >= prune_at_) {
        std::erase_if(connections_, [](const auto& entry) { return !entry.second.active(); });
        prune_at_ = std::max<std::size_t>(256, 2 * connections_.size());
    }
    connections_.emplace(next_id_, std::move(connection));
    return next_id_++;
}

void Connections::push(lua_State* L, Connection connection) {
    const std::uint64_t id = insert(std::move(connection));
    note({.id = id, .instance = {}});
    push_connection(L, Source::tree, id);
}

void Connections::push(lua_State* L, property::Handle instance,
                       const std::function<Connection(property::Handle)>& connect) {
    const std::uint64_t id = insert(connect(instance));
    note({.id = id, .instance = instance, .connect = connect});
    push_connection(L, Source::tree, id);
}

std::vector<Connections::Noted> Connections::end_noting() {
    noting_ = false;
    return std::exchange(noted_, {});
}

void Connections::connect_again(const Noted& noted, property::Handle instance) {
    const auto found = connections_.find(noted.id);
    if (found == connections_.end()) return;  // the script has stopped it
    found->second.stop();
    found->second = noted.connect(instance);
}

void Connections::keep(Connection connection) {
    insert(std::move(connection));
}

void Connections::stop(std::uint64_t id) {
    const auto found = connections_.find(id);
    if (found == connections_.end()) return;
    found->second.stop();
    connections_.erase(found);
}

bool Connections::active(std::uint64_t id) const {
    const auto found = connections_.find(id);
    return found != connections_.end() && found->second.active();
}

void open_connections(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<connection_index>(L, "__index");
    lua_newtable(L);
    add_function<connection_stop>(L, "stop");
    add_pure<connection_active>(L, "active");
    lua_setfield(L, -2, "methods");
    name_metatable(L, "connection");
    machine.boxes.connection = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
