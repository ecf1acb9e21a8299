// Calls of modules and hosts during a restore: they are refused, or the restore is complete all the
// same.

#include <memory>
#include <set>

#include <fettle/property/snapshot_remarks.h>
#include <fettle/property/write_log.h>

#include "catch.h"
#include "fixture.h"

namespace restore_callbacks_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

/// A class with a row per instance, and functions that its module calls.
struct Things {
    std::function<void(Handle)> making, ending;
    std::vector<Row> ended;
    Row rows = 0;
    const Class* is = nullptr;
    Tree tree;  // last, because its destructor calls the module for each instance

    Things() {
        ClassDescriptor d{.name = "Thing"};
        d.properties = {{.name = "size"}};
        d.lifecycle.context = this;
        d.lifecycle.create = [](void* context, Tree&, Handle self) -> Row {
            Things& things = *static_cast<Things*>(context);
            const Row row = ++things.rows;
            if (things.making) things.making(self);
            return row;
        };
        d.lifecycle.destroy = [](void* context, Tree&, Handle self, Row row) {
            Things& things = *static_cast<Things*>(context);
            things.ended.push_back(row);
            if (things.ending) things.ending(self);
        };
        is = &tree.define(std::move(d));
    }
    ~Things() { making = ending = {}; }
    Handle make(const std::string& name, Handle parent = {}) {
        return tree.create(*is, parent ? parent : tree.root(), name);
    }
    std::vector<Handle> make(int count) {
        std::vector<Handle> all;
        for (int i = 0; i < count; ++i) all.push_back(make("thing_" + std::to_string(i + 1)));
        return all;
    }
};

}  // namespace

TEST_CASE("a module notified of the end of its rows in a restore may not change the structure") {
    Things things;
    Tree& tree = things.tree;
    const Handle stays = things.make("stays");
    const Snapshot before = tree.snapshot();
    const std::vector<Handle> all = things.make(50);
    WriteLog log(tree);
    const LoggedWrites nothing = log.take();
    const std::vector<std::pair<std::string, std::function<void()>>> changes = {
        {"create an instance",
         [&] {
             for (int i = 0; i < 500; ++i) tree.create(tree.object_class(), tree.root());
         }},
        {"create an instance", [&] { tree.create(tree.object_class()); }},
        {"delete it", [&] { tree.destroy(stays); }},
        {"delete it", [&] { tree.destroy(all[40]); }},
        {"rename it", [&] { tree.rename(stays, "other"); }},
        {"move it", [&] { tree.move(stays, all[1]); }},
        {"undo", [&] { tree.undo(); }},
        {"redo", [&] { tree.redo(); }},
        {"play a log of writes", [&] { log.play(nothing); }},
        {"take a snapshot", [&] { (void)tree.snapshot(); }}};
    const auto& [what, change] = changes[GENERATE(range(0, 10))];
    CAPTURE(what);
    std::string refused;
    things.ending = [&, &change = change](Handle) {
        refused = message_of(change);
        change();
    };
    tree.restore(before);
    CHECK(refused ==
          "a module is being notified of the instances that a restore removes: it cannot " + what +
              " before the restore is over");
    CHECK(things.ended.size() == 50);
    CHECK(tree.size() == 2);
    CHECK(tree.path(stays) == "stays");
    REQUIRE(restore_remarks(tree).size() == 50);
    CHECK(restore_remarks(tree)[0] ==
          "thing_1: its module failed when it was notified of the removal: " + refused);
    things.ending = {};
    CHECK(tree.alive(things.make("after")));
}

TEST_CASE("an instance that a module makes below another in a restore has one row") {
    Things things;
    Tree& tree = things.tree;
    const Handle a = things.make("a"), b = things.make("b");
    const Snapshot with = tree.snapshot();
    tree.destroy(a);
    tree.destroy(b);
    things.ended.clear();
    Handle kid;
    std::vector<std::string> refused;
    things.making = [&](Handle self) {
        if (self != a || kid) return;
        kid = tree.create(*things.is, a, "kid");
        refused.push_back(message_of([&] { tree.destroy(b); }));
        refused.push_back(message_of([&] { tree.move(b, a); }));
        refused.push_back(message_of([&] { tree.create(tree.object_class(), b); }));
        refused.push_back(message_of([&] { (void)tree.snapshot(); }));
        refused.push_back(message_of([&] { tree.undo(); }));
    };
    tree.restore(with);
    const std::string words =
        "b is still to be made by its module, as a snapshot is restored: nothing can ";
    const std::string again = "a module makes the instances of a snapshot again: it cannot ";
    CHECK(refused == std::vector<std::string>{words + "delete it meanwhile",
                                              words + "move it meanwhile",
                                              words + "create an instance meanwhile",
                                              again + "take a snapshot before the restore is over",
                                              again + "undo before the restore is over"});
    CHECK(things.ended.empty());
    CHECK(tree.size() == 4);
    std::set<Row> rows{tree.row(a), tree.row(b), tree.row(kid)};
    CHECK(rows == std::set<Row>{3, 4, 5});
    CHECK(things.rows == 5);
    tree.destroy(b);
    tree.destroy(a);
    CHECK(std::set<Row>(things.ended.begin(), things.ended.end()) == rows);
}

TEST_CASE("a watcher of a deleted instance can be stopped within a restore") {
    Tree tree;
    const Handle hole = tree.create(tree.object_class(), tree.root(), "hole");
    tree.create(tree.object_class(), tree.root(), "last");
    tree.destroy(hole);
    const Snapshot before = tree.snapshot();
    std::vector<Connection> connections;
    for (int i = 0; i < 200; ++i) {
        const Handle made = tree.create(tree.object_class(), tree.root());
        connections.push_back(tree.watch(made, [](const Change&) {}));
        connections.push_back(tree.watch(made, "name", [](const Change&) {}));
        connections.push_back(tree.watch_deleted(made, [](const Existence&) {}));
    }
    CHECK_NOTHROW(tree.restore(before, [&] {
        for (Connection& each : connections) each.stop();
    }));
    CHECK(tree.watcher_count() == 0);
    tree.barrier();
}

TEST_CASE("a watcher registered within a restore is not that of the earlier instance in the slot") {
    Tree tree;
    const Handle old = tree.create(tree.object_class(), tree.root(), "old");
    tree.set_or_add(old, "v", 0);
    const Snapshot before = tree.snapshot();
    tree.destroy(old);
    const Handle late = tree.create(tree.object_class(), tree.root(), "late");
    tree.set_or_add(late, "v", 0);
    REQUIRE(late.index == old.index);
    tree.barrier();
    std::vector<std::string> reported;
    tree.watch(late, "v", [&](const Change&) { reported.emplace_back("late changed"); });
    tree.watch_deleted(late, [&](const Existence&) { reported.emplace_back("late gone"); });
    tree.restore(before, [&] {
        tree.watch(old, "v", [&](const Change&) { reported.emplace_back("old changed"); });
        tree.watch_deleted(old, [&](const Existence&) { reported.emplace_back("old gone"); });
    });
    tree.barrier();
    CHECK(reported == std::vector<std::string>{"late gone"});
    tree.set(old, "v", 1);
    tree.barrier();
    CHECK(reported == std::vector<std::string>{"late gone", "old changed"});
    tree.destroy(old);
    tree.barrier();
    CHECK(reported == std::vector<std::string>{"late gone", "old changed", "old gone"});
}

TEST_CASE(
    "watchers of instances made and deleted within a restore are not those of the next in the "
    "slot") {
    Tree tree;
    const Handle old = tree.create(tree.object_class(), tree.root(), "old");
    const Snapshot before = tree.snapshot();
    tree.destroy(old);
    tree.barrier();
    int reported = 0;
    Handle next;
    tree.restore(before, [&] {
        tree.watch(old, [&](const Change&) { ++reported; });
        tree.destroy(old);
        next = tree.create(tree.object_class(), tree.root(), "next");
        REQUIRE(next.index == old.index);
    });
    tree.barrier();
    tree.rename(next, "renamed");
    tree.set_or_add(next, "v", 1);
    tree.barrier();
    CHECK(reported == 0);
    CHECK(tree.watcher_count() == 0);
}

TEST_CASE(
    "a formula of the abandoned timeline is not used for another instance in its cell after a "
    "restore") {
    Things things;
    Tree& tree = things.tree;
    const Snapshot before = [&] {
        const Handle a = things.make("a");
        const Snapshot with = tree.snapshot();
        tree.destroy(a);
        return with;
    }();
    const std::vector<Handle> late = things.make(200);
    for (std::size_t i = 0; i < late.size(); ++i)
        tree.set_formula(late[i], "size", {.function = [i, of = late[199 - i]](const Tree& t) {
                             return i < 100 ? t.get(of, "size") : Value(1.0);
                         }});
    tree.barrier();
    std::vector<bool> formulas;
    things.making = [&](Handle self) {
        tree.set_or_add(self, "other", 0.0);
        tree.set_formula(self, "other", {.function = [](const Tree&) { return Value(3.0); }});
        formulas.push_back(tree.formula(self, tree.property(self, "size")) != nullptr);
        tree.set_formula(self, "size", {.function = [](const Tree&) { return Value(2.0); }});
    };
    tree.restore(before);
    things.making = {};
    CHECK(formulas == std::vector<bool>{false});
    tree.barrier();
    CHECK(tree.size() == 2);
    CHECK(get(tree, "a.size") == Value(0.0));
}

namespace {

/// A part of snapshots that counts its restores.
struct Part : SnapshotPart {
    Part(Tree& in, std::string called) : tree(in), name(std::move(called)) { tree.add_part(*this); }
    ~Part() override {
        alive = false;
        tree.remove_part(*this);
    }
    std::string_view part_name() const override { return name; }
    Memory save(ByteWriter& to) const override {
        to.put(1);
        return {};
    }
    std::function<void()> restore(ByteReader& from, const Memory&) override {
        from.get<int>();
        return [this] {
            REQUIRE(alive);
            ++put;
            if (putting) putting();
        };
    }
    void refresh(std::uint64_t what) override { refreshed.push_back(what); }
    Tree& tree;
    std::string name;
    bool alive = true;
    int put = 0;
    std::vector<std::uint64_t> refreshed;
    std::function<void()> putting;
};

}  // namespace

TEST_CASE("a part that is removed during a restore is not restored") {
    Things things;
    Tree& tree = things.tree;
    alignas(Part) std::byte room[sizeof(Part)];
    Part* const first = new (room) Part(tree, "first");
    auto second = std::make_unique<Part>(tree, "second");
    Part third(tree, "third");
    const Snapshot before = tree.snapshot();
    const bool by_module = GENERATE(true, false);
    Part* another = nullptr;
    const auto replace = [&] {
        first->~Part();
        another = new (room) Part(tree, "another");  // at the same address
    };
    if (by_module) {
        things.make("thing");
        things.ending = [&](Handle) {
            replace();
            second.reset();
        };
    } else {
        first->putting = [&] {
            second.reset();
            throw std::runtime_error("broken");
        };
    }
    if (by_module)
        tree.restore(before);
    else
        CHECK_THROWS_WITH(tree.restore(before), "broken");
    things.ending = {};
    CHECK(second == nullptr);
    CHECK(third.put == 1);
    CHECK(tree.size() == 1);
    CHECK((by_module ? another : first)->put == (by_module ? 0 : 1));
    (by_module ? another : first)->~Part();
}

TEST_CASE(
    "a log updates only the part that it recorded even if parts were removed and added since") {
    Tree tree;
    auto first = std::make_unique<Part>(tree, "first");
    Part second(tree, "second"), third(tree, "third");
    WriteLog log(tree);
    tree.refreshing(*first, 1);
    tree.refreshing(second, 2);
    const LoggedWrites piece = log.take();
    first.reset();
    log.play(piece);
    CHECK(second.refreshed == std::vector<std::uint64_t>{2});
    CHECK(third.refreshed.empty());
}

namespace {

/// A class whose property is read from a row. Rows that are not made are counted when they are
/// read.
struct Gauges {
    double level = 1;
    std::set<Row> rows;
    int read_without_row = 0;
    Row last = 0;
    const Class* is = nullptr;
    Tree tree;

    Gauges() {
        Property property{.name = "level"};
        property.simulated = true;
        property.binding = accessor(*this, [](Gauges& g, Row row) {
            if (!g.rows.contains(row)) {
                ++g.read_without_row;
                throw std::runtime_error("there is no such row");
            }
            return g.level;
        });
        ClassDescriptor d{.name = "Gauge"};
        d.properties = {property};
        d.lifecycle.context = this;
        d.lifecycle.create = [](void* context, Tree&, Handle) -> Row {
            Gauges& gauges = *static_cast<Gauges*>(context);
            gauges.rows.insert(++gauges.last);
            return gauges.last;
        };
        d.lifecycle.destroy = [](void* context, Tree&, Handle, Row row) {
            static_cast<Gauges*>(context)->rows.erase(row);
        };
        is = &tree.define(std::move(d));
    }
};

}  // namespace

TEST_CASE("a part that connects watchers in a restore does not read rows that are not made yet") {
    Gauges gauges;
    Tree& tree = gauges.tree;
    const Handle gauge = tree.create(*gauges.is, tree.root(), "gauge");
    const Handle stays = tree.create(*gauges.is, tree.root(), "stays");
    Part part(tree, "connections");
    const Snapshot before = tree.snapshot();
    int heard = 0;
    const auto hear = [&](const Change&) { ++heard; };
    const int kind = GENERATE(0, 1, 2, 3);
    CAPTURE(kind);
    if (GENERATE(true, false)) tree.watch(stays, "level", hear);
    tree.destroy(gauge);
    std::vector<Connection> connected;
    part.putting = [&] {
        if (kind == 0) connected.push_back(tree.watch(gauge, "level", hear));
        if (kind == 1) connected.push_back(tree.watch(gauge, hear));
        if (kind == 2) connected.push_back(tree.watch(*gauges.is, nullptr, hear));
        if (kind == 3) connected.push_back(tree.watch_pattern("*.level", hear));
        Connection ended = tree.watch(gauge, hear);
        ended.stop();
    };
    tree.restore(before);
    CHECK(gauges.read_without_row == 0);
    REQUIRE(connected.size() == 1);
    tree.barrier();
    heard = 0;
    gauges.level = 2;
    tree.stepped();
    tree.barrier();
    CHECK(heard > 0);
    connected[0].stop();
    tree.restore(before);
    tree.destroy(gauge);
    tree.barrier();
    CHECK(gauges.read_without_row == 0);
}

}  // namespace restore_callbacks_test
