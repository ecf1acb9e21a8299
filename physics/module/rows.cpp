#include "rows.h"

#include <optional>
#include <unordered_map>
#include <utility>

#include <fettle/property/restoring.h>

namespace fettle::physics_module {
namespace {

using property::Class;

/// An object of a world: whose it is, and of which kind.
struct Owned {
    std::uint64_t data = 0;
    std::size_t kind = 0;
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

    bool fits(Handle self, const Class& is, Row row) const {
        if (is.is_a(*hosting_.world_class))
            return slot_of(row) == 0 && world_number(row) != limbo &&
                   objects_.worlds[world_number(row)] != nullptr &&
                   objects_.selves[world_number(row)] == self;
        if (is.is_a(*hosting_.statistics_class))
            return slot_of(row) == 0 && objects_.worlds[world_number(row)] != nullptr;
        if (is.is_a(*hosting_.body_class)) return is_whose(bodies_, row, self, 0);
        const auto& lifecycle = is.lifecycle();
        if (is.is_a(*hosting_.shape_class)) {
            const auto* kind = static_cast<const ShapeKind*>(lifecycle.context);
            return kind != nullptr && is_whose(shapes_, row, self, kind->geometry.index());
        }
        if (const auto kind = kind_of(hosting_.field_kinds, lifecycle))
            return is_whose(fields_, row, self, *kind);
        if (const auto kind = kind_of(hosting_.joint_kinds, lifecycle)) {
            const std::vector<JointRecord>& joints = *objects_.joints;
            return row < joints.size() && joints[row].used && joints[row].self == self &&
                   joints[row].settings.index() == *kind;
        }
        return true;  // of another module
    }

  private:
    static bool is_whose(const ByRow& objects, Row row, Handle self, std::size_t kind) {
        const auto found = objects.find(row);
        return found != objects.end() && found->second.data == pack(self) &&
               found->second.kind == kind;
    }
    /// By what makes them: classes of scripts have that of their base.
    static std::optional<std::size_t> kind_of(const Hosting::Kinds& kinds,
                                              const property::Lifecycle& lifecycle) {
        for (const auto& [create, kind] : kinds)
            if (create == lifecycle.create) return kind;
        return std::nullopt;
    }

    const Hosting& hosting_;
    const RestoredObjects& objects_;
    ByRow bodies_, shapes_, fields_;
};

}  // namespace

void check_rows(const Hosting& hosting, const RestoredObjects& objects,
                const property::ByteReader& from) {
    const Rows rows(hosting, objects);
    property::each_restored(hosting.tree, [&](Handle self, const Class& is, Row row) {
        if (!rows.fits(self, is, row))
            from.fail("a " + is.name() + " has a row that is not its own");
    });
}

}  // namespace fettle::physics_module
