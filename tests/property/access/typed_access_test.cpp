#include "catch.h"
#include "fixture.h"

#include <cmath>
#include <limits>

#include <fettle/property/observer.h>

namespace typed_access_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

struct Report {
    std::string what;
    Writer writer;
    std::uint64_t step;
};

class Listener : public Observer {
  public:
    explicit Listener(Tree& tree) : tree_(tree) { tree.observe(*this); }
    ~Listener() override { tree_.unobserve(*this); }
    void wrote(Handle, const Property& p, const Value& now) override {
        reported.push_back(
            {p.name + " = " + tree_.text(now), tree_.cause().writer, tree_.cause().step});
    }
    void destroying(Handle h) override {
        reported.push_back({"destroying " + tree_.path(h), tree_.cause().writer, tree_.step()});
    }
    std::vector<Report> reported;

  private:
    Tree& tree_;
};

struct Fixture {
    Fixture() {
        ClassDescriptor keeper{.name = "Keeper"};
        keeper.properties = {{.name = "score", .range = {.max = 10}},
                             {.name = "at", .type = Type::vec2},
                             {.name = "lives", .type = Type::integer},
                             {.name = "best", .nullable = true}};
        kept = tree.create(tree.define(std::move(keeper)), tree.root(), "kept");
    }
    const Property& of(Handle instance, const char* name) { return tree.property(instance, name); }

    Tree tree;
    BallModule module{tree};
    Handle ball = tree.create(*module.type, tree.root(), "ball");
    Handle kept;
};

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE_METHOD(Fixture, "numbers and vectors are written and read without a Value in between") {
    CHECK(tree.write(ball, of(ball, "mass"), 2.5));
    CHECK(tree.write(ball, of(ball, "velocity"), Vec2(1, -2)));
    CHECK(tree.write(ball, of(ball, "radius"), 0.75));
    CHECK(tree.write(kept, of(kept, "score"), 7.0));
    CHECK(tree.write(kept, of(kept, "at"), Vec2(3, 4)));
    CHECK(module.ball(ball).mass == 2.5f);
    CHECK(module.ball(ball).velocity[1] == -2.0f);
    CHECK(module.ball(ball).radius == 0.75);
    CHECK(tree.get(kept, "score") == Value(7.0));
    CHECK(tree.get(kept, "at") == Value(Vec2(3, 4)));

    double number = 0;
    Vec2 vector(0, 0);
    CHECK(tree.read(ball, of(ball, "mass"), number));
    CHECK(number == 2.5);
    CHECK(tree.read(kept, of(kept, "score"), number));
    CHECK(number == 7.0);
    CHECK(tree.read(ball, of(ball, "velocity"), vector));
    CHECK(vector == Vec2(1, -2));
    CHECK(tree.read(ball, of(ball, "area"), number));  // read-only, but readable as a number
    CHECK(number == 3 * 0.75 * 0.75);
}

TEST_CASE_METHOD(Fixture, "a value is rounded to the type of the memory before it is compared") {
    const Property& mass = of(ball, "mass");
    module.ball(ball).awake = false;
    CHECK(tree.write(ball, mass, 0.1));
    CHECK(module.ball(ball).awake);  // the wake function of the module was called
    module.ball(ball).awake = false;
    CHECK(tree.write(ball, mass, 0.1));
    CHECK_FALSE(module.ball(ball).awake);
}

TEST_CASE_METHOD(Fixture, "the typed functions leave special cases to get and set") {
    double number = 0;
    Vec2 vector(0, 0);
    CHECK_FALSE(tree.write(ball, of(ball, "mass"), -1.0));
    CHECK_FALSE(tree.write(ball, of(ball, "mass"), infinite));
    CHECK_FALSE(tree.write(ball, of(ball, "mass"), 1e300));
    CHECK_FALSE(tree.write(ball, of(ball, "mass"), std::nan("")));
    CHECK_FALSE(tree.write(ball, of(ball, "velocity"), Vec2(0, std::nan(""))));
    CHECK_FALSE(tree.write(ball, of(ball, "charge"), 11.0));  // must be clamped
    CHECK_FALSE(tree.write(ball, of(ball, "area"), 1.0));
    CHECK_FALSE(tree.write(ball, of(ball, "velocity"), 1.0));
    CHECK_FALSE(tree.write(kept, of(kept, "lives"), 1.0));
    CHECK_FALSE(tree.write(kept, of(kept, "best"), 1.0));
    CHECK_FALSE(tree.read(kept, of(kept, "best"), number));
    CHECK_FALSE(tree.read(ball, of(ball, "mass"), vector));
    CHECK(module.ball(ball).mass == 1.0f);
    CHECK(module.ball(ball).charge == 0.0);

    const Property& mass = of(ball, "mass");
    const Connection watch = tree.watch(ball, mass, [](const Change&) {});
    CHECK_FALSE(tree.write(ball, mass, 3.0));
    Connection(watch).stop();
    CHECK(tree.write(ball, mass, 3.0));
    tree.set_formula(ball, mass, {.function = [](const Tree&) { return Value(4.0); }});
    CHECK_FALSE(tree.write(ball, mass, 5.0));
    CHECK_FALSE(tree.read(ball, mass, number));
    tree.destroy(ball);
    CHECK_FALSE(tree.write(ball, mass, 6.0));
    CHECK_FALSE(tree.read(ball, mass, number));
}

TEST_CASE_METHOD(Fixture, "the typed functions refuse edits of a person because of the history") {
    const Tree::CauseScope console(tree, Writer::console);
    CHECK_FALSE(tree.write(ball, of(ball, "mass"), 2.0));
    tree.set(ball, "mass", 2.0);
    CHECK(tree.history().size() == 1);
}

TEST_CASE_METHOD(Fixture, "a formula read inside a setter is read again after the write") {
    // The formula depends on the cell in a way that is not declared.
    struct Gauge {
        Tree& tree;
        double level = 0, seen = 0;
        Handle reader;
    } gauge{.tree = tree, .reader = {}};
    ClassDescriptor tank{.name = "Tank"};
    Property level{.name = "level"};
    level.binding = accessor(
        gauge, [](Gauge& g, Row) { return g.level; },
        [](Gauge& g, Row, const Value& v) {
            g.seen = g.tree.get(g.reader, "mass").number();
            g.level = v.number();
        });
    tank.properties = {level};
    ClassDescriptor dial{.name = "Dial"};
    Property shown{.name = "shown", .read_only = true};
    shown.binding = accessor(gauge, [](Gauge& g, Row) { return g.level; });
    dial.properties = {shown};
    const Handle full = tree.create(tree.define(std::move(tank)), tree.root(), "tank");
    const Handle read = tree.create(tree.define(std::move(dial)), tree.root(), "dial");
    gauge.reader = ball;
    tree.set_formula(ball, "mass",
                     {[&](const Tree& t) { return Value(t.get(read, "shown").number() + 1); }, {}});

    for (const double wanted : {1.0, 2.0, 3.0}) {
        CHECK(tree.write(full, of(full, "level"), wanted));
        CHECK(gauge.seen == wanted);  // computed from the level before the write
        CHECK(tree.get(ball, "mass").number() == wanted + 1);
    }
}

TEST_CASE_METHOD(Fixture, "a refusal of a setter is reported by the typed functions too") {
    CHECK(message_of([&] { tree.write(ball, of(ball, "radius"), 13.0); }) ==
          "ball.radius: thirteen brings bad luck");
    CHECK(module.ball(ball).radius == 0.5);
}

TEST_CASE_METHOD(Fixture,
                 "observers are notified of typed writes in order and before other reports") {
    Listener listener(tree);
    const Property& mass = of(ball, "mass");
    tree.set_step(5);
    {
        const Tree::CauseScope script(tree, Writer::script);
        tree.write(ball, mass, 2.0);
        tree.write(ball, of(ball, "velocity"), Vec2(1, 2));
        tree.write(ball, mass, 2.0);  // an unchanged value
        tree.set(ball, mass, 3.0);
        CHECK(listener.reported.size() == 3);
        tree.write(ball, mass, 4.0);
    }
    tree.write(ball, mass, 5.0);
    tree.set_step(6);
    tree.write(ball, mass, 6.0);
    tree.destroy(ball);
    tree.write(kept, of(kept, "score"), 1.0);
    tree.barrier();
    std::string all;
    for (const Report& reported : listener.reported)
        all += reported.what + " by " + std::string(writer_name(reported.writer)) + " at " +
               std::to_string(reported.step) + "; ";
    CHECK(all ==
          "mass = 2 by script at 5; velocity = vec(1, 2) by script at 5; mass = 3 by script at 5; "
          "mass = 4 by script at 5; mass = 5 by module at 5; mass = 6 by module at 6; destroying "
          "ball by module at 6; score = 1 by module at 6; ");
}

TEST_CASE_METHOD(Fixture, "a change caused by a write of a callback has that cause") {
    std::string cause;
    int calls = 0;
    auto locate = std::function<std::string()>([&] { return ++calls, std::string("main.lua:7"); });
    const Connection watch = tree.watch(ball, of(ball, "velocity"),
                                        [&](const Change& change) { cause = change.cause.text(); });
    tree.set_step(3);
    {
        const Tree::CauseScope script(tree, Writer::script, &locate);
        tree.write(kept, of(kept, "score"), 2.0);
        module.ball(ball).velocity[0] = 9;  // as a setter of the module may do
    }
    tree.barrier();
    CHECK(cause == "script, step 3");
    CHECK(calls == 0);  // finding the line costs more than the limit for a callback

    // While a derived property is watched, an edit of its sources has its place as cause.
    const Connection derived = tree.watch(
        ball, of(ball, "area"), [&](const Change& change) { cause = change.cause.text(); });
    {
        const Tree::CauseScope script(tree, Writer::script, &locate);
        tree.write(kept, of(kept, "score"), 3.0);
        module.ball(ball).dirty = true;
        module.ball(ball).radius = 2;
    }
    tree.barrier();
    CHECK(cause == "main.lua:7, step 3");
}

TEST_CASE_METHOD(Fixture, "the fast write reports the value in memory and not the argument") {
    Listener listener(tree);
    const Property& velocity = of(ball, "velocity");
    const Vec2 given(0.1, 0.2);
    CHECK(tree.write(ball, velocity, given));
    CHECK(tree.write(ball, velocity, given));  // the cell has it already
    CHECK(module.ball(ball).velocity[1] == 0.2f);
    CHECK_FALSE(tree.write(ball, velocity, Vec2(0x1p24 + 1, 0)));  // no float equals that number
    tree.barrier();
    REQUIRE(listener.reported.size() == 1);
    const Vec2 held(static_cast<double>(0.1f), static_cast<double>(0.2f));
    CHECK(listener.reported[0].what == "velocity = " + tree.text(Value(held)));
    CHECK(tree.last_writer(ball, of(ball, "charge")).known == false);
}

TEST_CASE_METHOD(Fixture, "a watcher and a cause and a formula apply to fast writes at once") {
    const Property& charge = of(ball, "charge");
    double next = 0;
    const auto write = [&] {
        if (!tree.write(ball, charge, ++next)) tree.set(ball, charge, Value(next));
        tree.barrier();
    };
    write();
    {
        int told = 0;
        const Connection watch = tree.watch(*module.type, &charge, [&](const Change&) { ++told; });
        write();
        CHECK(told == 1);
        Connection(watch).stop();
        write();
        CHECK(told == 1);
    }
    CHECK_FALSE(tree.last_writer(ball, charge).cause.writer == Writer::console);
    {
        const Tree::CauseScope console(tree, Writer::console);
        write();
        CHECK(tree.last_writer(ball, charge).cause.writer == Writer::console);
    }
    bool refused = false;
    tree.set_formula(kept, of(kept, "score"), {.function = [&](const Tree&) {
                         refused = !tree.write(ball, charge, 1.0);
                         return Value(1.0);
                     }});
    CHECK(tree.get(kept, "score") == Value(1.0));
    CHECK(refused);
    write();
    CHECK(tree.get(ball, charge) == Value(next));
}

TEST_CASE_METHOD(Fixture, "a shadow of any cell keeps the last writer until it ends") {
    const Handle other = tree.create(*module.type, tree.root(), "other");
    const Property& charge = of(other, "charge");
    std::string cause;
    Connection watch = tree.watch(ball, of(ball, "velocity"),
                                  [&](const Change& change) { cause = change.cause.text(); });
    const auto write_and_move = [&](std::uint64_t step, double value) {
        tree.set_step(step);
        const Tree::CauseScope script(tree, Writer::script);
        CHECK(tree.write(other, charge, value));
        module.ball(ball).velocity[0] += 1;  // as a setter of the module may do
    };
    write_and_move(3, 2.0);
    tree.barrier();
    CHECK(cause == "script, step 3");
    watch.stop();
    write_and_move(4, 3.0);
    watch = tree.watch(ball, of(ball, "velocity"),
                       [&](const Change& change) { cause = change.cause.text(); });
    write_and_move(5, 4.0);
    tree.barrier();
    CHECK(cause == "script, step 5");
}

}  // namespace typed_access_test
