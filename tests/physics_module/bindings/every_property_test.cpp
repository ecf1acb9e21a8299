// Every writable property of every class is written on a body that is awake and on one that sleeps,
// and must have an effect on the simulation or on the picture.

#include "catch.h"
#include "stage.h"

namespace every_property_test {

using namespace fettle::physics_module::testing;
using fettle::property::Class;
using fettle::property::Property;

namespace {

Cases all_cases() {
    Cases all;
    for (const Cases& some : {body_cases(), shape_cases(), form_cases(), world_cases(),
                              joint_cases(), field_cases(), mover_cases()})
        for (const auto& [name, one] : some) {
            INFO(name);
            REQUIRE(all.emplace(name, one).second);
        }
    return all;
}

Handle subject_of(Stage& stage, const Case& one, const std::string& name) {
    if (one.subject) return one.subject(stage);
    if (name.starts_with("World.")) return stage.world;
    return name.starts_with("Body.") ? stage.body : stage.shape;
}

/// True if the effect of the edit is observed.
bool try_out(const Case& one, const std::string& name, bool asleep, bool edit) {
    Stage stage(one.shape);
    one.prepare(stage);
    stage.game.step(20);
    REQUIRE(stage.game.awake(stage.body));
    if (asleep) REQUIRE(stage.game.falls_asleep(stage.body));
    stage.was_awake = stage.game.awake(stage.body);
    stage.fastest_rise = stage.turns = stage.hits = 0;
    if (edit) {
        const std::string property = name.substr(name.find('.') + 1);
        const Handle subject = subject_of(stage, one, name);
        const Value written = one.value(stage);
        REQUIRE_FALSE(stage.game.get(subject, property) == written);
        stage.game.set(subject, property, written);
        if (written.is(fettle::property::Type::boolean))
            CHECK(stage.game.get(subject, property) == written);
    }
    one.then(stage);
    stage.run(one.steps);
    CHECK_FALSE(stage.game.physics.world(stage.world).validate());
    return one.effect(stage);
}

std::vector<std::string> writable_properties() {
    Game game;
    std::vector<std::string> names;
    const auto is_a = [&](const Class& of, std::string_view base) {
        return of.is_a(game.tree.class_named(base));
    };
    for (const Class* of : game.tree.classes()) {
        if (!is_a(*of, "World") && !is_a(*of, "Body") && !is_a(*of, "Shape") &&
            !is_a(*of, "Joint") && !is_a(*of, "Field"))
            continue;
        for (const Property* property : of->properties()) {
            if (property->read_only || property->owner == &game.tree.object_class()) continue;
            const std::string name = property->owner->name() + "." + property->name;
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    return names;
}

}  // namespace

TEST_CASE("every writable property has a case that shows its effect") {
    const Cases cases = all_cases();
    const std::vector<std::string> names = writable_properties();
    REQUIRE(names.size() > 50);
    for (const std::string& name : names) {
        INFO(name);
        CHECK(cases.contains(name));
    }
    for (const auto& [name, one] : cases) {
        INFO(name);
        CHECK(std::find(names.begin(), names.end(), name) != names.end());
    }
}

TEST_CASE("an edit of any property of an awake body has its effect") {
    for (const auto& [name, one] : all_cases()) {
        INFO(name);
        CHECK(try_out(one, name, false, true));
        CHECK_FALSE(try_out(one, name, false, false));
    }
}

TEST_CASE("an edit of any property of a sleeping body has its effect") {
    for (const auto& [name, one] : all_cases()) {
        INFO(name);
        CHECK(try_out(one, name, true, true));
        CHECK_FALSE(try_out(one, name, true, false));
    }
}

}  // namespace every_property_test
