#include <saving/rows.h>

#include <algorithm>
#include <optional>
#include <unordered_map>

#include <fettle/property/restoring.h>
#include <fettle/property/spelling.h>

namespace fettle::physics_module {
namespace {

using property::Class;

/// An object of a world: its instance and its kind.
struct Owned {
    std::uint64_t data = 0;
    std::size_t kind = 0;
    bool claimed = false;  // the row of its instance refers to this object
};
using ByRow = std::unordered_map<Row, Owned>;

class Rows {
  public:
    Rows(const Hosting& hosting, const RestoredObjects& objects)
        : hosting_(hosting), objects_(objects) {
        for (std::uint32_t number = 0; number < max_worlds; ++number) {
            physics::World* const world = objects.worlds[number];
            if (world == nullptr) continue;
            for (const physics::Body& body : world->bodies())
                bodies_[make_row(number, body.index())] = {body.user_data()};
            for (const physics::Shape& shape : world->shapes())
                shapes_[make_row(number, shape.index())] = {shape.user_data(),
                                                            static_cast<std::size_t>(shape.type())};
            for (const physics::Joint& joint : world->joints())
                joints_[make_row(number, joint.id().index)] = {
                    joint.user_data(), static_cast<std::size_t>(joint.type())};
            for (const physics::Field& field : world->fields()) {
                const physics::FieldDef def = field.definition();
                fields_[make_row(number, field.id().index)] = {def.user_data, def.force.index()};
            }
        }
    }

    bool fits(Handle self, const Class& is, Row row) {
        Seen& seen = record(self);
        if (is.is_a(*hosting_.classes.world))
            return slot_of(row) == 0 && world_number(row) != limbo &&
                   objects_.worlds[world_number(row)] != nullptr &&
                   objects_.selves[world_number(row)] == self;
        if (is.is_a(*hosting_.classes.statistics))
            return slot_of(row) == 0 && objects_.worlds[world_number(row)] != nullptr;
        if (is.is_a(*hosting_.classes.body)) {
            seen.is_body = true;
            return claim(bodies_, row, self, 0);
        }
        const auto& lifecycle = is.lifecycle();
        if (is.is_a(*hosting_.classes.shape)) {
            const auto* kind = static_cast<const ShapeKind*>(lifecycle.context);
            return is.creatable() && kind != nullptr &&
                   claim(shapes_, row, self, kind->geometry.index());
        }
        if (const auto kind = kind_of(hosting_.field_kinds, lifecycle))
            return is.creatable() && claim(fields_, row, self, *kind);
        if (const auto kind = kind_of(hosting_.joint_kinds, lifecycle))
            return is.creatable() && claim(joints_, row, self, *kind);
        return true;  // of another module
    }

    // Called after all instances.

    /// True if every object with an instance is the object of that instance's row.
    bool all_claimed() const {
        for (const ByRow* objects : {&bodies_, &shapes_, &joints_, &fields_})
            for (const auto& [row, object] : *objects)
                if (!object.claimed && find(unpack(object.data)) != nullptr) return false;
        return true;
    }

    /// True if all instances that the joint connects are bodies.
    bool ties_bodies(const Ties& ties) const {
        return std::ranges::all_of(ties.bodies, [&](Handle body) {
            const Seen* const tied = find(body);
            return tied == nullptr || tied->is_body;
        });
    }

  private:
    /// An instance in the snapshot.
    struct Seen {
        std::uint32_t generation = 0;
        bool is_body = false;
    };
    Seen& record(Handle self) {
        if (self.index >= seen_.size()) seen_.resize(self.index + 1);
        return seen_[self.index] = {.generation = self.generation};
    }
    const Seen* find(Handle handle) const {
        const bool there = handle && handle.index < seen_.size() &&
                           seen_[handle.index].generation == handle.generation;
        return there ? &seen_[handle.index] : nullptr;
    }
    static bool claim(ByRow& objects, Row row, Handle self, std::size_t kind) {
        const auto found = objects.find(row);
        if (found == objects.end() || found->second.data != pack(self) ||
            found->second.kind != kind)
            return false;
        return found->second.claimed = true;
    }
    /// The kind of a class, found by the function that creates its rows. A class of a script has
    /// the function of its base.
    static std::optional<std::size_t> kind_of(const Hosting::Kinds& kinds,
                                              const property::Lifecycle& lifecycle) {
        for (const auto& [create, kind] : kinds)
            if (create == lifecycle.create) return kind;
        return std::nullopt;
    }

    const Hosting& hosting_;
    const RestoredObjects& objects_;
    ByRow bodies_, shapes_, joints_, fields_;
    std::vector<Seen> seen_;  // by index
};

}  // namespace

void check_rows(const Hosting& hosting, const RestoredObjects& objects,
                const property::ByteReader& from) {
    Rows rows(hosting, objects);
    property::each_restored(hosting.tree, [&](Handle self, const Class& is, Row row) {
        if (!rows.fits(self, is, row))
            from.fail(property::with_article(is.name()) + " has a row that is not its own");
    });
    from.require(rows.all_claimed(), "an object whose instance has another object");
    for (const std::span<const Ties> all : objects.ties)
        for (const Ties& ties : all)
            from.require(rows.ties_bodies(ties), "a joint that ties no body");
}

}  // namespace fettle::physics_module
