// Timers in snapshots, saved games and the timeline.

#include <algorithm>
#include <utility>

#include <calls/function_ref.h>
#include <handlers/timers.h>
#include <lua/guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>

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
    queue_ = image;
    std::erase_if(queue_, [&](const auto& each) { return retired_.contains(each.first.second); });
    queue_.merge(after_reload);
    due_.clear();
    for (const auto& [key, timer] : queue_) due_.emplace(key.second, key.first);
    changes_ = {.all = noting_, .queue = {}, .list = {}};
    now = parked_until_ = to;
    parked_from_ = next;
}

void Timers::restore_from_file(double to) {
    Queue image;
    for (const auto& [key, timer] : queue_)
        if (timer.function && timer.top && !ended(timer))
            image.emplace(Key{key.first - now + to, key.second}, timer);
    restore(image, to, next_id_);
}

Timers::Ending Timers::ending() const {
    constexpr std::size_t most_places = 3, most_looked_at = 100;
    Ending found;
    for (const auto& [key, timer] : queue_) {
        if (!timer.function || timer.top || ended(timer)) continue;
        if (++found.count > most_looked_at || found.places.size() >= most_places) continue;
        std::string place = timer.function->given_at();
        if (place.empty() && lua_checkstack(machine_.lua.main, 2) != 0) {
            timer.function->push(machine_.lua.main);
            place = definition(machine_.lua.main);
            lua_pop(machine_.lua.main, 1);
            if (place.ends_with(": ")) place.resize(place.size() - 2);
        }
        if (std::ranges::find(found.places, place) == found.places.end())
            found.places.push_back(std::move(place));
    }
    return found;
}

void Timers::park() {
    for (auto entry = queue_.begin(); entry != queue_.end();) {
        const auto here = entry++;
        if (here->second.function) continue;
        parked_.push_back({here->first.first - now, here->first.second, here->second});
        queue_.erase(here);
    }
}

void Timers::unpark() {
    for (Parked& parked : std::exchange(parked_, {})) {
        if (parked.timer.begun < parked_from_) {
            const Key key{parked_until_ + parked.rest, parked.id};
            due_[key.second] = key.first;
            queue_.emplace(key, std::move(parked.timer));
        } else {
            machine_.tree.add_weight(-weight_of_timer);
            forget(parked.timer);
        }
    }
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
