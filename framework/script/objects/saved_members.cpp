// The part of the scripts' classes in a snapshot: the order in which instances are stepped, and the
// instances that are not ready yet.

#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/script_classes.h>
#include <values/values.h>

namespace fettle::script {

void ScriptClasses::save(property::ByteWriter& to) const {
    to.put(members_);
    to.put(std::uint64_t{waiting_.size()});
    for (const Waiting& waiting : waiting_) {
        to.put(waiting.instance);
        to.put(std::uint8_t{waiting.announce});
    }
}

std::function<void()> ScriptClasses::restore(property::ByteReader& from) {
    std::vector<Handle> members = from.list<Handle>();
    std::unordered_set<std::uint64_t> known;
    for (const Handle member : members)
        from.require(known.insert(bits_of(member)).second, "an instance that is stepped twice");
    std::vector<Waiting> waiting;
    for (std::size_t n = from.count(9); n > 0; --n) {
        const auto instance = from.get<Handle>();
        waiting.push_back({instance, from.boolean()});
    }
    return [this, members = std::move(members), waiting = std::move(waiting),
            known = std::move(known)] {
        members_ = members;
        waiting_ = waiting;
        known_ = known;
        last_check_ = {};
        adopted_.clear();
    };
}

std::vector<Handle> ScriptClasses::take_adopted() {
    noting_ = true;
    return std::exchange(adopted_, {});
}

void ScriptClasses::redo_adopted(const std::vector<Handle>& adopted) {
    for (const Handle instance : adopted) {
        if (!known_.insert(bits_of(instance)).second) continue;
        members_.push_back(instance);
        // `ready` of a placed instance was called when this step was first made.
        if (machine_.tree.alive(instance) &&
            !machine_.tree.is_below(instance, machine_.tree.root()))
            waiting_.push_back({instance, true});
    }
    last_check_ = {};
}

}  // namespace fettle::script
