// Functions of a host that fail, or that replace themselves while they run.

#include "catch.h"
#include "fixture.h"

#include <fettle/property/bytes.h>

namespace own_callbacks_test {

using namespace fettle::property;
using namespace fettle::property::testing;

TEST_CASE("an undo for which a module has no room is reported and can be repeated") {
    Tree tree;
    static bool full;
    full = false;
    ClassDescriptor d;
    d.name = "Guest";
    d.lifecycle.create = [](void*, Tree&, Handle) -> Row {
        if (full) throw Error(ErrorKind::rejected, "no room");
        return 0;
    };
    tree.define(std::move(d));
    const Handle guest = tree.create(tree.class_named("Guest"), tree.root(), "guest");
    const Tree::CauseScope scope(tree, Writer::console);
    tree.destroy(guest);
    full = true;
    const UndoResult refused = tree.undo();
    CHECK(refused.done);
    CHECK(refused.notes == std::vector<std::string>{"\"guest\" cannot be brought back: no room"});
    CHECK(tree.history().size() == 1);
    full = false;
    CHECK(tree.redo().done);
    CHECK(tree.undo().done);
    CHECK(tree.alive(guest));
    CHECK(tree.redo().done);
    CHECK_FALSE(tree.alive(guest));
}

TEST_CASE("a function that receives errors may replace itself") {
    Tree tree;
    const std::string text(100, 'q');
    std::string reported;
    tree.on_handler_error([&tree, &reported, text](const HandlerError&) {
        tree.on_handler_error(nullptr);
        reported = text;
    });
    tree.at_barrier([] { throw 5; });
    tree.barrier();
    CHECK(reported == text);
    Tree compiling;
    compiling.compile_formulas_with([&compiling, &reported, text](std::string_view) {
        compiling.compile_formulas_with({});
        reported = text + "!";
        return Formula{.function = [](const Tree&) { return Value(1.0); }, .source = "1"};
    });
    const Handle a = compiling.create(compiling.object_class(), compiling.root(), "a");
    compiling.set_or_add(a, "q", 2.0);
    compiling.set_formula(a, "q",
                          {.function = [](const Tree&) { return Value(1.0); }, .source = "1"});
    compiling.restore(Snapshot::from_bytes(compiling.snapshot().to_bytes()));
    CHECK(reported == text + "!");
}

TEST_CASE("a getter that edits the tree while a snapshot is taken is refused") {
    static Tree* of = nullptr;
    static std::string wanted;
    Tree tree;
    of = &tree;
    wanted.clear();
    ClassDescriptor spawner{.name = "Spawner"};
    Property spawned{.name = "spawned"};
    spawned.binding.kind = BindingKind::accessor;
    spawned.binding.get = [](void*, Row) -> Value {
        if (wanted == "create") of->create(of->object_class(), of->root());
        if (wanted == "delete") of->destroy(of->child(of->root(), "other"));
        if (wanted == "write") of->set_or_add(of->root(), "own", 1.0);
        if (wanted == "define") of->define(ClassDescriptor{.name = "Other"});
        return 1.0;
    };
    spawned.binding.set = [](void*, Row, const Value&) {};
    spawner.properties = {spawned};
    tree.create(tree.define(std::move(spawner)), tree.root());
    tree.create(tree.object_class(), tree.root(), "other");
    for (const std::string what : {"create", "delete", "write", "define"}) {
        wanted = what;
        INFO(what);
        CHECK_THAT(message_of([&] { tree.snapshot(); }),
                   contains("a snapshot is being taken: the functions that it calls cannot"));
    }
    wanted.clear();
    tree.restore(tree.snapshot());
    CHECK(tree.size() == 3);
    CHECK(tree.find_class("Other") == nullptr);
}

TEST_CASE("a setter that a formula calls cannot restore a snapshot") {
    Tree tree;
    static Tree* of;
    static Snapshot before;
    static double kept;
    static std::string refused;
    of = &tree;
    kept = 3;
    refused.clear();
    Binding b;
    b.kind = BindingKind::accessor;
    b.get = [](void*, Row) -> Value { return kept; };
    b.set = [](void*, Row, const Value& value) {
        try {
            of->restore(before);
        } catch (const Error& error) {
            refused = error.what();
        }
        kept = value.number();
    };
    ClassDescriptor d;
    d.name = "A";
    d.properties = {{.name = "x", .binding = b}};
    tree.define(std::move(d));
    before = tree.snapshot();
    const Handle a = tree.create(tree.class_named("A"), tree.root(), "a");
    tree.set_formula(a, "x", {.function = [](const Tree&) { return Value(77.0); }});
    CHECK(tree.get(a, "x") == Value(77.0));
    CHECK(tree.alive(a));
    CHECK_THAT(refused, contains("cannot be restored by a binding of a property"));
    before = {};
}

TEST_CASE("the tree stays consistent if the functions for weight and place throw") {
    Tree tree;
    std::vector<std::string> reported;
    tree.on_handler_error([&](const HandlerError& error) { reported.push_back(error.message); });
    tree.mark_weight(0, [] { throw std::runtime_error("boom"); });
    const Handle a = tree.create(tree.object_class(), tree.root(), "a");
    CHECK(tree.alive(a));
    CHECK(reported == std::vector<std::string>{"boom"});
    tree.check(tree.snapshot());
    std::function<std::string()> locate = []() -> std::string {
        throw std::runtime_error("where");
    };
    {
        const Tree::CauseScope scope(tree, Writer::console, &locate);
        tree.create(tree.object_class(), tree.root(), "b");
        tree.set_or_add(a, "v", 1);
    }
    CHECK(tree.undo().done);
    CHECK(tree.find(a, "v") == nullptr);
}

TEST_CASE("the function of a weight mark can set another mark but cannot change the tree") {
    Tree tree;
    std::vector<std::string> reported;
    tree.on_handler_error([&](const HandlerError& error) { reported.push_back(error.message); });
    const Handle parent = tree.create(tree.object_class(), tree.root(), "top");
    int calls = 0;
    tree.mark_weight(0, [&] {
        ++calls;
        tree.mark_weight(tree.weight() + 1, [&] {
            ++calls;
            tree.create(tree.object_class(), parent, "child");
        });
        tree.destroy(parent);
    });
    for (int i = 0; i < 3; ++i) tree.create(tree.object_class(), parent);
    CHECK(calls == 2);
    const std::string rule =
        "the function given to mark_weight is called in the middle of a change: it cannot ";
    CHECK(reported ==
          std::vector<std::string>{rule + "delete an instance", rule + "create an instance"});
    CHECK(tree.child_count(parent) == 3);
    tree.check(tree.snapshot());
}

TEST_CASE("a way back for an instance of another tree does nothing") {
    Tree large, small;
    Handle far;
    for (int i = 0; i < 5000; ++i) far = large.create(large.object_class(), large.root());
    small.placement_restorer(far)();
    CHECK(small.size() == 1);
    CHECK(large.size() == 5001);
}

TEST_CASE("the end of a block that was not begun is refused") {
    std::vector<std::byte> bytes;
    ByteWriter writer(bytes);
    writer.put(1);
    CHECK_THROWS_AS(writer.end_block(1000), Error);
    CHECK_THROWS_AS(writer.end_block(0), Error);
}

TEST_CASE(
    "a part of snapshots can neither add another one nor be removed while a snapshot is taken") {
    struct Part : SnapshotPart {
        explicit Part(const char* called) : name(called) {}
        std::string_view part_name() const override { return name; }
        Memory save(ByteWriter&) const override {
            if (action) action();
            return {};
        }
        std::function<void()> restore(ByteReader&, const Memory&) override {
            return [] {};
        }
        std::string name;
        std::function<void()> action;
    };
    Tree tree;
    Part first("first"), last("last"), late("late");
    for (Part* part : {&first, &last}) tree.add_part(*part);
    first.action = [&] { tree.add_part(late); };
    CHECK_THROWS_WITH(tree.snapshot(), contains("cannot add a part of snapshots"));
    CHECK(tree.parts().size() == 2);
    for (Part* removed : {&last, &first}) {
        Part* const other = removed == &last ? &first : &last;
        first.action = last.action = nullptr;
        other->action = [&] { tree.remove_part(*removed); };
        CHECK_THROWS_WITH(tree.snapshot(), contains("was removed while a snapshot"));
        CHECK(tree.parts().size() == 1);
        other->action = nullptr;
        CHECK_NOTHROW(tree.check(tree.snapshot()));
        tree.add_part(*removed);
    }
}

}  // namespace own_callbacks_test
