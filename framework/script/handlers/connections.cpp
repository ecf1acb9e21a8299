#include <algorithm>
#include <utility>

#include <calls/function_ref.h>
#include <handlers/connections.h>
#include <handlers/timers.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/recording.h>
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
    if (!box) refuse_argument(L, 1, what, "a connection");
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
    for (auto& [id, entry] : connections_) entry.connection.stop();
    connections_.clear();
    noted_.clear();
    retired_.clear();
    reported_mistakes_.clear();
    changes_ = {.all = recording_};
}

std::uint64_t Connections::insert(Entry entry) {
    if (connections_.size() >= prune_at_) {
        std::erase_if(connections_,
                      [](const auto& each) { return !each.second.connection.active(); });
        prune_at_ = std::max<std::size_t>(256, 2 * connections_.size());
    }
    connections_.emplace(next_id_, std::move(entry));
    return next_id_++;
}

void Connections::push(lua_State* L, property::Handle instance, Subscription subscription) {
    Entry entry{.connection = subscription.connect(instance, subscription.function),
                .instance = instance,
                .scene = machine_.globals.entering,
                .function = subscription.function,
                .always = noting_};
    // A handler that a person connects in the console is in no snapshot.
    if (machine_.recording.writer == property::Writer::script)
        entry.connect =
            std::make_shared<const Subscription::Connect>(std::move(subscription.connect));
    const std::uint64_t id = insert(std::move(entry));
    if (noting_) noted_.push_back({.id = id, .instance = instance});
    const Entry& made = connections_.at(id);
    if (made.connect != nullptr) note({.id = id, .added = made_of(id, made)});
    push_connection(L, Source::tree, id);
}

std::vector<Connections::Noted> Connections::end_noting() {
    noting_ = false;
    return std::exchange(noted_, {});
}

void Connections::reconnect(const Noted& noted, property::Handle instance) {
    const auto found = connections_.find(noted.id);
    if (found == connections_.end()) return;  // the script has stopped it
    Entry& entry = found->second;
    const auto function = entry.function.lock();
    if (function == nullptr || entry.connect == nullptr) return;
    entry.connection.stop();
    entry.connection = (*entry.connect)(instance, function);
    entry.instance = instance;
    note({.id = noted.id, .added = made_of(noted.id, entry)});
}

void Connections::keep(Connection connection) {
    insert({.connection = std::move(connection)});
}

void Connections::stop(std::uint64_t id) {
    const auto found = connections_.find(id);
    if (found == connections_.end()) return;
    found->second.connection.stop();
    connections_.erase(found);
    note({.id = id});
}

void Connections::retire(std::uint64_t id) {
    stop(id);
    retired_.insert(id);
}

bool Connections::active(std::uint64_t id) const {
    const auto found = connections_.find(id);
    return found != connections_.end() && found->second.connection.active();
}

void Connections::end_with_scenes() {
    std::vector<std::uint64_t> over;
    for (const auto& [id, entry] : connections_)
        if (entry.scene && !machine_.tree.alive(entry.scene)) over.push_back(id);
    for (const std::uint64_t id : over) stop(id);
}

// --- Snapshots

Connections::Made Connections::made_of(std::uint64_t id, const Entry& entry) {
    return {.id = id,
            .instance = entry.instance,
            .scene = entry.scene,
            .function = entry.function.lock(),
            .connect = entry.connect};
}

void Connections::note(Change change) {
    if (!recording_ || changes_.all) return;
    changes_.list.push_back(std::move(change));
    if (changes_.list.size() > 64 + 2 * connections_.size()) changes_ = {.all = true};
}

Connections::Image Connections::image() const {
    Image image;
    for (const auto& [id, entry] : connections_) {
        if (entry.connect == nullptr || !entry.connection.active()) continue;
        Made made = made_of(id, entry);
        if (made.function != nullptr) image.push_back(std::move(made));
    }
    std::ranges::sort(image, {}, &Made::id);
    return image;
}

std::vector<property::Handle> Connections::instances() const {
    std::vector<property::Handle> found;
    for (const auto& [id, entry] : connections_)
        if (entry.connect != nullptr && entry.instance && entry.connection.active())
            found.push_back(entry.instance);
    std::ranges::sort(found, before);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool Connections::can_connect(const Made& made) const {
    return made.function != nullptr && !retired_.contains(made.id) &&
           (!made.instance || machine_.tree.alive(made.instance)) &&
           (!made.scene || machine_.tree.alive(made.scene));
}

/// Must not throw: a property that is watched may be missing in another state.
void Connections::connect(const Made& made) {
    Entry& entry = connections_[made.id];
    entry.connection.stop();
    entry.instance = made.instance;
    entry.scene = made.scene;
    entry.function = made.function;
    entry.connect = made.connect;
    try {
        entry.connection = (*made.connect)(made.instance, made.function);
    } catch (const std::exception&) {
        connections_.erase(made.id);
    }
}

void Connections::restore(const Image& image) {
    std::unordered_set<std::uint64_t> wanted;
    for (const Made& made : image) wanted.insert(made.id);
    for (auto each = connections_.begin(); each != connections_.end();) {
        Entry& entry = each->second;
        if (entry.connect == nullptr || entry.always || wanted.contains(each->first)) {
            ++each;
            continue;
        }
        entry.connection.stop();
        each = connections_.erase(each);
    }
    // Handlers are called in the order in which they were connected, so where one is missing, all
    // of that instance are connected again.
    std::unordered_set<std::uint64_t> incomplete;
    for (const Made& made : image)
        if (!active(made.id) && can_connect(made)) incomplete.insert(made.instance.key());
    if (!incomplete.empty())
        for (const Made& made : image)
            if (incomplete.contains(made.instance.key()) && can_connect(made)) connect(made);
    changes_ = {.all = recording_};
}

Connections::Changes Connections::take_changes() {
    Changes taken = std::exchange(changes_, {});
    if (taken.all || !recording_) taken = {.all = true, .image = image()};
    recording_ = true;
    return taken;
}

void Connections::redo(const Changes& changes) {
    if (changes.all) return restore(changes.image);
    for (const Change& change : changes.list) {
        if (!change.added)
            stop(change.id);
        else if (!active(change.id) && can_connect(*change.added))
            connect(*change.added);
    }
}

std::size_t Connections::bytes_of(const Image& image) {
    return image.capacity() * sizeof(Made);
}

std::size_t Connections::bytes_of(const Changes& changes) {
    std::size_t sum = bytes_of(changes.image) + changes.list.capacity() * sizeof(Change);
    for (const Change& change : changes.list)
        if (change.added && change.added->function)
            sum += change.added->function->holds() + sizeof(Subscription::Connect) + 128;
    return sum;
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
