// Events that refer to an instance that was deleted before their delivery.

#include "catch.h"
#include "fixture.h"

namespace untold_events_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

struct Meeting {
    Tree tree;
    const Class* type = nullptr;
    std::vector<std::string> log;
    Handle first, second, brick;

    Meeting() {
        const std::vector<Field> of_end = {{.name = "other", .type = Type::reference}};
        std::vector<Field> of_begin = of_end;
        of_begin.push_back({.name = "speed", .type = Type::number});
        ClassDescriptor d;
        d.name = "Thing";
        d.events = {{.name = "meeting_end", .fields = of_end},
                    {.name = "meeting_begin", .fields = of_begin},
                    {.name = "hit", .fields = of_begin},
                    {.name = "group_seen", .fields = {{.name = "all", .type = Type::list}}}};
        type = &tree.define(std::move(d));
        first = tree.create(*type, tree.root(), "first");
        second = tree.create(*type, tree.root(), "second");
        brick = tree.create(*type, tree.root(), "brick");
    }
    const Event& event(const char* name) const { return *type->event(name); }
    void emit(Handle to, const char* name, Value other) {
        std::vector<Value> values = {std::move(other)};
        if (event(name).fields.size() == 2) values.emplace_back(3.0);
        tree.emit(to, event(name), std::move(values));
    }
    void note(const char* name, bool deletes = false) {
        tree.on(*type, event(name), [this, deletes](const Occurrence& o) {
            log.push_back(tree.name(o.instance) + " " + o.event->name);
            const Handle other = o.record.values[0].reference();
            if (deletes) tree.destroy(other);
        });
    }
};
using Log = std::vector<std::string>;

}  // namespace

TEST_CASE_METHOD(Meeting, "an event that refers to a deleted instance is not delivered") {
    note("hit", true);
    note("hit");
    emit(first, "hit", brick);
    emit(second, "hit", brick);
    tree.barrier();
    // Neither the second handler of the first event nor any handler of the second is called.
    CHECK(log == Log{"first hit"});
}

TEST_CASE_METHOD(Meeting,
                 "an event with a list that contains a deleted instance is not delivered") {
    tree.on(*type, event("group_seen"),
            [this](const Occurrence& o) { log.push_back(tree.name(o.instance)); });
    emit(first, "group_seen", List{first, brick});
    emit(second, "group_seen", List{first, second});
    tree.destroy(brick);
    tree.barrier();
    CHECK(log == Log{"second"});
}

TEST_CASE_METHOD(
    Meeting,
    "the end of a touch with a deleted instance is delivered to the handlers of its beginning") {
    note("meeting_begin", true);
    note("meeting_end");
    emit(first, "meeting_begin", brick);
    emit(second, "meeting_begin", brick);
    tree.barrier();
    CHECK(log == Log{"first meeting_begin"});
    emit(first, "meeting_end", brick);
    emit(second, "meeting_end", brick);
    tree.barrier();
    CHECK(log == Log{"first meeting_begin", "first meeting_end"});
    // That touch is over; another one has its own beginning.
    emit(second, "meeting_end", brick);
    tree.barrier();
    CHECK(log.back() == "second meeting_end");
}

TEST_CASE_METHOD(Meeting, "the end of a touch whose beginning had no handler is delivered") {
    note("meeting_end");
    emit(first, "meeting_begin", brick);
    tree.destroy(brick);
    tree.barrier();
    emit(first, "meeting_end", brick);
    tree.barrier();
    CHECK(log == Log{"first meeting_end"});
}

TEST_CASE_METHOD(Meeting, "only the handlers that got a beginning get the end") {
    int counts[2] = {0, 0};
    const bool together = GENERATE(true, false);
    for (int& count : counts) {
        tree.on(*type, event("meeting_begin"),
                [&, deletes = &count == counts](const Occurrence& o) {
                    ++count;
                    if (deletes) tree.destroy(o.record.values[0].reference());
                });
        if (together)
            tree.on(*type, event("meeting_end"), [&count](const Occurrence&) { --count; });
    }
    if (!together)
        for (int& count : counts)
            tree.on(*type, event("meeting_end"), [&count](const Occurrence&) { --count; });
    emit(first, "meeting_begin", brick);
    tree.barrier();
    CHECK(counts[0] == 1);
    CHECK(counts[1] == 0);
    emit(first, "meeting_end", brick);
    tree.barrier();
    CHECK(counts[0] == 0);
    CHECK(counts[1] == 0);
}

TEST_CASE_METHOD(Meeting, "one handler of the end is for several of the beginning") {
    int count = 0;
    tree.on(*type, event("meeting_begin"), [&](const Occurrence&) { ++count; });
    tree.on(*type, event("meeting_begin"),
            [&](const Occurrence& o) { tree.destroy(o.record.values[0].reference()); });
    tree.on(*type, event("meeting_begin"), [](const Occurrence&) {});
    tree.on(*type, event("meeting_end"), [&](const Occurrence&) { --count; });
    emit(first, "meeting_begin", brick);
    tree.barrier();
    emit(first, "meeting_end", brick);
    tree.barrier();
    CHECK(count == 0);
}

TEST_CASE_METHOD(Meeting, "events of an instance that a handler has deleted are not delivered") {
    tree.on(*type, event("hit"), [this](const Occurrence& o) {
        log.push_back(tree.name(o.instance));
        tree.destroy(o.instance);
    });
    tree.on(*type, event("hit"), [this](const Occurrence&) { log.emplace_back("again"); });
    emit(first, "hit", brick);
    tree.barrier();
    CHECK(log == Log{"first"});
}

TEST_CASE_METHOD(Meeting, "class and name of a deleted instance are still available") {
    CHECK_FALSE(tree.deleted_info(brick));
    tree.destroy(brick);
    REQUIRE(tree.deleted_info(brick));
    CHECK(&tree.deleted_info(brick)->of == type);
    CHECK(tree.deleted_info(brick)->name == "brick");
    const Snapshot before = tree.snapshot();
    const Handle late = tree.create(*type, tree.root(), "late");
    tree.restore(before);
    REQUIRE_FALSE(tree.alive(late));
    REQUIRE(tree.deleted_info(late));
    CHECK(tree.deleted_info(late)->name == "late");
    CHECK_FALSE(tree.deleted_info(Handle{}));
}

}  // namespace untold_events_test
