// The estimate of the memory that a tree takes.

#include "catch.h"

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

}  // namespace weight_test
