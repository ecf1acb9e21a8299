// The estimate of the memory that a tree takes.

#include "catch.h"

#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

namespace weight_test {

using namespace fettle::property;

namespace {

ClassDescriptor described(const char* name, const char* base, std::uint32_t weight) {
    ClassDescriptor d;
    d.name = name;
    d.base = base;
    d.weight = weight;
    return d;
}

}  // namespace

TEST_CASE("the weight of an instance contains what its module needs even in a derived class") {
    Tree tree;
    const Class& plain = tree.define(described("Plain", "Object", 0));
    const Class& heavy = tree.define(described("Heavy", "Object", 5000));
    const Class& derived = tree.define(described("Derived", "Heavy", 0));
    const Class& heavier = tree.define(described("Heavier", "Heavy", 7000));
    const auto weight_of = [&](const Class& of) {
        const std::int64_t before = tree.weight();
        const Handle made = tree.create(of, tree.root(), {});
        const std::int64_t weight = tree.weight() - before;
        tree.barrier();
        tree.destroy(made);
        tree.barrier();
        CHECK(tree.weight() == before);
        return weight;
    };
    const std::int64_t least = weight_of(plain);
    CHECK(least > 0);
    CHECK(weight_of(heavy) == least + 5000);
    CHECK(weight_of(derived) == least + 5000);
    CHECK(weight_of(heavier) == least + 7000);
}

TEST_CASE("the weight of texts and lists is counted as long as their instance exists") {
    Tree tree;
    ClassDescriptor d = described("Line", "Object", 0);
    d.properties.push_back({.name = "label", .type = Type::text});
    Property points{.name = "points", .type = Type::list};
    points.element_weight = 100;
    d.properties.push_back(points);
    const Class& of = tree.define(std::move(d));
    const std::int64_t empty = tree.weight();
    for (int times = 0; times < 3; ++times) {
        const Handle line = tree.create(of, tree.root(), "line");
        const std::int64_t bare = tree.weight();
        tree.set(line, "label", std::string(1000, 'x'));
        CHECK(tree.weight() - bare >= 1000);
        CHECK(tree.weight() - bare < 1200);
        tree.set(line, "label", std::string());
        CHECK(tree.weight() == bare);
        tree.set(line, "points", Value(List(50, Value(1.0))));
        CHECK(tree.weight() - bare >= 50 * 100);
        tree.destroy(line);
        tree.barrier();
    }
    // What is left is the name, which the tree does not forget.
    CHECK(tree.weight() - empty < 1000);
}

TEST_CASE("a message has weight until it is delivered or dropped") {
    Tree tree;
    ClassDescriptor d = described("Thing", "Object", 0);
    d.properties.push_back({.name = "size", .type = Type::number});
    d.events = {{.name = "hit", .fields = {}}};
    const Class& of = tree.define(std::move(d));
    const Handle thing = tree.create(of, tree.root(), "thing");
    int delivered = 0;
    tree.watch(thing, "size", [&](const Change&) { ++delivered; });
    tree.on(thing, *of.event("hit"), [&](const Occurrence&) { ++delivered; });
    tree.barrier();
    const std::int64_t before = tree.weight();
    for (int i = 1; i <= 1000; ++i) {
        tree.set(thing, "size", double(i));
        tree.emit(thing, *of.event("hit"), {});
        CHECK(tree.weight() > before);
        tree.barrier();
    }
    CHECK(delivered == 2000);
    CHECK(tree.weight() == before);

    const Snapshot snapshot = tree.snapshot();
    tree.set(thing, "size", 5);
    tree.emit(thing, *of.event("hit"), {});
    tree.restore(snapshot);
    tree.barrier();
    CHECK(tree.weight() == before);

    tree.on_handler_error([](const HandlerError&) {});
    tree.watch(thing, "size",
               [&](const Change& c) { tree.set(thing, "size", c.new_value.number() + 1); });
    const std::int64_t endless = tree.weight();
    tree.set(thing, "size", -1);
    tree.barrier();  // stopped after some rounds
    CHECK(tree.weight() == endless);
}

TEST_CASE("a name counts once, however often instances have it") {
    Tree tree;
    const Class& of = tree.define(described("Thing", "Object", 0));
    const auto once = [&] {
        tree.destroy(tree.create(of, tree.root(), "a name of its own"));
        tree.barrier();
    };
    const std::int64_t before = tree.weight();
    once();
    const std::int64_t after = tree.weight();
    CHECK(after > before);
    for (int i = 0; i < 100; ++i) once();
    CHECK(tree.weight() == after);
}

TEST_CASE("a restored tree has the weight that it had") {
    Tree tree;
    ClassDescriptor d = described("Line", "Object", 300);
    d.properties.push_back({.name = "label", .type = Type::text});
    d.properties.push_back({.name = "size", .type = Type::number});
    const Class& of = tree.define(std::move(d));
    const auto fill = [&] {
        for (int i = 0; i < 20; ++i) {
            const Handle line = tree.create(of, tree.root(), {});
            tree.set(line, "label", std::string(100, 'x'));
            tree.set_or_add(line, "own", Value(List(7, Value(1.0))));
            tree.set_formula(line, "size", {.function = [](const Tree&) { return Value(2.0); }});
        }
    };
    const auto clear = [&] {
        for (const Handle each : tree.children(tree.root()))
            if (&tree.class_of(each) == &of) tree.destroy(each);
    };
    fill();
    tree.barrier();
    const std::int64_t full = tree.weight();
    const Snapshot snapshot = tree.snapshot();
    const Snapshot from_bytes = Snapshot::from_bytes(snapshot.to_bytes());
    clear();
    tree.barrier();
    const std::int64_t empty = tree.weight();
    CHECK(full - empty > 20 * (300 + 100));
    for (int times = 0; times < 5; ++times) {
        tree.restore(snapshot);
        tree.barrier();
        CHECK(tree.weight() == full);
        if (times % 2 == 0) fill();
        if (times == 3) clear();
    }
    tree.restore(snapshot);
    clear();
    tree.barrier();
    CHECK(tree.weight() == empty);

    // Functions are not in the bytes, but the texts are.
    tree.restore(from_bytes);
    tree.barrier();
    CHECK(tree.weight() > empty + 20 * (300 + 100));
    CHECK(tree.weight() <= full);
    clear();
    tree.barrier();
    CHECK(tree.weight() >= empty);
    CHECK(tree.weight() < empty + 200);  // with the texts that the tree itself has
}

}  // namespace weight_test
