// Classes that end before their tree.

#include <catch.h>

#include <array>

#include <fettle/property/ended_class.h>
#include <fettle/property/error.h>
#include <fettle/property/tree.h>

namespace ended_class_test {

using namespace fettle::property;

namespace {

struct Lamp {
    std::array<double, 8> brightness{};
};

const Class& define_lamp(Tree& tree, Lamp& lamp) {
    return tree.define(
        {.name = "Lamp",
         .properties = {{.name = "brightness",
                         .type = Type::number,
                         .binding = column(lamp, Native::f64, sizeof(double),
                                           [](Lamp& l) { return &l.brightness[0]; })}}});
}

}  // namespace

TEST_CASE("an ended class has no instances and none can be made") {
    Tree tree;
    Lamp lamp;
    const Class& ended = define_lamp(tree, lamp);
    const Class& lantern = tree.define({.name = "Lantern", .base = "Lamp"});
    const Handle box = tree.create(tree.object_class(), tree.root(), "box");
    const Handle inside = tree.create(lantern, box, "inside");
    const Handle below = tree.create(tree.object_class(), inside, "below");
    const Handle loose = tree.create(ended);
    tree.begin_edit("delete one");
    const Handle deleted = tree.create(ended, tree.root(), "deleted");
    tree.end_edit();
    tree.begin_edit("delete it");
    tree.destroy(deleted);
    tree.end_edit();
    const Snapshot before = tree.snapshot();
    end_class(tree, ended);
    for (const Handle gone : {inside, below, loose}) CHECK_FALSE(tree.alive(gone));
    CHECK(tree.alive(box));
    CHECK_THROWS_WITH(tree.create(ended, tree.root()),
                      contains("Lamp: it can have no instances any more"));
    CHECK_THROWS_WITH(tree.create(lantern), contains("Lantern: it can have no instances"));
    CHECK_THROWS_WITH(tree.restore(before), contains("it can have no instances any more"));
    tree.undo();
    CHECK_FALSE(tree.alive(deleted));
    CHECK(tree.size() == 2);
    end_class(tree, ended);  // once more does no harm
    tree.restore(tree.snapshot());
}

TEST_CASE("a class of the root or of another tree cannot be ended") {
    Tree tree, other;
    Lamp lamp;
    const Class& ended = define_lamp(tree, lamp);
    CHECK_THROWS_WITH(end_class(tree, tree.object_class()), contains("the root"));
    CHECK_THROWS_WITH(end_class(other, ended), contains("belongs to another tree"));
    CHECK(tree.alive(tree.create(ended)));
}

}  // namespace ended_class_test
