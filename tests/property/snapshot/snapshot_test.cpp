// Snapshots of the tree: handles, values, formulas, history, watchers, and damaged bytes.

#include "catch.h"
#include "snapshot_rig.h"

#include <fettle/property/snapshot_remarks.h>
#include <fettle/property/write_log.h>

namespace snapshot_test {

using namespace fettle::property;
using namespace fettle::property::testing;

TEST_CASE("a restored tree has the values it had") {
    SnapshotRig r;
    const Handle a = r.make("a"), b = r.make("b", a), ball = r.ball("ball");
    r.tree.set(a, "lives", 7);
    r.tree.set(a, "label", "first");
    r.tree.set(a, "at", Vec2(1, 2));
    r.tree.set(a, "owner", b);
    r.tree.set_or_add(b, "mood", List{Value(1), Value("x"), Value(a)});
    r.tree.set(ball, "mass", 5);
    r.tree.set_step(12);
    const auto source = GENERATE(false, true);
    const Snapshot snapshot = source ? through_bytes(r.tree.snapshot()) : r.tree.snapshot();
    REQUIRE(snapshot.step() == 12);

    r.tree.set_step(40);
    r.tree.set(a, "lives", 1);
    r.tree.set(a, "label", "changed");
    r.tree.set(a, "owner", Handle{});
    r.tree.remove_ad_hoc(b, "mood");
    r.tree.set_or_add(a, "late", 1);
    r.tree.set(ball, "mass", 50);
    r.tree.rename(b, "other");
    r.tree.restore(snapshot);

    REQUIRE(r.tree.step() == 12);
    REQUIRE(r.tree.get(a, "lives") == Value(7));
    REQUIRE(r.tree.get(a, "label") == Value("first"));
    REQUIRE(r.tree.get(a, "at") == Value(Vec2(1, 2)));
    REQUIRE(r.tree.get(a, "owner") == Value(b));
    REQUIRE(r.tree.get(b, "mood") == Value(List{Value(1), Value("x"), Value(a)}));
    REQUIRE(r.tree.find(a, "late") == nullptr);
    REQUIRE(r.tree.get(ball, "mass") == Value(5.0));
    REQUIRE(r.tree.path(b) == "a.b");
}

TEST_CASE("instances of the snapshot have the same handles again and later handles stay invalid") {
    SnapshotRig r;
    const Handle kept = r.make("kept"), lost = r.make("lost"), ball = r.ball("ball");
    r.tree.set(ball, "mass", 8);
    const Snapshot snapshot = r.tree.snapshot();
    r.tree.destroy(lost);
    r.tree.destroy(ball);
    const Handle later = r.make("later"), other = r.ball("other");
    r.tree.restore(snapshot);

    REQUIRE(r.tree.alive(kept));
    REQUIRE(r.tree.path(lost) == "lost");
    REQUIRE(r.tree.get(ball, "mass") == Value(8.0));
    REQUIRE_FALSE(r.tree.alive(later));
    REQUIRE_FALSE(r.tree.alive(other));
    REQUIRE_THROWS_AS(r.tree.get(later, "lives"), Error);

    // Slots are used again, generations are not.
    for (int round = 0; round < 4; ++round) {
        r.tree.destroy(lost);
        const Handle again = r.make("again"), more = r.make("more");
        REQUIRE(again.index == lost.index);
        for (const Handle dead : {later, other}) REQUIRE_FALSE(r.tree.alive(dead));
        REQUIRE(again != later);
        REQUIRE(more != other);
        r.tree.restore(snapshot);
        REQUIRE_FALSE(r.tree.alive(again));
        REQUIRE(r.tree.alive(lost));
    }
}

TEST_CASE("after two restores no handle of an abandoned timeline is used again") {
    SnapshotRig r;
    const Snapshot before = r.tree.snapshot();
    const Handle lost = r.make("lost");
    r.tree.restore(before);
    r.tree.restore(before);
    const Handle made = r.make("made");
    CHECK_FALSE(r.tree.alive(lost));
    CHECK(r.tree.alive(made));
}

TEST_CASE("a watcher of an ad-hoc property is notified when a restore adds it again") {
    SnapshotRig r;
    const Handle thing = r.make("thing");
    r.tree.set_or_add(thing, "score", 5);
    std::vector<std::string> log;
    r.tree.watch(thing, "score", [&](const Change& c) {
        log.push_back(r.tree.text(c.old_value) + ">" + r.tree.text(c.new_value));
    });
    const Snapshot before = r.tree.snapshot();
    r.tree.remove_ad_hoc(thing, "score");
    r.tree.barrier();
    r.tree.restore(before);
    r.tree.barrier();
    CHECK(log == std::vector<std::string>{"5>nil", "nil>5"});
}

TEST_CASE("new instances after a restore get the same slots as before") {
    SnapshotRig r;
    std::vector<Handle> all;
    for (int i = 0; i < 10; ++i) all.push_back(r.make("t" + std::to_string(i)));
    for (const int gone : {7, 2, 5}) r.tree.destroy(all[std::size_t(gone)]);
    const Snapshot snapshot = r.tree.snapshot();
    std::vector<std::uint32_t> first, second;
    for (int i = 0; i < 6; ++i) first.push_back(r.make({}).index);
    r.tree.restore(snapshot);
    for (int i = 0; i < 6; ++i) second.push_back(r.make({}).index);
    REQUIRE(first == second);
}

TEST_CASE("children keep their order and generated names continue") {
    SnapshotRig r;
    const Handle top = r.make("top");
    for (int i = 0; i < 5; ++i) r.tree.create(r.thing, top);
    const auto before = r.tree.children(top);
    const Snapshot snapshot = r.tree.snapshot();
    r.tree.destroy(before[1]);
    r.tree.move(before[0], r.tree.root());
    r.tree.create(r.thing, top);
    r.tree.restore(through_bytes(snapshot));
    REQUIRE(r.tree.children(top) == before);
    REQUIRE(r.tree.name(r.tree.create(r.thing, top)) == "thing_6");
}

TEST_CASE("watchers are notified of changes by a restore and stay with their instances") {
    SnapshotRig r;
    const Handle a = r.make("a"), b = r.make("b");
    std::vector<std::string> heard;
    const auto note = [&](const Change& change) {
        heard.push_back(r.tree.path(change.instance) + " " + r.tree.text(change.old_value) + " " +
                        r.tree.text(change.new_value) + " " +
                        std::string(writer_name(change.cause.writer)));
    };
    r.tree.watch(a, "lives", note);
    r.tree.watch_pattern("*.label", note);
    const Snapshot snapshot = r.tree.snapshot();
    r.tree.set(a, "lives", 9);
    r.tree.set(b, "label", "x");
    r.tree.barrier();
    heard.clear();
    r.tree.set(a, "lives", 10);  // not yet reported, and never valid
    r.tree.restore(snapshot);
    r.tree.barrier();
    REQUIRE(heard == std::vector<std::string>{"a 10 3 restore", "b \"x\" \"\" restore"});
    heard.clear();
    r.tree.set(a, "lives", 5);
    r.tree.barrier();
    REQUIRE(heard == std::vector<std::string>{"a 3 5 module"});
}

TEST_CASE("handlers of deleted are called for instances that a restore removes") {
    SnapshotRig r;
    const Handle a = r.make("a");
    const Snapshot snapshot = r.tree.snapshot();
    const Handle later = r.make("later");
    r.tree.set(later, "lives", 4);
    std::vector<std::string> heard;
    r.tree.watch_deleted(later, [&](const Existence& gone) {
        heard.push_back("deleted " + gone.path + " " + gone.cause.text());
        for (const auto& [property, value] : gone.last_values)
            if (property->name == "lives") heard.push_back(r.tree.text(value));
    });
    const Connection watch = r.tree.watch(later, "lives", [](const Change&) {});
    const Connection stays = r.tree.watch(a, "lives", [](const Change&) {});
    r.tree.barrier();
    r.tree.restore(snapshot);
    r.tree.barrier();
    REQUIRE(heard == std::vector<std::string>{"deleted later restore, step 0", "4"});
    REQUIRE_FALSE(watch.active());
    REQUIRE(stays.active());
    REQUIRE_THROWS_WITH(r.tree.require(later), contains("later was deleted"));
}

TEST_CASE("watchers of creation are called for instances that a restore adds") {
    SnapshotRig r;
    const Handle a = r.make("a");
    std::vector<std::string> heard;
    r.tree.watch_created(r.thing, [&](const Existence& made) { heard.push_back(made.path); });
    const Snapshot snapshot = r.tree.snapshot();
    r.tree.destroy(a);
    r.tree.barrier();
    r.tree.restore(snapshot);
    r.tree.barrier();
    REQUIRE(heard == std::vector<std::string>{"a"});
}

TEST_CASE("the root emits an event for a restore") {
    SnapshotRig r;
    r.tree.set_step(3);
    const Snapshot snapshot = r.tree.snapshot();
    r.tree.set_step(10);
    std::string heard;
    r.tree.on(
        r.tree.root(), *r.tree.class_of(r.tree.root()).event("restored"), [&](const Occurrence& o) {
            heard = r.tree.text(o.record.get("step")) + " " + r.tree.text(o.record.get("left"));
        });
    r.tree.restore(snapshot);
    r.tree.barrier();
    REQUIRE(heard == "3 10");
}

TEST_CASE("restored formulas follow their sources again") {
    SnapshotRig r;
    const Handle a = r.make("a"), b = r.make("b");
    r.tree.set_formula(b, "lives",
                       {[a](const Tree& t) { return Value(t.get(a, "lives").integer() * 2); }});
    REQUIRE(r.tree.get(b, "lives") == Value(6));
    const Snapshot snapshot = r.tree.snapshot();
    r.tree.set(b, "lives", 1);  // replaces it
    r.tree.set(a, "lives", 50);
    r.tree.restore(snapshot);
    REQUIRE(r.tree.formula_count() == 1);
    REQUIRE(r.tree.get(b, "lives") == Value(6));
    r.tree.set(a, "lives", 4);
    REQUIRE(r.tree.get(b, "lives") == Value(8));

    // A formula made since is removed.
    r.tree.set_formula(a, "lives", {[](const Tree&) { return Value(1); }});
    r.tree.restore(snapshot);
    REQUIRE(r.tree.formula_count() == 1);
    REQUIRE(r.tree.get(a, "lives") == Value(3));
}

TEST_CASE("after a restore the history is that of the snapshot") {
    SnapshotRig r;
    const Handle a = r.make("a"), b = r.make("b");
    const auto edit = [&](auto what) {
        const Tree::CauseScope scope(r.tree, Writer::console);
        what();
    };
    edit([&] { r.tree.set(a, "lives", 4); });
    edit([&] { r.tree.destroy(b); });
    const Snapshot snapshot = r.tree.snapshot();
    edit([&] { r.tree.set(a, "lives", 5); });
    REQUIRE(r.tree.undo().done);
    REQUIRE(r.tree.undo().done);  // restores b
    REQUIRE(r.tree.alive(b));
    edit([&] { r.make("c"); });
    r.tree.restore(snapshot);

    REQUIRE(r.tree.history().size() == 2);
    REQUIRE_FALSE(r.tree.alive(b));
    REQUIRE(r.tree.undo().notes.empty());
    REQUIRE(r.tree.alive(b));
    REQUIRE(r.tree.undo().done);
    REQUIRE(r.tree.get(a, "lives") == Value(3));
    REQUIRE_FALSE(r.tree.undo().done);
    REQUIRE(r.tree.redo().done);
    REQUIRE(r.tree.redo().done);
    REQUIRE_FALSE(r.tree.alive(b));

    // A file contains no history, so the reserved slots are free.
    r.tree.restore(through_bytes(snapshot));
    REQUIRE(r.tree.history().empty());
    REQUIRE(r.make("d").index == b.index);
    REQUIRE_FALSE(r.tree.alive(b));
}

TEST_CASE("classes defined since a snapshot stay without instances") {
    SnapshotRig r;
    const Snapshot snapshot = r.tree.snapshot();
    ClassDescriptor d;
    d.name = "Late";
    d.properties = {{.name = "x", .default_value = 1.0}};
    const Class& late = r.tree.define(std::move(d));
    const Handle one = r.tree.create(late, r.tree.root(), "one");
    r.tree.set(one, "x", 5);
    r.tree.restore(snapshot);
    REQUIRE_FALSE(r.tree.alive(one));
    const Handle two = r.tree.create(late, r.tree.root(), "two");
    REQUIRE(r.tree.get(two, "x") == Value(1.0));
}

TEST_CASE("a snapshot of another process is matched by names") {
    std::vector<std::byte> bytes;
    Handle a;
    {
        SnapshotRig r;
        a = r.make("a");
        r.tree.set(a, "lives", 11);
        bytes = r.tree.snapshot().to_bytes();
    }
    // Another order of classes, another type of a property, one property more and one less.
    Tree tree;
    ClassDescriptor first;
    first.name = "First";
    tree.define(std::move(first));
    BallModule module(tree);
    ClassDescriptor d;
    d.name = "Thing";
    d.properties = {{.name = "extra", .default_value = 2.5},
                    {.name = "label", .type = Type::integer, .default_value = 6},
                    {.name = "lives", .type = Type::integer, .default_value = 3}};
    tree.define(std::move(d));
    tree.restore(Snapshot::from_bytes(bytes));
    REQUIRE(tree.class_of(a).name() == "Thing");
    REQUIRE(tree.get(a, "lives") == Value(11));
    REQUIRE(tree.get(a, "label") == Value(6));
    REQUIRE(tree.get(a, "extra") == Value(2.5));

    Tree without;
    REQUIRE_THROWS_WITH(without.restore(Snapshot::from_bytes(bytes)),
                        contains("Ball") && contains("does not define"));
}

TEST_CASE("damaged bytes are refused and nothing changes") {
    SnapshotRig r;
    const Handle a = r.make("a"), ball = r.ball("ball");
    r.tree.set(a, "label", "something");
    r.tree.set_or_add(a, "mine", List{Value(1), Value("two")});
    const std::vector<std::byte> bytes = r.tree.snapshot().to_bytes();
    r.tree.set(a, "lives", 77);
    const auto before = r.tree.snapshot().to_bytes();

    for (std::size_t size = 0; size < bytes.size(); ++size)
        REQUIRE_THROWS_AS(Snapshot::from_bytes(std::span(bytes).first(size)), Error);
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        auto damaged = bytes;
        damaged[at] ^= std::byte{1} << (at % 8);
        REQUIRE_THROWS_AS(Snapshot::from_bytes(damaged), Error);
    }
    // Without the check of the checksum: the reader must refuse the bytes, or the change is
    // harmless.
    const Snapshot good = Snapshot::from_bytes(bytes);
    for (std::size_t size = 0; size < good.payload().size(); ++size) {
        const auto part = good.payload().first(size);
        REQUIRE_THROWS_AS(r.tree.restore(Snapshot({part.begin(), part.end()}, {})), Error);
    }
    REQUIRE((r.tree.snapshot().to_bytes() == before));
    for (std::size_t at = 0; at < good.payload().size(); ++at) {
        std::vector<std::byte> damaged(good.payload().begin(), good.payload().end());
        damaged[at] ^= std::byte{1} << (at % 8);
        try {
            r.tree.restore(Snapshot(damaged, {}));
            r.tree.each_below(r.tree.root(), [&](Handle h) { (void)r.tree.path(h); });
            r.make({});
            r.tree.barrier();
        } catch (const Error&) {
        }
    }
    r.tree.restore(good);
    REQUIRE(r.tree.get(a, "label") == Value("something"));
    REQUIRE(r.tree.alive(ball));
}

TEST_CASE("a restore in a handler is refused and another waits for the end of the barrier") {
    SnapshotRig r;
    const Handle a = r.make("a");
    const Snapshot snapshot = r.tree.snapshot();
    std::vector<std::string> heard;
    r.tree.watch(a, "lives", [&](const Change& change) {
        heard.push_back(r.tree.text(change.new_value));
        if (heard.size() > 1) return;
        REQUIRE_THROWS_AS(r.tree.restore(snapshot), Error);
        r.tree.at_barrier([&] { r.tree.restore(snapshot); });
    });
    r.tree.set(a, "lives", 8);
    r.tree.barrier(false);  // in the middle of a step
    REQUIRE(r.tree.get(a, "lives") == Value(8));
    r.tree.barrier();
    REQUIRE(r.tree.get(a, "lives") == Value(3));
    REQUIRE(heard == std::vector<std::string>{"8", "3"});
}

}  // namespace snapshot_test
