// Timers in snapshots, saved games and the timeline.

#include <algorithm>
#include <utility>

#include <calls/function_ref.h>
#include <handlers/timers.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>

namespace fettle::script {

Timers::Queue Timers::image() const {
    Queue functions;
    for (const auto& [key, timer] : queue_)
        if (timer.function) functions.emplace_hint(functions.end(), key, timer);
    return functions;
}

void Timers::restore(const Queue& image, double to, std::uint64_t next) {
    park();
    // A timer that a reload began after the restored step replaces one of the old code: it
    // continues for the rest of its time.
    Queue after_reload;
    for (const auto& [key, timer] : queue_)
        if (timer.top && key.second >= next && !ended(timer))
            after_reload.emplace(Key{key.first - now + to, key.second}, timer);
    const std::size_t before = queue_.size();
    queue_ = image;
    std::erase_if(queue_, [&](const auto& each) { return retired_.contains(each.first.second); });
    queue_.merge(after_reload);
    machine_.tree.add_weight(weight_of_timer * (static_cast<std::int64_t>(queue_.size()) -
                                                static_cast<std::int64_t>(before)));
    due_.clear();
    for (const auto& [key, timer] : queue_) due_.emplace(key.second, key.first);
    changes_ = {.all = noting_, .queue = {}, .list = {}};
    now = parked_until_ = to;
    parked_from_ = next;
    from_file_ = false;
    returned_ = true;
}

void Timers::restore_from_file(double to) {
    Queue image;
    for (const auto& [key, timer] : queue_)
        if (timer.function && timer.top && !ended(timer))
            image.emplace(Key{key.first - now + to, key.second}, timer);
    restore(image, to, next_id_);
    from_file_ = true;
}

std::string Timers::place_of(const Timer& timer) const {
    lua_State* const L = machine_.lua.main;
    if (lua_checkstack(L, 2) == 0) return {};
    if (timer.function) {
        if (std::string place = timer.function->given_at(); !place.empty()) return place;
        timer.function->push(L);
    } else {
        // The function that the coroutine runs is the outermost one.
        push_registry(L, timer.thread);
        lua_State* const thread = lua_tothread(L, -1);
        lua_pop(L, 1);
        lua_Debug frame;
        int level = 0;
        while (lua_getstack(thread, level, &frame) != 0) ++level;
        if (level == 0 || lua_checkstack(thread, 1) == 0) return {};
        lua_getstack(thread, level - 1, &frame);
        lua_getinfo(thread, "f", &frame);
        lua_xmove(thread, L, 1);
    }
    std::string place = definition(L);
    lua_pop(L, 1);
    if (place.ends_with(": ")) place.resize(place.size() - 2);
    return place;
}

void Timers::add_place(Places& to, std::string place) const {
    constexpr std::size_t most_places = 3;
    if (place.empty() || to.places.size() >= most_places) return;
    if (std::ranges::find(to.places, place) == to.places.end())
        to.places.push_back(std::move(place));
}

namespace {
constexpr std::uint64_t most_looked_at = 100;
}  // namespace

std::string Timers::Places::listed() const {
    std::string text;
    for (const std::string& place : places) text += (text.empty() ? "" : ", ") + place;
    return text;
}

Timers::Places Timers::ending(const std::unordered_set<std::uint64_t>& stay) const {
    Places found;
    for (const auto& [key, timer] : queue_)
        if (timer.function && !timer.top && !ended(timer) && !stay.contains(key.second) &&
            ++found.count <= most_looked_at)
            add_place(found, place_of(timer));
    return found;
}

Timers::Places Timers::coroutines() const {
    Places found;
    const auto look = [&](const Timer& timer) {
        if (!timer.function && !timer.top && !ended(timer) && ++found.count <= most_looked_at)
            add_place(found, place_of(timer));
    };
    for (const auto& [key, timer] : queue_) look(timer);
    for (const Parked& each : parked_) look(each.timer);
    return found;
}

void Timers::park() {
    for (auto entry = queue_.begin(); entry != queue_.end();) {
        const auto here = entry++;
        if (here->second.function) continue;
        parked_.push_back(
            {here->first.first, here->first.first - now, here->first.second, here->second});
        queue_.erase(here);
    }
}

void Timers::unpark() {
    if (!std::exchange(returned_, false)) return;
    Places running;
    for (Parked& parked : std::exchange(parked_, {})) {
        if (parked.timer.begun < parked_from_) {
            const bool has_run = parked.id >= parked_from_;  // it waits for another time
            if (has_run && !ended(parked.timer) && ++running.count <= most_looked_at)
                add_place(running, place_of(parked.timer));
            const bool keeps_rest = has_run || from_file_;
            const Key key{keeps_rest ? parked_until_ + parked.rest : parked.due, parked.id};
            due_[key.second] = key.first;
            queue_.emplace(key, std::move(parked.timer));
        } else {
            machine_.tree.add_weight(-weight_of_timer);
            forget(parked.timer);
        }
    }
    const auto gone = std::ranges::count_if(ended_, [&](const Ended& each) {
        return each.begun < parked_from_ && each.at > parked_until_ + tolerance;
    });
    tell_of_coroutines(running, static_cast<std::uint64_t>(gone));
}

void Timers::tell_of_coroutines(const Places& running, std::uint64_t ended) {
    if (told_ || (running.count == 0 && ended == 0)) return;
    told_ = true;
    std::string text = "coroutines do not go back in time";
    if (running.count > 0) {
        text += ": " + std::to_string(running.count) +
                (running.count == 1 ? " goes on where it was" : " go on where they were");
        if (!running.places.empty()) text += " (" + running.listed() + ")";
    }
    if (ended > 0)
        text += (running.count > 0 ? ", and " : ": ") + std::to_string(ended) +
                (ended == 1 ? " that has ended since does not run again"
                            : " that have ended since do not run again");
    // A copy, because the call may replace it.
    if (const auto sink = machine_.host.on_note)
        sink(text + "; what must go back belongs to a step, a state, a timer or a tween");
}

namespace {
// Size of a map node with an estimate of the allocator's overhead.
constexpr std::size_t timer_size = sizeof(Timers::Queue::value_type) + 48;
}  // namespace

std::size_t Timers::bytes_of(const Queue& image) {
    return image.size() * timer_size;
}

std::size_t Timers::bytes_of(const Changes& changes) {
    std::size_t sum = bytes_of(changes.queue) + changes.list.capacity() * sizeof(Change);
    for (const Change& change : changes.list)
        if (change.added) sum += change.added->function->holds();
    return sum;
}

Timers::Changes Timers::take_changes() {
    Changes taken = std::exchange(changes_, {});
    if (taken.all || !noting_) {
        taken.all = true;
        taken.queue = image();
    }
    noting_ = true;
    taken.next = next_id_;
    return taken;
}

void Timers::redo(const Changes& changes, double to) {
    if (changes.all) return restore(changes.queue, to, changes.next);
    now = parked_until_ = to;
    parked_from_ = changes.next;
    from_file_ = false;
    returned_ = true;
    for (const Change& change : changes.list) {
        if (!change.added) {
            if (const auto entry = queue_.find(change.key); entry != queue_.end()) erase(entry);
            continue;
        }
        if (retired_.contains(change.key.second)) continue;
        // A timer of a reload was continued in the state of an earlier step, in which it had not
        // begun.
        if (const auto early = due_.find(change.key.second); early != due_.end())
            erase(queue_.find(Key{early->second, early->first}));
        insert(change.key, *change.added);
    }
}

}  // namespace fettle::script
