// Writing single elements of the list that a property holds.

#include "catch.h"

#include <fettle/property/observer.h>
#include <fettle/property/tree.h>
#include <fettle/property/write_log.h>

namespace list_elements_test {

using namespace fettle::property;

namespace {

struct Fixture {
    Tree tree;
    Handle all = tree.create(tree.object_class(), tree.root(), "all");

    Fixture() { tree.set_or_add(all, "list", List{1, 2, 3}); }
    const Property& list() { return tree.property(all, "list"); }
    Value value() { return tree.peek(all, list()); }
    std::string text() { return tree.text(value()); }
};

ClassDescriptor described(Property property) {
    ClassDescriptor d;
    d.name = "Line";
    d.properties.push_back(std::move(property));
    return d;
}

std::string message_of(const std::function<void()>& what) {
    try {
        what();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE_METHOD(Fixture, "elements of a list are replaced, added and removed at its end") {
    tree.set_element(all, list(), 2, 20);
    tree.set_element(all, list(), 4, 40);
    CHECK(text() == "{1, 20, 3, 40}");
    tree.remove_last_element(all, list());
    CHECK(text() == "{1, 20, 3}");
    CHECK(message_of([&] { tree.set_element(all, list(), 5, 1); }) ==
          "all.list[5]: the list has 3 elements");
    CHECK(message_of([&] { tree.set_element(all, list(), 0, 1); }) ==
          "all.list[0]: the list has 3 elements");
    CHECK(message_of([&] { tree.set_element(all, list(), 1, std::nan("")); }) ==
          "all.list[1]: NaN is never a value of a property");
    tree.set(all, list(), List{});
    CHECK(message_of([&] { tree.remove_last_element(all, list()); }) ==
          "all.list[1]: the list has 0 elements");
    CHECK(text() == "{}");
}

TEST_CASE_METHOD(Fixture, "a list that nothing else holds is not copied when it grows") {
    tree.set_element(all, list(), 4, 4);  // leaves the list of the constructor
    const auto place = [&] { return &value().list(); };
    const List* const before = place();
    for (std::size_t i = 5; i < 20'000; ++i) tree.set_element(all, list(), i, static_cast<int>(i));
    tree.set_element(all, list(), 7, 70);
    tree.remove_last_element(all, list());
    CHECK(place() == before);
    CHECK(value().list().size() == 19'998);
}

TEST_CASE_METHOD(Fixture, "who holds a list keeps it as it was") {
    const Value held = value();
    const Snapshot snapshot = tree.snapshot();
    tree.set_element(all, list(), 1, 10);
    tree.set_element(all, list(), 4, 4);
    tree.remove_last_element(all, list());
    CHECK(tree.text(held) == "{1, 2, 3}");
    CHECK(text() == "{10, 2, 3}");
    tree.restore(snapshot);
    CHECK(text() == "{1, 2, 3}");
}

TEST_CASE_METHOD(Fixture, "watchers, formulas and undo see the whole list") {
    std::vector<std::string> seen;
    const Connection watching = tree.watch(all, list(), [&](const Change& change) {
        seen.push_back(tree.text(change.old_value) + " to " + tree.text(change.new_value));
    });
    tree.set_or_add(all, "count", 0);
    tree.set_formula(all, "count",
                     Formula{.function = [&](const Tree& of) -> Value {
                                 return static_cast<int>(of.get(all, "list").list().size());
                             },
                             .source = "#list"});
    {
        const Tree::CauseScope me(tree, Writer::console);
        tree.begin_edit("grow");
        tree.set_element(all, list(), 4, 4);
        tree.set_element(all, list(), 5, 5);
        tree.end_edit();
    }
    CHECK(tree.get(all, "count") == Value(5));
    tree.barrier();
    CHECK(seen == std::vector<std::string>{"{1, 2, 3} to {1, 2, 3, 4, 5}"});
    CHECK(tree.undo().done);
    CHECK(text() == "{1, 2, 3}");
    CHECK(tree.get(all, "count") == Value(3));
}

TEST_CASE_METHOD(Fixture, "an element that is written replaces the formula of its list") {
    tree.set_formula(all, "list",
                     Formula{.function = [](const Tree&) -> Value {
                                 return List{7, 8};
                             },
                             .source = "{7, 8}"});
    CHECK(tree.get(all, "list") == Value(List{7, 8}));
    tree.set_element(all, list(), 3, 9);
    CHECK(tree.formula(all, list()) == nullptr);
    CHECK(text() == "{7, 8, 9}");
}

TEST_CASE("only the element of a declared list is checked, and by the rules of the list") {
    Tree tree;
    Property sizes{.name = "sizes", .type = Type::list, .range = {0, 9}};
    sizes.element = Type::number;
    sizes.element_weight = 100;
    const Handle line = tree.create(tree.define(described(sizes)), tree.root(), "line");
    const Property& property = tree.property(line, "sizes");
    const std::int64_t bare = tree.weight();
    tree.set_element(line, property, 1, 3);
    CHECK(tree.get(line, property).list()[0].is(Type::number));
    CHECK(tree.weight() - bare >= 100);
    CHECK(message_of([&] {
              tree.set_element(line, property, 2, "x");
          }).starts_with("line.sizes[2]: expected a number"));
    CHECK(message_of([&] {
              tree.set_element(line, property, 2, 10);
          }).starts_with("line.sizes[2]: expected a number from 0 to 9"));
    tree.remove_last_element(line, property);
    CHECK(tree.weight() == bare);
}

TEST_CASE_METHOD(Fixture, "observers are told the element, and a log of writes repeats it") {
    struct Notes : Observer {
        std::vector<std::string> lines;
        void wrote(Handle, const Property& p, const Value& now) override {
            lines.push_back(p.name + " = " + value_text(now));
        }
    } notes;
    tree.observe(notes);
    const Snapshot snapshot = tree.snapshot();
    WriteLog log(tree);
    tree.set_element(all, list(), 2, "b");
    tree.set_element(all, list(), 4, "d");
    tree.remove_last_element(all, list());
    tree.set_element(all, list(), 4, 5);
    CHECK(notes.lines ==
          std::vector<std::string>{"list = {1, \"b\", 3}", "list = {1, \"b\", 3, \"d\"}",
                                   "list = {1, \"b\", 3}", "list = {1, \"b\", 3, 5}"});
    const LoggedWrites piece = log.take();
    tree.restore(snapshot);
    CHECK(text() == "{1, 2, 3}");
    log.play(piece);
    CHECK(text() == "{1, \"b\", 3, 5}");
    tree.unobserve(notes);
}

TEST_CASE_METHOD(Fixture, "a log of writes holds the elements of a growing list once each") {
    WriteLog log(tree);
    for (std::size_t i = 4; i < 2000; ++i) tree.set_element(all, list(), i, 1.5);
    CHECK(log.memory() < 2000 * 60);
}

TEST_CASE("lists are in lists at most 64 deep, also when an element is written") {
    Value deep = List{};
    for (int i = 1; i < 63; ++i) deep = List{deep};
    Value outer = List{1};
    outer.set_element(0, deep);
    CHECK_THROWS_AS(outer.set_element(1, Value(List{deep})), Error);
    CHECK(outer.list().size() == 1);
}

}  // namespace list_elements_test
