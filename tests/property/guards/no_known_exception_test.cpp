#include <fettle/property/question.h>
#include <fettle/property/snapshot.h>

#include "catch.h"
#include "fixture.h"

namespace no_known_exception_test {

// Callbacks may throw any type: it is handled like other errors, and the tree stays consistent.

using namespace fettle::property;
using fettle::property::testing::BallModule;
using fettle::property::testing::message_of;

namespace {

constexpr const char* unknown = "an exception of no known type";

/// Throws a type that is not derived from std::exception.
[[noreturn]] Value throws_a_number() {
    throw 5;
}

}  // namespace

TEST_CASE("a formula that throws an unknown type is in error and the tree stays usable") {
    Tree tree;
    const Handle node = tree.create(tree.object_class(), tree.root(), "node");
    tree.set_or_add(node, "width", 1.0);
    tree.set_or_add(node, "height", 2.0);
    const Property& width = tree.property(node, "width");
    tree.set_formula(node, width, {.function = [&](const Tree& in) {
                         in.get(node, "height");
                         return throws_a_number();
                     }});
    CHECK_THROWS_WITH(tree.get(node, width), contains(unknown));
    CHECK(tree.problem(node, width) == unknown);
    CHECK_FALSE(tree.in_formula());
    tree.barrier();
    CHECK(tree.peek(node, width).number() == 1.0);
    tree.set(node, "height", 3.0);
    tree.set_formula(node, width,
                     {.function = [&](const Tree& in) { return in.get(node, "height"); }});
    CHECK(tree.get(node, width).number() == 3.0);
}

TEST_CASE("a handler that throws an unknown type is reported like any other") {
    Tree tree;
    const Handle node = tree.create(tree.object_class(), tree.root(), "node");
    tree.set_or_add(node, "width", 1.0);
    std::string reported;
    tree.on_handler_error([&](const HandlerError& error) { reported += error.message + ";"; });
    int reports = 0;
    tree.watch(node, "width", [](const Change&) { throw 5; });
    tree.watch(node, "width", [&](const Change&) { ++reports; });
    tree.at_barrier([] { throw "text"; });
    tree.at_barrier([&] { ++reports; });
    tree.set(node, "width", 2.0);
    tree.barrier();
    CHECK(reports == 2);
    CHECK(reported == std::string(unknown) + ";" + unknown + ";");
}

TEST_CASE("an unknown type thrown by a setter or a method is a refusal") {
    Tree tree;
    ClassDescriptor crate{.name = "Crate"};
    crate.properties = {Property{.name = "width", .default_value = 0.0}};
    crate.properties[0].binding = {.kind = BindingKind::accessor,
                                   .get = [](void*, Row) { return Value(1.0); },
                                   .set = [](void*, Row, const Value&) { throw 5; },
                                   .reset = [](void*, Row) { throw 5; }};
    crate.methods = {Method{
        .name = "open",
        .call = [](void*, Tree&, Handle, Row, std::span<const Value>) -> Result { throw "text"; }}};
    const Handle made = tree.create(tree.define(crate), tree.root(), "crate");
    const std::string reported = std::string("crate.width: ") + unknown;
    CHECK(message_of([&] { tree.set(made, "width", 3.0); }) == reported);
    CHECK(message_of([&] { tree.reset(made, tree.property(made, "width")); }) == reported);
    CHECK(message_of([&] { tree.call(made, "open", {}); }) ==
          std::string("crate:open(): ") + unknown);
}

TEST_CASE("a module that throws an unknown type leaves a restored tree consistent") {
    Tree tree;
    static bool full;
    full = false;
    ClassDescriptor crate{.name = "Crate"};
    crate.lifecycle.create = [](void*, Tree&, Handle) -> Row {
        if (full) throw 5;
        return 0;
    };
    const Class& type = tree.define(crate);
    const Handle kept = tree.create(tree.object_class(), tree.root(), "kept");
    const Handle gone = tree.create(type, tree.root(), "crate");
    const Snapshot before = tree.snapshot();
    tree.destroy(gone);
    full = true;
    CHECK_NOTHROW(tree.restore(before));
    CHECK(tree.alive(kept));
    CHECK_FALSE(tree.alive(gone));
    tree.barrier();
}

TEST_CASE("an empty snapshot is refused with a message") {
    Snapshot empty;
    CHECK(empty.empty());
    CHECK(empty.payload().empty());
    CHECK(empty.memories().empty());
    CHECK(empty.held() == 0);
    CHECK_THROWS_AS(empty.step(), Error);
    CHECK_THROWS_WITH(empty.to_bytes(), contains("the snapshot is empty"));
    CHECK(Snapshot().release_payload().empty());
    Snapshot taken = Tree().snapshot();
    CHECK_FALSE(std::move(taken).release_payload().empty());
    CHECK(taken.payload().empty());
}

TEST_CASE("a question needs as many values as its event has fields") {
    Tree tree;
    BallModule module(tree);
    const Handle ball = tree.create(*module.type, tree.root(), "ball");
    const Event& bounced = *module.type->event("bounced");
    int calls_of_question = 0;
    tree.on(ball, bounced, [&](const Occurrence&) { ++calls_of_question; });
    std::vector<Value> none, right(bounced.fields.size(), Value(1.0)), many(9, Value(1.0));
    CHECK_THROWS_WITH(call_handlers(tree, ball, bounced, none, 0), contains("and was given 0"));
    CHECK_THROWS_WITH(call_handlers(tree, ball, bounced, many, 0), contains("and was given 9"));
    const Handle node = tree.create(tree.object_class(), tree.root(), "node");
    CHECK_THROWS_WITH(call_handlers(tree, node, bounced, right, 0), contains("no such event"));
    CHECK(calls_of_question == 0);
    call_handlers(tree, ball, bounced, right, 0);
    CHECK(calls_of_question == 1);
}

TEST_CASE("a column without memory is reported when the class gets its first instance") {
    Tree tree;
    static double memory[4] = {};
    static std::byte* where;
    static int rows;
    where = nullptr;
    rows = 0;
    ClassDescriptor crate{.name = "Crate"};
    crate.properties = {Property{.name = "width", .default_value = 0.0}};
    crate.properties[0].binding = {.kind = BindingKind::column,
                                   .native = Native::f64,
                                   .base = [](void*) { return where; },
                                   .stride = sizeof(double)};
    crate.lifecycle.create = [](void*, Tree&, Handle) { return Row(rows++); };
    crate.lifecycle.destroy = [](void*, Tree&, Handle, Row) { --rows; };
    const Class& type = tree.define(crate);
    const std::size_t before = tree.size();
    CHECK(message_of([&] { tree.create(type, tree.root(), "crate"); }) ==
          "Crate.width: it has no memory: the `base` of its column gave a null pointer");
    CHECK(tree.size() == before);
    CHECK(rows == 0);
    where = reinterpret_cast<std::byte*>(memory);
    CHECK(tree.get(tree.create(type, tree.root(), "crate"), "width").number() == 0.0);
}

}  // namespace no_known_exception_test
