// The part of the scripts' classes in a snapshot: the order in which instances are stepped, and the
// instances that are not ready yet.

#include <classes/script_classes.h>
#include <lua/machine.h>
#include <lua/stack.h>
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
        from.require(known.insert(member.key()).second, "an instance that is stepped twice");
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
        changes_ = {};
    };
}

std::size_t ScriptClasses::Changes::bytes() const {
    return (adopted.capacity() + ready.capacity()) * sizeof(Handle) +
           waiting.capacity() * sizeof(Waiting);
}

ScriptClasses::Changes ScriptClasses::take_changes() {
    noting_ = true;
    return std::exchange(changes_, {});
}

void ScriptClasses::redo(const Changes& changes) {
    for (const Handle instance : changes.adopted)
        if (known_.insert(instance.key()).second) members_.push_back(instance);
    waiting_.insert(waiting_.end(), changes.waiting.begin(), changes.waiting.end());
    std::unordered_set<std::uint64_t> ready;
    for (const Handle instance : changes.ready) ready.insert(instance.key());
    if (!ready.empty())
        std::erase_if(waiting_,
                      [&](const Waiting& each) { return ready.contains(each.instance.key()); });
    last_check_ = {};
}

}  // namespace fettle::script
