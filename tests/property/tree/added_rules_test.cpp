// Rules for the properties that users add to the instances of a class.

#include <fettle/property/added_rules.h>
#include <fettle/property/error.h>
#include <fettle/property/tree.h>

#include "catch.h"

namespace added_rules_test {

using namespace fettle::property;

namespace {

/// Takes texts only, and makes a child of the root for each name.
struct Rules : AddedRules {
    explicit Rules(Tree& of) : tree(of) {}
    void check(Handle, std::string_view name, const Value& value) const override {
        if (!value.is(Type::text))
            throw Error(ErrorKind::wrong_type, std::string(name) + ": needs a text");
    }
    void changed(Handle instance, std::string_view name) override {
        notified += std::string(name) + " ";
        const Handle child = tree.child(tree.root(), name);
        if (tree.find(instance, name) == nullptr)
            tree.destroy(child);
        else if (!child)
            tree.create(tree.object_class(), tree.root(), name);
    }
    Tree& tree;
    std::string notified;
};

}  // namespace

TEST_CASE("rules check a property that is added to a class and are notified of it at once") {
    Tree tree;
    const Class& list = tree.define({.name = "List"});
    const Handle words = tree.create(list, tree.root(), "words");
    Rules rules(tree);
    set_added_rules(tree, list, &rules);

    tree.set_or_add(words, "first", "a");
    CHECK(tree.child(tree.root(), "first"));
    tree.set(words, "first", "b");
    tree.set(words, "first", "b");  // reported too: the child may be gone
    CHECK(rules.notified == "first first first ");
    CHECK_THROWS_WITH(tree.set(words, "first", 3), contains("needs a text"));
    CHECK_THROWS_WITH(tree.set_or_add(words, "second", 3), contains("second: needs a text"));
    CHECK(tree.get(words, "first") == Value("b"));
    CHECK(tree.find(words, "second") == nullptr);
    tree.remove_ad_hoc(words, "first");
    CHECK_FALSE(tree.child(tree.root(), "first"));

    // Other classes have no rules, and rules can be taken away.
    const Handle other = tree.create(tree.object_class(), tree.root(), "other");
    tree.set_or_add(other, "third", 3);
    set_added_rules(tree, list, nullptr);
    tree.set_or_add(words, "third", 3);
    CHECK(rules.notified == "first first first first ");
}

}  // namespace added_rules_test
