#include "runtime_part.h"

#include <algorithm>

#include "machine.h"
#include "script_classes.h"
#include "subscriptions.h"

namespace fettle::script {

using property::Handle;

namespace {

struct Image {
    Timers::Queue timers;
};

struct Changes {
    Random::State random;
    double now = 0;
    Timers::Changes timers;
    std::vector<Handle> adopted;
};

}  // namespace

property::Memory RuntimePart::save(property::ByteWriter& to) const {
    for (const std::uint64_t word : machine_.random.state()) to.put(word);
    to.put(machine_.now);
    to.put(machine_.unplaced);
    to.put(std::uint64_t{machine_.unplaced_limit});
    machine_.classes->save(to);
    return std::make_shared<const Image>(Image{machine_.timers.image()});
}

std::function<void()> RuntimePart::restore(property::ByteReader& from,
                                           const property::Memory& memory) {
    Random::State random{};
    for (std::uint64_t& word : random) word = from.get<std::uint64_t>();
    // The generator would stay at nothing but zeros.
    from.require(std::any_of(random.begin(), random.end(), [](auto word) { return word != 0; }),
                 "random numbers that are none");
    const auto now = from.get<double>();
    from.require(now >= 0 && now < 1e15, "a time that is none");
    const auto unplaced = from.list<Handle>();
    const auto limit = from.get<std::uint64_t>();
    const std::function<void()> put_classes = machine_.classes->restore(from);
    return [this, random, now, unplaced, limit, put_classes, memory] {
        static const Image nothing;
        const Image& image = memory ? *static_cast<const Image*>(memory.get()) : nothing;
        machine_.random.restore(random);
        machine_.timers.restore(image.timers, now - machine_.now);
        machine_.now = now;
        machine_.unplaced = unplaced;
        machine_.unplaced_limit = std::clamp<std::size_t>(limit, 64, 2 * unplaced.size() + 64);
        put_classes();
        refresh_classes(machine_);
    };
}

property::Memory RuntimePart::changes() {
    auto changes = std::make_shared<Changes>();
    changes->random = machine_.random.state();
    changes->now = machine_.now;
    changes->timers = machine_.timers.take_changes();
    changes->adopted = machine_.classes->take_adopted();
    return changes;
}

void RuntimePart::redo(const property::Memory& memory) {
    const auto& changes = *static_cast<const Changes*>(memory.get());
    machine_.random.restore(changes.random);
    machine_.now = changes.now;
    machine_.timers.redo(changes.timers);
    machine_.classes->redo_adopted(changes.adopted);
}

// --- Members of classes

void ScriptClasses::save(property::ByteWriter& to) const {
    to.put(members_);
    to.put(std::uint64_t{waiting_.size()});
    for (const Waiting& waiting : waiting_) {
        to.put(waiting.instance);
        to.put(std::uint8_t{waiting.announce});
    }
}

std::function<void()> ScriptClasses::restore(property::ByteReader& from) {
    const auto members = from.list<Handle>();
    std::vector<Waiting> waiting;
    for (std::size_t n = from.count(9); n > 0; --n) {
        const auto instance = from.get<Handle>();
        waiting.push_back({instance, from.boolean()});
    }
    return [this, members, waiting] {
        members_ = members;
        waiting_ = waiting;
        looked_at_ = {};
        known_.clear();
        for (const Handle member : members_)
            known_.insert(std::uint64_t{member.generation} << 32 | member.index);
        adopted_.clear();
    };
}

std::vector<Handle> ScriptClasses::take_adopted() {
    noting_ = true;
    return std::exchange(adopted_, {});
}

void ScriptClasses::redo_adopted(const std::vector<Handle>& adopted) {
    for (const Handle instance : adopted) {
        if (!known_.insert(std::uint64_t{instance.generation} << 32 | instance.index).second)
            continue;
        members_.push_back(instance);
        // Whoever hangs somewhere by now was told so then.
        if (machine_.tree.alive(instance) &&
            !machine_.tree.is_below(instance, machine_.tree.root()))
            waiting_.push_back({instance, true});
    }
    looked_at_ = {};
}

}  // namespace fettle::script
