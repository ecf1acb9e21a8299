#include <algorithm>
#include <iterator>

#include <classes/script_classes.h>
#include <classes/unplaced_instances.h>
#include <handlers/connections.h>
#include <library/globals.h>
#include <library/time_functions.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <runtime/method_timers.h>
#include <runtime/runtime_part.h>
#include <sandbox/random.h>
#include <values/values.h>

namespace fettle::script {

namespace {

/// Base of all memory images; it contains their size.
struct Held {
    std::size_t bytes = 0;
};

struct Image : Held {
    Timers::Queue timers;
    std::uint64_t next_timer = 0;
    Connections::Image connections;
};

struct Changes : Held {
    Random::State random;
    double now = 0;
    Timers::Changes timers;
    Connections::Changes connections;
    ScriptClasses::Changes classes;
    UnplacedInstances::Changes unplaced;
};

}  // namespace

namespace {

void put(const Timers::Places& all, property::ByteWriter& to) {
    to.put(all.count);
    to.put(static_cast<std::uint64_t>(all.places.size()));
    for (const std::string& place : all.places) to.put(place);
}

Timers::Places places_of(property::ByteReader& from) {
    Timers::Places all{.count = from.get<std::uint64_t>()};
    for (std::size_t n = from.count(4); n > 0; --n) all.places.emplace_back(from.text());
    return all;
}

std::string counted(const Timers::Places& all, const char* what) {
    return std::to_string(all.count) + " " + what + (all.count == 1 ? "" : "s");
}

std::string after_colon(const Timers::Places& all) {
    return all.places.empty() ? std::string() : ": " + all.listed();
}

}  // namespace

property::Memory RuntimePart::save(property::ByteWriter& to) const {
    for (const std::uint64_t word : machine_.random.state()) to.put(word);
    to.put(machine_.timers.now);
    to.put(machine_.unplaced.handles);
    to.put(std::uint64_t{machine_.unplaced.limit});
    machine_.classes.save(to);
    const std::vector<Handle> with_handlers = machine_.connections.instances();
    std::unordered_set<std::uint64_t> stay;
    auto image = std::make_shared<Image>();
    image->timers = machine_.timers.image();
    const std::vector<MethodTimer> of_methods = method_timers(machine_, image->timers, stay);
    const Timers::Places timers = machine_.timers.ending(stay);
    const Timers::Places coroutines = machine_.timers.coroutines();
    const bool any = timers.count > 0 || coroutines.count > 0 || !of_methods.empty();
    if (!with_handlers.empty() || any) to.put(with_handlers);
    if (any) {
        put(timers, to);
        put(coroutines, to);
        put(of_methods, to);
    }
    image->next_timer = machine_.timers.next_number();
    image->connections = machine_.connections.image();
    image->bytes =
        sizeof *image + Timers::bytes_of(image->timers) + Connections::bytes_of(image->connections);
    return std::shared_ptr<const Held>(std::move(image));
}

std::function<void()> RuntimePart::restore(property::ByteReader& from,
                                           const property::Memory& memory) {
    Random::State random{};
    for (std::uint64_t& word : random) word = from.get<std::uint64_t>();
    // The generator would return only zeros with this state.
    from.require(std::any_of(random.begin(), random.end(), [](auto word) { return word != 0; }),
                 "an invalid state of random numbers");
    const auto now = from.get<double>();
    from.require(now >= 0 && now < 1e15, "an invalid time");
    auto unplaced = from.list<Handle>();
    // The root has no parent either, but must not be collected.
    std::erase(unplaced, machine_.tree.root());
    const auto limit = from.get<std::uint64_t>();
    const std::function<void()> put_classes = machine_.classes.restore(from);
    std::vector<Handle> had_handlers;
    if (!from.at_end()) had_handlers = from.list<Handle>();
    Timers::Places timers, coroutines;
    std::vector<MethodTimer> of_methods;
    if (!from.at_end()) {
        timers = places_of(from);
        coroutines = places_of(from);
        of_methods = method_timers_of(from);
    }
    return [this, random, now, unplaced, limit, put_classes, had_handlers, timers, coroutines,
            of_methods, memory] {
        static const Image nothing;
        const Image& image =
            memory ? *static_cast<const Image*>(static_cast<const Held*>(memory.get())) : nothing;
        ++machine_.snapshots.restored;
        machine_.random.restore(random);
        if (memory)
            machine_.timers.restore(image.timers, now, image.next_timer);
        else
            machine_.timers.restore_from_file(now);
        // A file has no handlers: those of instances that still exist stay.
        if (memory) machine_.connections.restore(image.connections);
        had_handlers_ = memory ? std::vector<Handle>() : had_handlers;
        ended_timers_ = memory ? Timers::Places() : timers;
        coroutines_ = memory ? Timers::Places() : coroutines;
        machine_.unplaced.restore(unplaced,
                                  std::clamp<std::size_t>(limit, 64, 2 * unplaced.size() + 64));
        put_classes();
        refresh_classes(machine_);
        if (memory) return;
        for (const MethodTimer& each : of_methods)
            if (!begin_again(machine_, each)) ++ended_timers_.count;
    };
}

std::vector<std::string> RuntimePart::remarks() const {
    std::vector<std::string> all = lost_handlers();
    constexpr const char* advice =
        "; what must go on belongs to the top level, a step, a state, a tween or a method, as "
        "in self:every(1, self.fire)";
    if (ended_timers_.count > 0)
        all.push_back(counted(ended_timers_, "timer") +
                      " that the game had when it was saved ended, since a file holds no "
                      "functions" +
                      after_colon(ended_timers_) + advice);
    if (coroutines_.count > 0)
        all.push_back(counted(coroutines_, "coroutine") +
                      " that waited when the game was saved did not go back, since a file holds no "
                      "functions; what has begun in this run goes on where it was" +
                      after_colon(coroutines_) + advice);
    std::ranges::move(stated_problems(machine_), std::back_inserter(all));
    return all;
}

std::vector<std::string> RuntimePart::lost_handlers() const {
    std::vector<Handle> lost;
    const std::vector<Handle> have = machine_.connections.instances();
    for (const Handle each : had_handlers_)
        if (machine_.tree.alive(each) &&
            !std::ranges::binary_search(have, each, Connections::before))
            lost.push_back(each);
    if (lost.empty()) return {};
    std::string text = machine_.tree.path(lost.front());
    if (lost.size() > 1) text += " and " + std::to_string(lost.size() - 1) + " more";
    return {text + ": the functions that were given to " + (lost.size() > 1 ? "them" : "it") +
            " as handlers are gone, since a file holds no functions; methods of a class stay: "
            "class(\"Start\", Button) {} and function Start:pressed() ... end"};
}

property::Memory RuntimePart::changes() {
    auto changes = std::make_shared<Changes>();
    changes->random = machine_.random.state();
    changes->now = machine_.timers.now;
    changes->timers = machine_.timers.take_changes();
    changes->connections = machine_.connections.take_changes();
    changes->classes = machine_.classes.take_changes();
    changes->unplaced = machine_.unplaced.take_changes();
    changes->bytes = sizeof *changes + Timers::bytes_of(changes->timers) +
                     Connections::bytes_of(changes->connections) + changes->classes.bytes() +
                     changes->unplaced.handles.capacity() * sizeof(Handle);
    return std::shared_ptr<const Held>(std::move(changes));
}

std::size_t RuntimePart::size_of(const property::Memory& memory) const {
    return memory == nullptr ? 0 : static_cast<const Held*>(memory.get())->bytes;
}

void RuntimePart::redo(const property::Memory& memory) {
    const auto& changes = *static_cast<const Changes*>(static_cast<const Held*>(memory.get()));
    machine_.random.restore(changes.random);
    machine_.timers.redo(changes.timers, changes.now);
    machine_.connections.redo(changes.connections);
    machine_.classes.redo(changes.classes);
    machine_.unplaced.redo(changes.unplaced);
}

}  // namespace fettle::script
