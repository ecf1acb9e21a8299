#include <saving/rows.h>

#include <optional>
#include <unordered_map>
#include <utility>

#include <fettle/property/restoring.h>

namespace fettle::physics_module {
namespace {

using property::Class;

/// An object of a world: its instance and its kind.
struct Owned {
    std::uint64_t data = 0;
    std::size_t kind = 0;
    bool claimed = false;  // its instance has this object as its row
};
using ByRow = std::unordered_map<Row, Owned>;

class Rows {
  public:
    Rows(const Hosting& hosting, const RestoredObjects& objects)
        : hosting_(hosting), objects_(objects) {
        for (std::uint32_t number = 0; number < most_worlds; ++number) {
            physics::World* const world = objects.worlds[number];
            if (world == nullptr) continue;
            for (const physics::Body& body : world->bodies())
                bodies_[make_row(number, body.index())] = {body.user_data()};
            for (const physics::Shape& shape : world->shapes())
                shapes_[make_row(number, shape.index())] = {shape.user_data(),
                                                            static_cast<std::size_t>(shape.type())};
            for (const physics::Field& field : world->fields()) {
                const physics::FieldDef def = field.definition();
                fields_[make_row(number, field.id().index)] = {def.user_data, def.force.index()};
            }
        }
    }

    bool fits(Handle self, const Class& is, Row row) {
        Seen& seen = note(self, row);
        if (is.is_a(*hosting_.world_class))
            return slot_of(row) == 0 && world_number(row) != limbo &&
                   objects_.worlds[world_number(row)] != nullptr &&
                   objects_.selves[world_number(row)] == self;
        if (is.is_a(*hosting_.statistics_class))
            return slot_of(row) == 0 && objects_.worlds[world_number(row)] != nullptr;
        if (is.is_a(*hosting_.body_class)) {
            seen.is_body = true;
            return is_whose(bodies_, row, self, 0);
        }
        const auto& lifecycle = is.lifecycle();
        if (is.is_a(*hosting_.shape_class)) {
            const auto* kind = static_cast<const ShapeKind*>(lifecycle.context);
            return is.creatable() && kind != nullptr &&
                   is_whose(shapes_, row, self, kind->geometry.index());
        }
        if (const auto kind = kind_of(hosting_.field_kinds, lifecycle))
            return is.creatable() && is_whose(fields_, row, self, *kind);
        if (const auto kind = kind_of(hosting_.joint_kinds, lifecycle)) {
            const std::vector<JointRecord>& joints = *objects_.joints;
            seen.is_joint = true;
            return is.creatable() && row < joints.size() && joints[row].used &&
                   joints[row].self == self && joints[row].settings.index() == *kind;
        }
        return true;  // of another module
    }

    // Called after all instances.

    /// True if every object with an instance is the row of that instance, and of its kind.
    bool all_claimed() const {
        for (const ByRow* objects : {&bodies_, &shapes_, &fields_})
            for (const auto& [row, object] : *objects)
                if (!object.claimed && find(unpack(object.data)) != nullptr) return false;
        return true;
    }

    /// Checks that a joint in use can be created and destroyed.
    void check(const JointRecord& joint, const property::ByteReader& from) const {
        physics::World* const world = objects_.worlds[joint.world];
        from.require(world != nullptr, "a joint in a world that is none");
        const Seen* const self = find(joint.self);
        from.require(self == nullptr || has(*self, joint), "a joint that is not its own");
        for (const Handle body : joint.bodies) {
            const Seen* const tied = find(body);
            from.require(tied == nullptr || tied->is_body, "a joint that ties no body");
        }
        if (!world->is_valid(joint.native)) return;
        const auto acts_as = static_cast<std::size_t>(world->joint(joint.native).type());
        from.require(acts_as == joint.settings.index(), "a joint that acts as another type");
    }

    /// Checks that the joint of the tree that a native joint names has this native joint, or is
    /// deleted.
    void check(std::uint32_t number, const physics::Joint& native,
               const property::ByteReader& from) const {
        const Seen* const self = find(unpack(native.user_data()));
        if (self == nullptr) return;
        from.require(self->is_joint, "a joint that is not its own");
        const JointRecord& joint = (*objects_.joints)[self->row];
        from.require(joint.world == number && joint.native == native.id(),
                     "a joint that is not its own");
    }

  private:
    /// An instance that the snapshot will restore.
    struct Seen {
        std::uint32_t generation = 0;
        Row row = 0;
        bool is_body = false, is_joint = false;
    };
    Seen& note(Handle self, Row row) {
        if (self.index >= seen_.size()) seen_.resize(self.index + 1);
        return seen_[self.index] = {.generation = self.generation, .row = row};
    }
    const Seen* find(Handle handle) const {
        const bool there = handle && handle.index < seen_.size() &&
                           seen_[handle.index].generation == handle.generation;
        return there ? &seen_[handle.index] : nullptr;
    }
    bool has(const Seen& self, const JointRecord& joint) const {
        return self.is_joint && &(*objects_.joints)[self.row] == &joint;
    }
    static bool is_whose(ByRow& objects, Row row, Handle self, std::size_t kind) {
        const auto found = objects.find(row);
        if (found == objects.end() || found->second.data != pack(self) ||
            found->second.kind != kind)
            return false;
        return found->second.claimed = true;
    }
    /// The kind of a class, from the function that creates its instances: a class of a script has
    /// that of its base.
    static std::optional<std::size_t> kind_of(const Hosting::Kinds& kinds,
                                              const property::Lifecycle& lifecycle) {
        for (const auto& [create, kind] : kinds)
            if (create == lifecycle.create) return kind;
        return std::nullopt;
    }

    const Hosting& hosting_;
    const RestoredObjects& objects_;
    ByRow bodies_, shapes_, fields_;
    std::vector<Seen> seen_;  // by index
};

}  // namespace

void check_rows(const Hosting& hosting, const RestoredObjects& objects,
                const property::ByteReader& from) {
    Rows rows(hosting, objects);
    property::each_restored(hosting.tree, [&](Handle self, const Class& is, Row row) {
        if (!rows.fits(self, is, row))
            from.fail("a " + is.name() + " has a row that is not its own");
    });
    from.require(rows.all_claimed(), "an object of an instance that has another");
    for (const JointRecord& joint : *objects.joints)
        if (joint.used) rows.check(joint, from);
    for (std::uint32_t number = 0; number < most_worlds; ++number) {
        if (objects.worlds[number] == nullptr) continue;
        for (const physics::Joint& native : objects.worlds[number]->joints())
            rows.check(number, native, from);
    }
}

}  // namespace fettle::physics_module
