#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fettle/property/acceptance.h>
#include <fettle/property/observer.h>
#include <fettle/property/question.h>
#include <fettle/property/write_log.h>

#include "catch.h"
#include "fixture.h"

namespace lifecycle_test {

// Calls of modules during the deletion of an instance, and of observers during the report of a
// write.

using namespace fettle::property;
using fettle::property::testing::message_of;

namespace {

/// A class whose module calls `act` when an instance is deleted.
class Dying {
  public:
    explicit Dying(Tree& tree) {
        ClassDescriptor of{.name = "Dying"};
        of.lifecycle.context = this;
        of.lifecycle.destroy = [](void* context, Tree& in, Handle self, Row) {
            Dying& dying = *static_cast<Dying*>(context);
            ++dying.reported;
            if (dying.act) dying.act(in, self);
        };
        is = &tree.define(std::move(of));
    }
    const Class* is = nullptr;
    std::function<void(Tree&, Handle)> act;
    int reported = 0;
};

}  // namespace

TEST_CASE("an instance that is being deleted cannot be changed") {
    struct Wrong {
        const char* what;
        std::function<void(Tree&, Handle)> act;
    };
    Snapshot before;
    const std::vector<Wrong> wrongs = {
        {"delete it", [](Tree& t, Handle self) { t.destroy(self); }},
        {"delete it", [](Tree& t, Handle self) { t.destroy(t.parent(self)); }},
        {"create an instance below it",
         [](Tree& t, Handle self) { t.create(t.object_class(), self); }},
        {"move it", [](Tree& t, Handle self) { t.move(self, t.root()); }},
        {"move an instance below it",
         [](Tree& t, Handle self) { t.move(t.create(t.object_class()), self); }},
        {"rename it", [](Tree& t, Handle self) { t.rename(self, "other"); }},
        {"replace it", [](Tree& t, Handle self) { t.replace(self, t.create(t.object_class())); }},
        {"define a formula",
         [](Tree& t, Handle self) {
             t.set_formula(self, "x", Formula{.function = [](const Tree&) { return Value(1); }});
         }},
        {"restore a snapshot", [&](Tree& t, Handle) { t.restore(before); }},
        {"undo", [](Tree& t, Handle) { t.undo(); }},
        {"redo", [](Tree& t, Handle) { t.redo(); }},
    };
    for (const Wrong& wrong : wrongs) {
        INFO(wrong.what);
        Tree tree;
        Dying dying(tree);
        const Handle group = tree.create(tree.object_class(), tree.root(), "group");
        const Handle top = tree.create(*dying.is, group, "top");
        const Handle below = tree.create(*dying.is, top, "below");
        before = tree.snapshot();
        std::vector<std::string> messages;
        dying.act = [&](Tree& t, Handle self) {
            messages.push_back(message_of([&] { wrong.act(t, self); }));
        };
        tree.destroy(top);
        REQUIRE(messages.size() == 2);
        for (const std::string& message : messages) CHECK_THAT(message, contains(wrong.what));
        CHECK(dying.reported == 2);
        CHECK_FALSE(tree.alive(top));
        CHECK_FALSE(tree.alive(below));
        dying.act = nullptr;
        tree.restore(before);
        CHECK(tree.path(below) == "group.top.below");
        CHECK(tree.size() == 4);
    }
}

TEST_CASE(
    "an exception of a module in the deletion of an instance is reported after the deletion") {
    Tree tree;
    Dying dying(tree);
    const Handle top = tree.create(*dying.is, tree.root(), "top");
    const Handle below = tree.create(*dying.is, top, "below");
    dying.act = [](Tree&, Handle) { throw std::runtime_error("the disk is full"); };
    CHECK(message_of([&] { tree.destroy(top); }) ==
          "top.below: the disk is full (thrown by its module as it was deleted; it is gone)");
    CHECK(dying.reported == 2);
    CHECK_FALSE(tree.alive(top));
    CHECK_FALSE(tree.alive(below));
    CHECK(tree.size() == 1);
    const Snapshot whole = tree.snapshot();
    CHECK_NOTHROW(tree.restore(whole));
}

TEST_CASE("at the end of a tree a module cannot throw or create anything") {
    int reported = 0;
    {
        Tree tree;
        Dying dying(tree);
        tree.create(*dying.is, tree.create(*dying.is, tree.root()));
        std::vector<std::string> messages;
        dying.act = [&](Tree& t, Handle) {
            ++reported;
            messages.push_back(message_of([&] { t.create(t.object_class()); }));
            CHECK_THAT(messages.back(), contains("while the tree is being destroyed"));
            throw 5;
        };
        auto gone = std::make_unique<Tree>();
        Dying other(*gone);
        gone->create(*other.is, gone->root());
        other.act = dying.act;
        gone.reset();
        CHECK(reported == 1);
        dying.act = nullptr;
    }
}

TEST_CASE("an observer may remove another one that is not yet notified") {
    struct Second : Observer {
        int reported = 0;
        void wrote(Handle, const Property&, const Value&) override { ++reported; }
    };
    struct First : Observer {
        Tree& tree;
        std::unique_ptr<Second> next = std::make_unique<Second>();
        explicit First(Tree& t) : tree(t) {}
        void wrote(Handle, const Property&, const Value&) override {
            if (next == nullptr) return;
            tree.unobserve(*next);
            next.reset();
        }
    };
    Tree tree;
    tree.set_or_add(tree.root(), "v", 1);
    First first(tree);
    Second third;
    tree.observe(first);
    tree.observe(*first.next);
    tree.observe(third);
    tree.set(tree.root(), "v", 2);
    tree.set(tree.root(), "v", 3);
    CHECK(third.reported == 2);
    tree.unobserve(first);
    tree.set(tree.root(), "v", 4);
    CHECK(third.reported == 3);
}

TEST_CASE("reading a value may not restore a snapshot") {
    static Tree* in = nullptr;
    static Snapshot snapshot;
    static std::string message;
    Tree tree;
    in = &tree;
    message.clear();
    ClassDescriptor of{.name = "X"};
    Property v{.name = "v"};
    v.binding.kind = BindingKind::accessor;
    v.binding.get = [](void*, Row) -> Value {
        if (!snapshot.empty()) message = message_of([] { in->restore(snapshot); });
        return 1.0;
    };
    of.properties = {v};
    const Handle x = tree.create(tree.define(std::move(of)), tree.root());
    const Connection watched = tree.watch(x, "v", [](const Change&) {});
    snapshot = tree.snapshot();
    tree.restore(snapshot);
    CHECK_THAT(message, contains("a snapshot cannot be restored by what another is restored by"));
    snapshot = {};
}

TEST_CASE("the depth of why is limited") {
    Tree tree;
    Handle before = tree.create(tree.object_class(), tree.root(), "n0");
    tree.set_or_add(before, "v", 1);
    for (int i = 1; i < 20'000; ++i) {
        const Handle next = tree.create(tree.object_class(), tree.root(), "n" + std::to_string(i));
        tree.set_formula(
            next, "v", Formula{.function = [before](const Tree& t) { return t.get(before, "v"); }});
        before = next;
    }
    const Explanation why = tree.why(before, tree.property(before, "v"));
    std::size_t levels = 0;
    const Explanation* at = &why;
    for (; !at->from.empty(); at = &at->from.front()) ++levels;
    CHECK(levels == 3001);
    CHECK(at->value == "what is below is left out");
}

TEST_CASE("a property added to another instance is refused") {
    Tree tree, other;
    const Handle a = tree.create(tree.object_class(), tree.root(), "a");
    const Handle b = tree.create(tree.object_class(), tree.root(), "b");
    const Handle c = other.create(other.object_class(), other.root(), "c");
    other.set_or_add(c, "zork", 1);
    tree.set_or_add(b, "blip", 1);
    for (const Property* foreign : {&other.property(c, "zork"), &tree.property(b, "blip")}) {
        const auto refused = [&](const auto& act) {
            CHECK_THAT(message_of(act), contains("a has no property \"" + foreign->name + "\""));
        };
        for (int i = 0; i < 2; ++i) {
            refused([&] { (void)tree.get(a, *foreign); });
            refused([&] { tree.set(a, *foreign, 3); });
            refused([&] { (void)tree.peek(a, *foreign); });
            refused([&] { tree.reset(a, *foreign); });
            refused([&] { (void)tree.coerce(a, *foreign, 3); });
            refused([&] { (void)tree.watch(a, *foreign, [](const Change&) {}); });
            refused([&] { (void)tree.overridden(a, *foreign); });
            refused([&] {
                tree.set_formula(a, *foreign,
                                 Formula{.function = [](const Tree&) { return Value(1); }});
            });
            tree.set_or_add(a, "own", 1);  // the same if the instance has other ad-hoc properties
        }
        tree.remove_ad_hoc(a, "own");
    }
    tree.set(b, "blip", 4);
    CHECK(tree.get(b, "blip") == Value(4));
}

TEST_CASE("an event without handlers is checked like one with handlers") {
    Tree tree, other;
    fettle::property::testing::BallModule balls(tree), others(other);
    const Handle ball = tree.create(tree.class_named("Ball"), tree.root());
    const Event& bounced = *tree.class_named("Ball").event("bounced");
    const Event& foreign = *other.class_named("Ball").event("bounced");
    CHECK_THAT(message_of([&] { tree.emit(ball, bounced, {}); }), contains("it has 1 values"));
    CHECK_THAT(message_of([&] { tree.emit(ball, foreign, {1.0}); }), contains("no such event"));
    CHECK_THAT(message_of([&] { (void)tree.listens(ball, foreign); }), contains("no such event"));
    std::vector<Value> none;
    CHECK_THAT(message_of([&] { call_handlers(tree, ball, bounced, none, 0); }),
               contains("it has 1"));
    CHECK_NOTHROW(tree.emit(ball, bounced, {1.0}));
}

TEST_CASE("empty functions are refused by name") {
    Tree tree;
    CHECK_THAT(message_of([&] { tree.each_below(tree.root(), {}); }), contains("each_below"));
    CHECK_THAT(message_of([&] { Acceptance a(tree, "query", {}); }), contains("Acceptance"));
    CHECK(Acceptance::is_accepted(tree.root()));
}

TEST_CASE("a log of writes can be repeated only in its own tree") {
    auto tree = std::make_unique<Tree>();
    Tree other;
    WriteLog log(*tree), foreign(other);
    tree->set_or_add(tree->root(), "v", 1);
    const LoggedWrites piece = log.take();
    CHECK_FALSE(piece.empty());
    CHECK_NOTHROW(log.play(piece));
    CHECK_THAT(message_of([&] { foreign.play(piece); }), contains("belongs to another tree"));
    CHECK(other.find(other.root(), "v") == nullptr);
    tree.reset();
    CHECK_THAT(message_of([&] { log.play(piece); }), contains("the tree of this log"));
}

TEST_CASE("invalid numbers in a descriptor are refused") {
    const auto refused = [](const char* what, const std::function<void(ClassDescriptor&)>& spoil) {
        Tree tree;
        ClassDescriptor of{.name = "X"};
        of.properties = {Property{.name = "v"}};
        of.methods = {Method{.name = "m",
                             .parameters = {{.name = "p", .type = Type::number}},
                             .call = [](void*, Tree&, Handle, Row,
                                        std::span<const Value>) -> Result { return Value(); }}};
        spoil(of);
        CHECK_THAT(message_of([&] { tree.define(std::move(of)); }), contains(what));
        CHECK(tree.find_class("X") == nullptr);
    };
    refused("its type is number 99", [](auto& of) { of.properties[0].type = Type(99); });
    refused("element", [](auto& of) {
        of.properties[0].type = Type::list;
        of.properties[0].element = Type(99);
    });
    refused("`snapshots` is number 77", [](auto& of) { of.snapshots = Snapshots(77); });
    refused("its effect is number 9", [](auto& of) { of.methods[0].effect = Effect(9); });
    refused("the type of the parameter is number 99",
            [](auto& of) { of.methods[0].parameters[0].type = Type(99); });
    refused("its default names an instance", [](auto& of) {
        of.properties[0].type = Type::reference;
        of.properties[0].default_value = Handle{7, 7};
    });
    for (const std::size_t stride : {std::size_t(-1), std::size_t{3}})
        refused("bytes, expected 4 to", [&](auto& of) {
            Binding& binding = of.properties[0].binding;
            binding.kind = BindingKind::column;
            binding.native = Native::f32;
            binding.stride = stride;
            binding.base = [](void*) -> std::byte* { return nullptr; };
        });
}

TEST_CASE(
    "a lifecycle function that watches everything leaves no watched value of a deleted instance") {
    Connection watched;
    Tree tree;
    ClassDescriptor of{.name = "Watching"};
    of.lifecycle.context = &watched;
    of.lifecycle.destroy = [](void* context, Tree& t, Handle, Row) {
        *static_cast<Connection*>(context) = t.watch_pattern("**", [](const Change&) {});
    };
    const Handle parent = tree.create(tree.object_class(), tree.root(), "top");
    tree.create(tree.define(of), parent);
    tree.destroy(parent);
    CHECK(watched.active());
    tree.barrier();
    tree.set_or_add(tree.root(), "v", 1);
    tree.barrier();
}

TEST_CASE("a lifecycle function that deletes an instance cannot watch it") {
    struct Tried {
        std::vector<std::string> refused;
        int heard = 0;
    } tried;  // before the tree, whose end deletes instances, too
    Tree tree;
    ClassDescriptor of{.name = "Watching"};
    of.events = {Event{.name = "rang"}};
    of.lifecycle.context = &tried;
    of.lifecycle.destroy = [](void* context, Tree& t, Handle self, Row) {
        Tried& all = *static_cast<Tried*>(context);
        const auto handler = [&all](const auto&) { ++all.heard; };
        for (const std::function<void()>& attempt : std::initializer_list<std::function<void()>>{
                 [&] { t.watch(self, "name", handler); }, [&] { t.watch(self, handler); },
                 [&] { t.watch_deleted(self, handler); },
                 [&] { t.on(self, *t.class_of(self).event("rang"), handler); }})
            all.refused.push_back(message_of(attempt));
    };
    const Class& watching = tree.define(of);
    const Handle first = tree.create(watching, tree.root(), "bell");
    tree.destroy(first);
    CHECK(tried.refused == std::vector<std::string>(
                               4, "bell is being deleted: its module cannot watch it meanwhile"));
    CHECK(tree.watcher_count() == 0);
    const Handle next = tree.create(watching, tree.root(), "bell");
    REQUIRE(next.index == first.index);
    tree.emit(next, *watching.event("rang"), {});
    tree.barrier();
    CHECK(tried.heard == 0);
}

}  // namespace lifecycle_test
