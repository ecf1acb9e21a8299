// Errors of functions of a host and of its modules inside the tree: each is refused or reported,
// and no other work is lost.

#include <fettle/property/edits.h>
#include <fettle/property/question.h>
#include <fettle/property/snapshot_remarks.h>
#include <fettle/property/write_log.h>

#include "catch.h"
#include "fixture.h"

namespace host_errors_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

/// Counts the rows of instances; its module can refuse to create some.
struct Things {
    Row rows = 0;
    std::vector<Row> ended;
    std::string full;  // an instance with this name is refused
    std::function<void(Handle)> making;
    const Class* is = nullptr;
    Tree tree;  // last, because its destructor calls the module for each instance

    Things() {
        ClassDescriptor d{.name = "Thing"};
        d.properties = {{.name = "of", .type = Type::reference}, {.name = "size"}};
        d.events = {{.name = "happened"}};
        d.lifecycle.context = this;
        d.lifecycle.create = [](void* context, Tree& in, Handle self) -> Row {
            Things& things = *static_cast<Things*>(context);
            if (in.name(self) == things.full) throw Error(ErrorKind::rejected, "no room");
            const Row row = things.rows++;
            if (things.making) things.making(self);
            return row;
        };
        d.lifecycle.destroy = [](void* context, Tree&, Handle, Row row) {
            static_cast<Things*>(context)->ended.push_back(row);
        };
        is = &tree.define(std::move(d));
    }
    ~Things() { making = {}; }
    Handle make(const std::string& name, Handle parent = {}) {
        return tree.create(*is, parent ? parent : tree.root(), name);
    }
};

}  // namespace

TEST_CASE(
    "a function called by a question cannot emit events or move rows or set the step or begin an "
    "edit") {
    Things things;
    Tree& tree = things.tree;
    const Handle a = things.make("a");
    int reported = 0;
    tree.on(a, *things.is->event("happened"), [&](const Occurrence&) { ++reported; });
    const std::vector<std::pair<std::string, std::function<void(Tree&)>>> changes = {
        {"emit an event", [&](Tree& t) { t.emit(a, *things.is->event("happened"), {}); }},
        {"move a row", [&](Tree& t) { t.set_row(a, 77); }},
        {"set the step", [](Tree& t) { t.set_step(9); }},
        {"begin an edit", [](Tree& t) { t.begin_edit("left open"); }},
        {"end an edit", [](Tree& t) { t.end_edit(); }},
        {"limit the history", [](Tree& t) { t.set_history_limit(0); }}};
    for (const auto& [what, change] : changes) {
        CAPTURE(what);
        {
            const Inquiry inquiry(tree, "the question", "is asked: it cannot");
            CHECK(message_of([&, &change = change] { change(tree); }) ==
                  "the question is asked: it cannot " + what);
        }
        std::string refusal;
        tree.set_formula(a, "size", {.function = [&, &change = change](const Tree& t) {
                             refusal = message_of([&] { change(const_cast<Tree&>(t)); });
                             return Value(1.0);
                         }});
        (void)tree.get(a, "size");
        CHECK_THAT(refusal, contains("computes a value: it cannot " + what));
    }
    tree.barrier();
    CHECK(reported == 0);
    CHECK(tree.row(a) == 0);
    CHECK(tree.step() == 0);
    const Tree::CauseScope me(tree, Writer::console);
    tree.set(a, "size", 2.0);
    CHECK(tree.undo().done);
}

TEST_CASE("a module cannot delete an instance that it is creating") {
    Things things;
    const Handle a = things.make("a");
    std::string refusal;
    things.making = [&](Handle self) {
        refusal = message_of([&] { things.tree.destroy(self); });
        refusal += " " + message_of([&] { things.tree.destroy(a); });
    };
    const Handle b = things.make("b", a);
    const std::string words = " is being made: its module cannot delete it meanwhile";
    CHECK(refusal == "a.b" + words + " a.b" + words);
    CHECK(things.tree.alive(b));
    CHECK(things.ended.empty());
    things.making = [&](Handle self) { things.tree.destroy(self); };
    CHECK_THROWS_AS(things.make("c"), Error);
    CHECK(things.ended.empty());
    CHECK(things.tree.size() == 3);
    things.making = {};
    things.tree.destroy(b);
    CHECK(things.ended == std::vector<Row>{1});
}

TEST_CASE("an instance that a module makes below one that it then refuses is deleted with it") {
    Things things;
    Handle kid;
    bool first = true;
    things.making = [&](Handle self) {
        if (!std::exchange(first, false)) return;
        kid = things.make("kid", self);
        throw Error(ErrorKind::rejected, "no room");
    };
    CHECK_THROWS_AS(things.make("a"), Error);
    CHECK_FALSE(things.tree.alive(kid));
    CHECK(things.ended == std::vector<Row>{1});
    CHECK(things.tree.size() == 1);
    things.tree.restore(things.tree.snapshot());
}

TEST_CASE("a restore names the instance that its module refused to create again") {
    Things things;
    const Handle a = things.make("a"), kid = things.make("kid", a);
    const Snapshot with = things.tree.snapshot();
    things.tree.destroy(a);
    const Handle other = things.make("other");
    const Snapshot without = things.tree.snapshot();
    things.full = GENERATE(as<std::string>{}, "a", "kid");
    CAPTURE(things.full);
    things.tree.restore(without);
    CHECK(restore_remarks(things.tree).empty());
    things.ended.clear();
    things.tree.restore(with);
    const bool top = things.full == "a";
    CHECK(things.tree.alive(a) == !top);
    CHECK_FALSE(things.tree.alive(kid));
    CHECK_FALSE(things.tree.alive(other));
    CHECK(restore_remarks(things.tree) ==
          std::vector<std::string>{std::string(top ? "a" : "a.kid") +
                                   ": it cannot be made, and is missing with all that was below "
                                   "it: no room"});
    CHECK(things.ended == std::vector<Row>{2});  // only the row of the instance created since
    CHECK(things.tree.size() == (top ? 1 : 2));
}

TEST_CASE("an undo that cannot create one instance undoes the rest and reports it") {
    Things things;
    Tree& tree = things.tree;
    const Handle a = things.make("a"), kid = things.make("kid", a), b = things.make("b");
    tree.set_or_add(tree.root(), "n", 0);
    {
        const Tree::CauseScope me(tree, Writer::console);
        tree.begin_edit("three things");
        tree.set(tree.root(), "n", 1);
        tree.destroy(a);
        tree.destroy(b);
        tree.end_edit();
    }
    things.full = GENERATE(as<std::string>{}, "a", "kid");
    const UndoResult undone = tree.undo();
    CHECK(undone.notes ==
          std::vector<std::string>{"\"a\" cannot be brought back: " +
                                   std::string(things.full == "a" ? "" : "kid: ") + "no room"});
    CHECK(tree.get(tree.root(), "n") == Value(0));
    CHECK(tree.alive(b));
    CHECK_FALSE(tree.alive(a));
    CHECK(tree.history()[0].undone);
    things.full = "";
    tree.redo();
    CHECK(tree.undo().notes.empty());
    CHECK(tree.alive(kid));
}

TEST_CASE("an undo that restores two instances restores a reference between them") {
    Things things;
    Tree& tree = things.tree;
    const Handle a = things.make("a"), j = things.make("j");
    tree.set(j, "of", a);
    {
        const Tree::CauseScope me(tree, Writer::console);
        tree.begin_edit("both");
        tree.destroy(a);
        tree.destroy(j);
        tree.end_edit();
    }
    for (int i = 0; i < 2; ++i) {
        CHECK(tree.undo().notes.empty());
        CHECK(tree.get(j, "of") == Value(a));
        CHECK(tree.redo().notes.empty());
        CHECK_FALSE(tree.alive(j));
    }
}

TEST_CASE(
    "after an exception in a handler the others are called and the barrier throws the first one") {
    Tree tree;
    tree.set_or_add(tree.root(), "v", 0);
    std::vector<std::string> reported;
    const bool sink = GENERATE(true, false);
    if (sink)
        tree.on_handler_error(
            [&](const HandlerError& e) { throw std::runtime_error("sink of " + e.message); });
    tree.watch(tree.root(), "v", [](const Change&) { throw std::runtime_error("first"); });
    tree.watch(tree.root(), "v", [](const Change&) { throw std::runtime_error("second"); });
    tree.watch(tree.root(), "v", [&](const Change&) { reported.emplace_back("watcher"); });
    tree.at_barrier([] { throw std::runtime_error("action"); });
    tree.at_barrier([&] { reported.emplace_back("action"); });
    tree.set(tree.root(), "v", 1);
    CHECK_THROWS_WITH(tree.barrier(), sink ? "sink of first" : "first");
    CHECK(reported == std::vector<std::string>{"watcher", "action"});
    tree.barrier();
    CHECK(reported.size() == 2);
}

TEST_CASE("after an exception in a function of a question the others are called") {
    Things things;
    const Handle a = things.make("a");
    const Event& event = *things.is->event("happened");
    int asked = 0;
    if (GENERATE(true, false))
        things.tree.on_handler_error([](const HandlerError&) { throw std::runtime_error("x"); });
    things.tree.on(a, event, [](const Occurrence&) { throw std::runtime_error("x"); });
    things.tree.on(a, event, [&](const Occurrence&) { ++asked; });
    std::vector<Value> values;
    CHECK_THROWS_WITH(call_handlers(things.tree, a, event, values, 0), "x");
    CHECK(asked == 1);
}

TEST_CASE("an open edit without changes does not prevent undo") {
    Tree tree;
    tree.set_or_add(tree.root(), "v", 0);
    const Tree::CauseScope me(tree, Writer::console);
    tree.set(tree.root(), "v", 1);
    tree.begin_edit("e");
    CHECK(tree.undo().done);
    CHECK(tree.get(tree.root(), "v") == Value(0));
    tree.set(tree.root(), "v", 2);
    CHECK_THROWS_AS(tree.undo(), Error);
    tree.end_edit();
}

TEST_CASE("a handle of generation 0 refers to no instance with any index") {
    Tree tree;
    const Class& of = tree.object_class();
    const Handle a = tree.create(of, tree.root(), "a");
    for (const std::uint32_t index : {a.index, a.index + 1, 999'999'999U}) {
        const Handle made = tree.create(of, Handle{index, 0}, "x");
        CHECK_FALSE(tree.parent(made));
        CHECK(tree.path(made) == "(detached x)");
        tree.move(a, Handle{index, 0});
        CHECK_FALSE(tree.parent(a));
    }
}

TEST_CASE("no barrier starts while a snapshot is restored") {
    Tree tree;
    const Snapshot before = tree.snapshot();
    const Handle late = tree.create(tree.object_class(), tree.root(), "late");
    tree.set_or_add(late, "v", 1);
    tree.watch(late, [](const Change&) {});
    tree.barrier();
    CHECK_THROWS_WITH(tree.restore(before, [&] { tree.barrier(); }),
                      contains("no barrier can start while a snapshot"));
    CHECK_FALSE(tree.alive(late));
    tree.barrier();
}

TEST_CASE("an observer of a tree may be removed while the tree is being destroyed") {
    struct Part : SnapshotPart {
        std::string_view part_name() const override { return "part"; }
        Memory save(ByteWriter&) const override { return {}; }
        std::function<void()> restore(ByteReader&, const Memory&) override { return {}; }
    };
    struct Report : Observer, EditObserver {
        explicit Report(int& c) : count(c) {}
        void wrote(Handle, const Property&, const Value&) override { ++count; }
        void refreshing(SnapshotPart&, std::uint64_t) override { ++count; }
        void edited(Handle, const Property&, const CellState&) override { ++count; }
        int& count;
    };
    struct Game {
        int reported = 0, computed = 0, ended = 0;
        std::vector<std::string> refused;
        std::unique_ptr<Part> part = std::make_unique<Part>();
        std::unique_ptr<Report> observer = std::make_unique<Report>(reported);
        std::unique_ptr<WriteLog> log;
        Handle a;
    } game;
    {
        Tree tree;
        ClassDescriptor d{.name = "Thing"};
        d.properties = {{.name = "size"}};
        d.lifecycle.context = &game;
        d.lifecycle.destroy = [](void* context, Tree& in, Handle self, Row) {
            Game& of = *static_cast<Game*>(context);
            ++of.ended;
            of.log.reset();
            of.observer.reset();
            Part another;
            in.refreshing(of.part ? *of.part : another, 1);
            of.part.reset();
            CHECK(in.get(of.a, "size") == Value(1.0));
            const Tree::CauseScope me(in, Writer::console);
            in.set(self, "size", 5);
            CHECK(in.get(self, "size") == Value(5.0));
            of.refused.push_back(message_of([&] { WriteLog log(in); }));
            of.refused.push_back(message_of([&] { in.add_part(another); }));
            CHECK_FALSE(in.snapshot().empty());
        };
        tree.define(std::move(d));
        game.a = tree.create(tree.class_named("Thing"), tree.root(), "a");
        for (int i = 0; i < 3; ++i) tree.create(tree.class_named("Thing"), game.a);
        tree.set_formula(game.a, "size", {.function = [&](const Tree&) {
                             ++game.computed;
                             return Value(1.0);
                         }});
        tree.barrier();
        tree.add_part(*game.part);
        tree.observe(*game.observer);
        tree.observe_edits(game.observer.get());
        game.log = std::make_unique<WriteLog>(tree);
    }
    CHECK(game.ended == 4);
    CHECK(game.reported == 0);
    CHECK(game.computed == 1);
    REQUIRE(game.refused.size() == 8);
    CHECK(game.refused[0] == "the tree is being destroyed: it cannot be observed any more");
    CHECK(game.refused[1] == "the tree is being destroyed: it cannot get a part any more");
}

TEST_CASE("watchers of an instance made and deleted within a restore end with it") {
    Tree tree;
    const Snapshot before = tree.snapshot();
    int reported = 0;
    tree.restore(before, [&] {
        std::vector<Handle> made;
        for (int i = 0; i < 100; ++i)
            made.push_back(tree.create(tree.object_class(), tree.root(), ""));
        for (const Handle each : made) tree.watch(each, [&](const Change&) { ++reported; });
        for (const Handle each : made) tree.destroy(each);
    });
    tree.restore(before);  // has fewer slots
    tree.barrier();
    std::vector<Handle> others;  // they reuse the slots
    for (int i = 0; i < 100; ++i)
        others.push_back(tree.create(tree.object_class(), tree.root(), ""));
    tree.barrier();
    for (const Handle each : others) tree.rename(each, "other_" + std::to_string(each.index));
    tree.barrier();
    CHECK(reported == 0);
}

}  // namespace host_errors_test
