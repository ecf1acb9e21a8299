#include <cmath>

#include <fettle/property/formula_problems.h>

#include "catch.h"
#include "fixture.h"

namespace formulas_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    Handle ball = tree.create(*module.type, world, "ball");
    Handle shadow = tree.create(*module.type, world, "shadow");
    int runs = 0;

    Formula count(std::function<Value(const Tree&)> f, std::string source = {}) {
        return {[this, f](const Tree& t) {
                    ++runs;
                    return f(t);
                },
                std::move(source)};
    }
    double number(const std::string& path) { return get(tree, path).as_double(); }
};
}  // namespace

TEST_CASE_METHOD(Fixture, "a formula computes the value and follows its sources at once") {
    tree.set_formula(shadow, "mass",
                     count([&](const Tree& t) { return Value(t.get(ball, "mass").number() * 2); }));
    CHECK(number("world.shadow.mass") == 2);
    tree.set(ball, "mass", 5);
    CHECK(number("world.shadow.mass") == 10);
    CHECK(number("world.shadow.mass") == 10);
    CHECK(runs == 2);
    CHECK(module.ball(shadow).mass == 10);
}

TEST_CASE_METHOD(Fixture, "any property that accepts a formula can be in a snapshot with it") {
    for (const Property* property : tree.properties(ball)) {
        INFO(property->name);
        const Value value = tree.peek(ball, *property);
        try {
            tree.set_formula(ball, *property, count([value](const Tree&) { return value; }));
        } catch (const Error& error) {
            CHECK_THAT(error.what(), contains("world.ball." + property->name));
            continue;
        }
        tree.restore(tree.snapshot());
        CHECK(tree.formula(ball, *property) != nullptr);
        tree.remove_formula(ball, *property);
    }
    for (const char* name : {"name", "parent"})
        CHECK_THROWS_WITH(tree.set_formula(ball, name, count([](const Tree&) { return Value(1); })),
                          contains("cannot have a formula"));
}

TEST_CASE_METHOD(Fixture,
                 "a formula that is not read settles at the barrier and its change is reported") {
    std::vector<std::string> log;
    tree.set_formula(shadow, "mass", count([&](const Tree& t) { return t.get(ball, "mass"); }));
    tree.barrier();
    tree.watch(shadow, "mass",
               [&](const Change& c) { log.push_back(tree.text(c.new_value) + c.cause.text()); });
    tree.set(ball, "mass", 3);
    tree.set(ball, "mass", 4);
    tree.barrier();
    CHECK(module.ball(shadow).mass == 4);
    CHECK(log == std::vector<std::string>{"4formula, step 0"});
    CHECK(runs == 2);
}

TEST_CASE_METHOD(Fixture, "two paths to one source cause one computation with consistent values") {
    for (const char* name : {"left", "right", "top"}) tree.set_or_add(world, name, 0.0);
    tree.set_formula(world, "left",
                     count([&](const Tree& t) { return Value(t.get(ball, "mass").number() + 1); }));
    tree.set_formula(world, "right",
                     count([&](const Tree& t) { return Value(t.get(ball, "mass").number() - 1); }));
    bool half = false;
    tree.set_formula(world, "top", count([&](const Tree& t) {
                         const double l = t.get(world, "left").number(),
                                      r = t.get(world, "right").number();
                         half = half || l - r != 2;
                         return Value(l + r);
                     }));
    CHECK(number("world.top") == 2);
    runs = 0;
    tree.set(ball, "mass", 10);
    CHECK(number("world.top") == 20);
    CHECK(runs == 3);
    CHECK_FALSE(half);
}

TEST_CASE_METHOD(Fixture, "an unchanged result does not update its dependents") {
    int ends = 0;
    tree.set_formula(world, "sign",
                     count([&](const Tree& t) { return Value(t.get(ball, "mass").number() > 3); }));
    tree.set_formula(world, "end", {[&](const Tree& t) {
                         ++ends;
                         return t.get(world, "sign");
                     }});
    tree.barrier();
    CHECK(ends == 1);
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(runs == 2);
    CHECK(ends == 1);
    tree.set(ball, "mass", 4);
    CHECK(get(tree, "world.end") == Value(true));
    CHECK(ends == 2);
}

TEST_CASE_METHOD(Fixture, "a source that is not read is not a dependency") {
    tree.set_formula(world, "pick", count([&](const Tree& t) {
                         return t.get(ball, "mass").number() > 5 ? t.get(shadow, "mass")
                                                                 : Value(0.0);
                     }));
    tree.barrier();
    tree.set(shadow, "mass", 7);
    tree.barrier();
    CHECK(runs == 1);
    tree.set(ball, "mass", 6);
    CHECK(number("world.pick") == 7);
    tree.set(shadow, "mass", 8);
    CHECK(number("world.pick") == 8);
    CHECK(runs == 3);
}

TEST_CASE_METHOD(
    Fixture,
    "a formula of simulated and derived values is up to date when read and after the step") {
    tree.set_formula(world, "speed", count([&](const Tree& t) {
                         return Value(t.get(ball, "velocity").vec2().length());
                     }));
    tree.set_formula(world, "double", count([&](const Tree& t) {
                         return Value(2 * t.get(world, "speed").number());
                     }));
    tree.set_formula(world, "size", count([&](const Tree& t) { return t.get(ball, "area"); }));
    tree.barrier();
    module.ball(ball).velocity[0] = 3;
    tree.set_step(1);
    tree.stepped();
    tree.barrier();
    CHECK(number("world.double") == 6);
    tree.set(ball, "velocity", Vec2(0, 4));
    CHECK(number("world.double") == 8);
    tree.set(ball, "radius", 1.0);
    CHECK(number("world.size") == 3);
    const int before = runs;
    tree.set_step(2);
    tree.stepped();
    tree.barrier();
    CHECK(runs == before);
}

TEST_CASE_METHOD(Fixture, "the simulation does not change a value that a formula sets") {
    tree.set_formula(shadow, "velocity",
                     {[&](const Tree& t) { return Value(Vec2(t.get(ball, "mass").number(), 0)); }});
    tree.barrier();
    module.ball(shadow).velocity[0] = 99;
    tree.set_step(1);
    tree.stepped();
    tree.barrier();
    CHECK(module.ball(shadow).velocity[0] == 1);
}

TEST_CASE_METHOD(Fixture, "a cycle is an error with its path and ends when the cycle is broken") {
    tree.set_formula(ball, "mass",
                     {[&](const Tree& t) { return Value(t.get(shadow, "mass").number() + 1); }});
    tree.set_formula(shadow, "mass",
                     {[&](const Tree& t) { return Value(t.get(ball, "mass").number() + 1); }});
    CHECK_THAT(message_of([&] { tree.get(ball, "mass"); }),
               contains("world.ball.mass → world.shadow.mass → world.ball.mass"));
    tree.barrier();
    CHECK(module.ball(ball).mass == 1);  // the last good value
    tree.set(shadow, "mass", 5);
    CHECK(tree.formula(shadow, tree.property(shadow, "mass")) == nullptr);
    CHECK(number("world.ball.mass") == 6);
}

TEST_CASE_METHOD(Fixture, "an error keeps the last valid value and names the path to it") {
    tree.set_formula(shadow, "mass",
                     {[&](const Tree& t) { return Value(4 - t.get(ball, "mass").number()); }});
    tree.set_formula(world, "top", {[&](const Tree& t) { return t.get(shadow, "mass"); }});
    CHECK(number("world.top") == 3);
    tree.set(ball, "mass", 9);
    const std::string message = message_of([&] { tree.get(world, "top"); });
    CHECK_THAT(message, contains("world.top is in error: world.shadow.mass is in error") &&
                            contains("got -5"));
    CHECK(module.ball(shadow).mass == 3);
    CHECK_THAT(tree.problem(shadow, tree.property(shadow, "mass")),
               contains("at least") || contains("from 0"));
    tree.set(ball, "mass", 1);
    CHECK(number("world.top") == 3);
    CHECK(tree.problem(world, tree.property(world, "top")).empty());
}

TEST_CASE_METHOD(Fixture, "deleting a source gives an error and restoring it ends the error") {
    tree.set_formula(shadow, "mass", {[](const Tree& t) { return get(t, "world.ball.mass"); }});
    CHECK(number("world.shadow.mass") == 1);
    tree.destroy(ball);
    tree.barrier();
    CHECK_THAT(message_of([&] { tree.get(shadow, "mass"); }),
               contains("world has no property \"ball\""));
    CHECK(module.ball(shadow).mass == 1);
    const Handle again = tree.create(*module.type, world, "ball");
    tree.set(again, "mass", 6);
    CHECK(number("world.shadow.mass") == 6);
    tree.rename(again, "other");
    CHECK_FALSE(tree.problem(shadow, tree.property(shadow, "mass")).empty());
    tree.rename(again, "ball");
    CHECK(number("world.shadow.mass") == 6);
}

TEST_CASE_METHOD(Fixture, "a formula recovers when a missing source is created") {
    tree.set_formula(world, "score", {[](const Tree& t) {
                         return Value(get(t, "world.ball.lives").integer() * 10);
                     }});
    CHECK_FALSE(tree.problem(world, tree.property(world, "score")).empty());
    tree.set_or_add(ball, "lives", 3);
    CHECK(get(tree, "world.score") == Value(30));
    tree.remove_ad_hoc(ball, "lives");
    CHECK_FALSE(tree.problem(world, tree.property(world, "score")).empty());
}

TEST_CASE_METHOD(Fixture, "a formula may not write") {
    tree.set_formula(world, "bad", {[&](const Tree&) {
                         tree.set(ball, "mass", 3);
                         return Value(1);
                     }});
    CHECK_THAT(message_of([&] { tree.get(world, "bad"); }), contains("cannot write"));
    CHECK(module.ball(ball).mass == 1);
    CHECK_FALSE(tree.in_formula());
    CHECK_THROWS_AS(tree.set_formula(ball, "area", {[](const Tree&) { return Value(1.0); }}),
                    Error);
}

TEST_CASE_METHOD(Fixture, "why lists the sources of a value with their values") {
    tree.set_formula(
        shadow, "mass",
        {[&](const Tree& t) { return Value(t.get(ball, "mass").number() * 2); }, "ball.mass * 2"});
    tree.set_formula(world, "top",
                     {[&](const Tree& t) { return t.get(shadow, "mass"); }, "shadow.mass"});
    const Explanation why = tree.why(world, tree.property(world, "top"));
    CHECK(why.path == "world.top");
    CHECK(why.source == "shadow.mass");
    REQUIRE(why.from.size() == 1);
    CHECK(why.from[0].path == "world.shadow.mass");
    CHECK(why.from[0].value == "2 kg");
    REQUIRE(why.from[0].from.size() == 1);
    CHECK(why.from[0].from[0].value == "1 kg");
    CHECK(why.from[0].from[0].source.empty());
}

TEST_CASE_METHOD(Fixture, "a formula ends with its instance") {
    tree.set_formula(shadow, "mass", {[&](const Tree& t) { return t.get(ball, "mass"); }});
    tree.barrier();
    tree.destroy(shadow);
    CHECK(tree.formula_count() == 0);
    tree.set(ball, "mass", 4);
    tree.barrier();
}

TEST_CASE_METHOD(
    Fixture,
    "ten thousand formulas in chains and fans and grids have the values of a full recomputation") {
    const Handle grid = tree.create(tree.object_class(), tree.root(), "grid");
    const int width = 50, height = 200;
    const auto name = [](int x, int y) {
        return "c" + std::to_string(x) + "x" + std::to_string(y);
    };
    std::vector<double> source(width, 1), model(width);
    for (int x = 0; x < width; ++x) tree.set_or_add(grid, name(x, 0), 1.0);
    // Created from the far end, so that the first read has the full depth.
    for (int y = height - 1; y > 0; --y)
        for (int x = 0; x < width; ++x) {
            const std::string above = name(x, y - 1), beside = name((x + 1) % width, y - 1),
                              far = name(7, 0);
            tree.set_formula(
                grid, name(x, y), count([=](const Tree& t) {
                    const double a = t.get(grid, above).number(), b = t.get(grid, beside).number();
                    // Every fifth row reads its second source only if the first is large.
                    if (y % 5 == 0)
                        return Value(a > 1.5 ? std::fmod(a + b, 3.0) : t.get(grid, far).number());
                    return Value(std::fmod(a + 0.5 * b, 3.0));
                }));
        }
    CHECK(tree.formula_count() == std::size_t(width * (height - 1)));
    const auto recompute = [&] {
        std::vector<double> row = source;
        for (int y = 1; y < height; ++y) {
            std::vector<double> next(width);
            for (int x = 0; x < width; ++x) {
                const double a = row[std::size_t(x)], b = row[std::size_t((x + 1) % width)];
                next[std::size_t(x)] = y % 5 == 0 ? (a > 1.5 ? std::fmod(a + b, 3.0) : source[7])
                                                  : std::fmod(a + 0.5 * b, 3.0);
            }
            row = next;
        }
        return row;
    };
    const auto same = [&] {
        model = recompute();
        int wrong = 0;
        for (int x = 0; x < width; ++x)
            wrong += tree.get(grid, name(x, height - 1)).number() != model[std::size_t(x)];
        return wrong;
    };
    CHECK(same() == 0);
    std::uint32_t seed = 1;
    for (int i = 0; i < 30; ++i) {
        seed = seed * 1664525u + 1013904223u;
        const int x = static_cast<int>(seed >> 16) % width;
        source[std::size_t(x)] = static_cast<double>(seed >> 8 & 7u) / 4;
        tree.set(grid, name(x, 0), source[std::size_t(x)]);
        if (i % 3 == 0) tree.barrier();
        CHECK(same() == 0);
    }
    tree.barrier();
    const int before = runs;
    tree.barrier();
    CHECK(runs == before);
}

TEST_CASE_METHOD(Fixture, "a formula in error is reported once at a barrier") {
    std::vector<std::string> reported;
    on_formula_problem(tree, [&](const FormulaProblem& problem) {
        reported.push_back(problem.path + ": " + problem.message);
    });
    std::string wrong = "broke";
    tree.set_formula(shadow, "mass", count([&](const Tree& t) {
                         const Value mass = t.get(ball, "mass");
                         if (!wrong.empty()) throw std::runtime_error(wrong);
                         return mass;
                     }));
    // Fails only because the other fails.
    tree.set_formula(world, "sum", count([&](const Tree& t) { return t.get(shadow, "mass"); }));
    tree.barrier();
    tree.barrier();
    CHECK(reported == std::vector<std::string>{"world.shadow.mass: broke"});
    tree.set(ball, "mass", 3);
    tree.barrier();
    tree.restore(tree.snapshot());
    tree.barrier();
    CHECK(reported.size() == 1);
    wrong = "broke again";
    tree.set(ball, "mass", 4);
    tree.barrier();
    REQUIRE(reported.size() == 2);
    CHECK(reported.back() == "world.shadow.mass: broke again");
    // The same error with another number in it is not reported again.
    for (const char* text : {"at 1.5, not from 0 to 1", "at -2.25e-05, not from 0 to 1"}) {
        wrong = text;
        tree.set(ball, "mass", 8 + tree.get(ball, "mass").number());
        tree.barrier();
        REQUIRE(reported.size() == 3);
    }
    reported.pop_back();
    // An error after a valid value is reported again.
    wrong.clear();
    tree.set(ball, "mass", 5);
    tree.barrier();
    wrong = "broke again";
    tree.set(ball, "mass", 6);
    tree.barrier();
    CHECK(reported.size() == 3);
    // A value of the wrong type, and a cycle.
    reported.clear();
    tree.set_formula(shadow, "mass", count([](const Tree&) { return Value("text"); }));
    tree.set_or_add(world, "left", 0.0);
    tree.set_or_add(world, "right", 0.0);
    tree.set_formula(world, "left", count([&](const Tree& t) { return t.get(world, "right"); }));
    tree.set_formula(world, "right", count([&](const Tree& t) { return t.get(world, "left"); }));
    tree.barrier();
    REQUIRE(reported.size() == 2);
    CHECK_THAT(reported[0], contains("world.shadow.mass") && contains("number"));
    CHECK_THAT(reported[1], contains("it depends on itself"));
    // An error that a caller has already received is not reported.
    reported.clear();
    tree.set_formula(shadow, "mass",
                     count([](const Tree&) -> Value { throw std::runtime_error("shown"); }));
    (void)tree.problem(shadow, tree.property(shadow, "mass"));
    formula_problem_reported(tree, shadow, tree.property(shadow, "mass"));
    tree.barrier();
    CHECK(reported.empty());
}
}  // namespace formulas_test
