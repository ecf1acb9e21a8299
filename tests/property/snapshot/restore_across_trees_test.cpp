// A snapshot of one tree restored in another, in which the same handles refer to other instances.

#include <memory>

#include <fettle/property/snapshot_remarks.h>
#include <fettle/property/write_log.h>

#include "catch.h"
#include "fixture.h"

namespace restore_across_trees_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

/// A module that records the class of each row.
struct Rows {
    std::vector<std::string> made;  // by row
    std::vector<std::string> wrong;
    std::size_t ended = 0;

    struct Kind {
        Rows* rows;
        std::string name;
    };
    std::vector<std::unique_ptr<Kind>> kinds;

    void define(Tree& tree, const std::string& name, Snapshots snapshots = Snapshots::by_value) {
        kinds.push_back(std::make_unique<Kind>(Kind{this, name}));
        ClassDescriptor d{.name = name};
        d.snapshots = snapshots;
        d.properties = {{.name = "label", .type = Type::text, .default_value = "none"}};
        d.lifecycle.context = kinds.back().get();
        d.lifecycle.create = [](void* context, Tree&, Handle) -> Row {
            const Kind& kind = *static_cast<Kind*>(context);
            kind.rows->made.push_back(kind.name);
            return static_cast<Row>(kind.rows->made.size() - 1);
        };
        d.lifecycle.destroy = [](void* context, Tree&, Handle, Row row) {
            const Kind& kind = *static_cast<Kind*>(context);
            std::string& of = kind.rows->made.at(row);
            if (of != kind.name) kind.rows->wrong.push_back(kind.name + " ended a row of " + of);
            of = "nobody";
            ++kind.rows->ended;
        };
        tree.define(std::move(d));
    }
    std::size_t living() const { return made.size() - ended; }
};

std::vector<Handle> make(Tree& tree, const std::string& of, int count) {
    std::vector<Handle> all;
    for (int i = 0; i < count; ++i)
        all.push_back(tree.create(tree.class_named(of), tree.root(), of + std::to_string(i)));
    return all;
}

}  // namespace

TEST_CASE(
    "instances of another class with the same handles are different ones with their own rows") {
    const Snapshots kept = GENERATE(Snapshots::by_value, Snapshots::never);
    CAPTURE(static_cast<int>(kept));
    Rows rows;
    {
        Tree a, b;
        for (Tree* tree : {&a, &b}) {
            rows.define(*tree, "First", kept);
            rows.define(*tree, "Second");
        }
        const std::vector<Handle> firsts = make(a, "First", 40);
        const std::vector<Handle> seconds = make(b, "Second", 20);
        REQUIRE(firsts[3] == seconds[3]);
        const Snapshot of_a = a.snapshot(), of_b = b.snapshot();
        for (int round = 0; round < 2; ++round) {
            b.restore(of_a);
            CHECK(b.class_of(firsts[3]).name() == "First");
            for (const Handle each : firsts) CHECK(b.get(each, "label") == Value("none"));
            b.set(firsts[39], "label", "mine");
            CHECK(b.get(firsts[39], "label") == Value("mine"));
            CHECK(b.get(firsts[3], "label") == Value("none"));
            CHECK(rows.living() == 80);
            b.restore(of_b);
            CHECK(b.class_of(seconds[3]).name() == "Second");
            CHECK(rows.living() == 60);
        }
        b.restore(of_a);
        b.destroy(firsts[3]);
        CHECK(rows.living() == 79);
    }
    CHECK(rows.living() == 0);
    CHECK(rows.wrong.empty());
}

TEST_CASE("watchers of an instance end if its handle now refers to an instance of another class") {
    Rows rows;
    Tree a, b;
    for (Tree* tree : {&a, &b}) {
        rows.define(*tree, "First");
        rows.define(*tree, "Second");
    }
    const Handle first = make(a, "First", 1)[0];
    const Handle second = make(b, "Second", 1)[0];
    REQUIRE(first == second);
    b.barrier();
    std::vector<std::string> reported;
    b.watch(second, "label", [&](const Change&) { reported.emplace_back("changed"); });
    b.watch_deleted(second, [&](const Existence& gone) {
        reported.push_back(gone.instance_class->name() + " deleted: " + gone.path);
    });
    b.watch_created(b.class_named("First"),
                    [&](const Existence& made) { reported.push_back(b.path(made.instance)); });
    set(a, "First0.label", "of a");
    b.restore(a.snapshot());
    b.barrier();
    CHECK(reported == std::vector<std::string>{"Second deleted: Second0", "First0"});
    b.set(first, "label", "of b");
    b.barrier();
    CHECK(reported.size() == 2);
}

TEST_CASE("edits of one tree are not in the history of another") {
    const bool lives = GENERATE(true, false);
    auto a = std::make_unique<Tree>();
    Tree b;
    for (const char* name : {"Other", "Kind"}) a->define({.name = name});
    for (const char* name : {"Kind", "Other"}) b.define({.name = name});
    {
        const Tree::CauseScope me(*a, Writer::console);
        for (int i = 0; i < 2; ++i)
            a->destroy(a->create(a->class_named("Kind"), a->root(), "k" + std::to_string(i)));
        a->undo();
        a->set_or_add(a->root(), "v", 1);
    }
    const Snapshot of_a = a->snapshot();
    const std::size_t edits_of_a = a->history().size();
    WriteLog log(*a);
    {
        const Tree::CauseScope me(*a, Writer::console);
        a->undo();
    }
    const LoggedWrites piece = log.take();
    LoggedWrites edits = piece;
    edits.bytes.clear();
    REQUIRE(edits.history != nullptr);
    if (!lives) a.reset();
    b.restore(of_a);
    CHECK(b.history().empty());
    CHECK_FALSE(b.undo().done);
    CHECK_FALSE(b.redo().done);
    CHECK(b.get(b.root(), "v") == Value(1));
    WriteLog other(b);
    for (const LoggedWrites& each : {piece, edits})
        CHECK(message_of([&] { other.play(each); }) ==
              "this piece of a log of writes belongs to another tree");
    CHECK(b.history().empty());
    // The slots reserved for the deleted instances of those edits are free again.
    std::vector<Handle> made;
    for (int i = 0; i < 3; ++i) made.push_back(b.create(b.class_named("Kind"), b.root()));
    for (const Handle each : made) CHECK(&b.class_of(each) == &b.class_named("Kind"));
    if (lives) {
        a->restore(of_a);
        CHECK(a->history().size() == edits_of_a);
    }
}

TEST_CASE("formulas of one tree are compiled by the compiler of the other") {
    auto a = std::make_unique<Tree>();
    Tree b;
    int runs = 0;
    const auto add = [](Tree& tree) {
        const Handle made = tree.create(tree.object_class(), tree.root(), "o");
        tree.set_or_add(made, "sum", 0.0);
        tree.set_or_add(made, "secret", 0.0);
        return made;
    };
    const Handle of_a = add(*a), of_b = add(b);
    const auto count = [&, home = a.get()](const Tree&) {
        ++runs;
        return Value(static_cast<double>(home->size()));
    };
    a->set_formula(of_a, "sum", {.function = count, .source = "size"});
    a->set_formula(of_a, "secret", {.function = count, .source = "size", .not_saved = "uses more"});
    a->barrier();
    REQUIRE(runs == 2);
    const Snapshot snapshot = a->snapshot();
    if (GENERATE(true, false)) a.reset();
    SECTION("with a compiler") {
        b.compile_formulas_with([](const std::string& source) {
            return Formula{.function = [](const Tree& t) { return Value(10.0 + double(t.size())); },
                           .source = source};
        });
        b.restore(snapshot);
        b.barrier();
        CHECK(b.get(of_b, "sum") == Value(12.0));
        CHECK(restore_remarks(b) ==
              std::vector<std::string>{
                  "o.secret: its formula was not saved; it keeps the value that it had"});
    }
    SECTION("without one") {
        b.restore(snapshot);
        b.barrier();
        CHECK(b.get(of_b, "sum") == Value(2.0));
        CHECK(b.formula(of_b, b.property(of_b, "sum")) == nullptr);
        REQUIRE(restore_remarks(b).size() == 2);
        CHECK(restore_remarks(b)[0] ==
              "o.sum: its formula cannot be compiled here; it keeps the value that it had");
    }
    SECTION("if the same cell has a formula there") {
        b.set_formula(of_b, "secret", {.function = [](const Tree&) { return Value(7.0); }});
        b.restore(snapshot);
        b.barrier();
        CHECK(b.get(of_b, "secret") == Value(7.0));
    }
    CHECK(runs == 2);
}

TEST_CASE("memory that a part keeps is given only to that part") {
    struct Keeper : SnapshotPart {
        explicit Keeper(Tree& in) : tree(in) { tree.add_part(*this); }
        ~Keeper() override { tree.remove_part(*this); }
        std::string_view part_name() const override { return "keeper"; }
        Memory save(ByteWriter& to) const override {
            to.put(1);
            return std::make_shared<int>(5);
        }
        std::function<void()> restore(ByteReader& from, const Memory& memory) override {
            from.get<int>();
            return [this, memory] { given = memory != nullptr; };
        }
        Tree& tree;
        bool given = false;
    };
    Tree a, b;
    auto of_a = std::make_unique<Keeper>(a);
    Keeper of_b(b);
    const Snapshot snapshot = a.snapshot();
    a.restore(snapshot);
    CHECK(of_a->given);
    b.restore(snapshot);
    CHECK_FALSE(of_b.given);
    of_a.reset();
    of_a = std::make_unique<Keeper>(a);
    a.restore(snapshot);
    CHECK_FALSE(of_a->given);
}

}  // namespace restore_across_trees_test
