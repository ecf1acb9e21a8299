#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "catch.h"
#include "scenes.h"

namespace ids_test {

// Ids as keys of containers, and the version of the library.

using namespace scenes;

static_assert(noexcept(BodyId{} == BodyId{}) && noexcept(ShapeId{} < ShapeId{}));
static_assert(BodyId{1, 5} < BodyId{2, 1} && BodyId{1, 5} < BodyId{1, 6});

TEST_CASE("ids are keys of ordered and of unordered containers") {
    World world;
    std::unordered_map<BodyId, int> of_bodies;
    std::map<ShapeId, int> of_shapes;
    std::unordered_set<JointId> joints;
    std::set<FieldId> fields;
    Body last;
    for (int i = 0; i < 50; ++i) {
        Body body = add_ball(world, {float(i) * 3, 0});
        of_bodies[body.id()] = i;
        of_shapes[body.shapes()[0].id()] = i;
        if (last) {
            const JointDef def = {.body_a = last.id(), .body_b = body.id()};
            joints.insert(world.create_distance_joint(def).id());
        }
        fields.insert(world.create_field({}).id());
        last = body;
    }
    REQUIRE(of_bodies.size() == 50);
    REQUIRE(of_bodies.at(last.id()) == 49);
    REQUIRE(of_shapes.at(last.shapes()[0].id()) == 49);
    REQUIRE(joints.size() == 49);
    REQUIRE(fields.size() == 50);
    uint32_t before = 0;
    for (const auto& [id, number] : of_shapes) {
        REQUIRE(id.index > before);
        before = id.index;
    }
}

TEST_CASE("hashes of ids in neighboring slots are far apart") {
    std::set<std::size_t> low_bits;
    for (uint32_t slot = 0; slot < 64; ++slot)
        low_bits.insert(std::hash<BodyId>()({slot, slot + 1}) >> 48);
    REQUIRE(low_bits.size() > 60);
    REQUIRE(std::hash<ShapeId>()({3, 4}) != std::hash<ShapeId>()({3, 5}));
}

TEST_CASE("the version of the headers is that of the library") {
    REQUIRE(version() == FETTLE_PHYSICS_VERSION);
    REQUIRE(FETTLE_PHYSICS_VERSION == FETTLE_PHYSICS_VERSION_MAJOR * 10000 +
                                          FETTLE_PHYSICS_VERSION_MINOR * 100 +
                                          FETTLE_PHYSICS_VERSION_PATCH);
}

}  // namespace ids_test
