// The last writers of cells, with more writes than are kept, and the memory for them.

#include <map>
#include <random>

#include "catch.h"
#include "fixture.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FETTLE_OWN_MALLOC
#endif

namespace writes_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

struct Writing {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    std::vector<Handle> balls;

    void make(int count) {
        for (int i = 0; i < count; ++i) balls.push_back(tree.create(*module.type, world));
    }
    const Property& property(const char* name) const { return tree.property(balls[0], name); }
};

std::size_t memory_in_use() {
#if defined(__GLIBC__) && !defined(FETTLE_OWN_MALLOC)
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

}  // namespace

TEST_CASE_METHOD(Writing, "the last writer of each cell is known among very many writes") {
    make(700);
    const Property* const properties[] = {&property("mass"), &property("charge"),
                                          &property("radius")};
    std::mt19937 random(5);
    std::map<std::pair<std::uint32_t, const Property*>, std::pair<std::uint64_t, Writer>> expected;
    for (std::uint64_t step = 1; step <= 40; ++step) {
        tree.set_step(step);
        for (const Writer writer : {Writer::script, Writer::module}) {
            const Tree::CauseScope cause(tree, writer);
            for (int i = 0; i < 1500; ++i) {
                const Handle ball = balls[random() % balls.size()];
                const Property& of = *properties[random() % 3];
                const double value = static_cast<double>(random() % 1000) / 250;
                if (tree.get(ball, of).number() == value) continue;
                if (random() % 2 == 0)
                    tree.set(ball, of, value);
                else
                    REQUIRE(tree.write(ball, of, value));
                expected[{ball.index, &of}] = {step, writer};
            }
        }
    }
    int wrong = 0;
    for (const Handle ball : balls) {
        for (const Property* of : properties) {
            const Provenance who = tree.last_writer(ball, *of);
            const auto known = expected.find({ball.index, of});
            if (who.known != (known != expected.end()))
                ++wrong;
            else if (who.known && (who.cause.step != known->second.first ||
                                   who.cause.writer != known->second.second))
                ++wrong;
        }
    }
    CHECK(wrong == 0);
    // The next instance in a slot has no writer.
    tree.destroy(balls[7]);
    const Handle next = tree.create(*module.type, world);
    REQUIRE(next.index == balls[7].index);
    CHECK_FALSE(tree.last_writer(next, *properties[0]).known);
}

TEST_CASE_METHOD(Writing, "the writer is dropped after a quarter of a million later writes") {
    make(2);
    const Property& mass = property("mass");
    tree.set_step(1);
    REQUIRE(tree.write(balls[0], mass, 5.0));
    tree.set_step(2);
    for (int i = 0; i < 260'000; ++i) REQUIRE(tree.write(balls[1], mass, 10.0 + i % 2));
    CHECK(tree.last_writer(balls[0], mass).cause.step == 1);
    for (int i = 0; i < 3000; ++i) REQUIRE(tree.write(balls[1], mass, 10.0 + i % 2));
    CHECK_FALSE(tree.last_writer(balls[0], mass).known);
    CHECK(tree.last_writer(balls[1], mass).cause.step == 2);
}

TEST_CASE_METHOD(Writing, "the memory of an instance hardly grows with the numbers written to it") {
    if (memory_in_use() == 0) return;
    make(20'000);
    const Property* const properties[] = {&property("mass"), &property("charge"),
                                          &property("radius")};
    for (const Property* of : properties) tree.set(balls[0], *of, 2.0);
    const std::size_t before = memory_in_use();
    for (const Handle ball : balls)
        for (const Property* of : properties) tree.set(ball, *of, 3.0);
    const double each = static_cast<double>(memory_in_use() - before) / 20'000;
    CHECK(each < 3 * 5.5);  // bytes
}

TEST_CASE_METHOD(Writing, "a value restored by going back has the writer restore") {
    make(2);
    const Property& mass = property("mass");
    const Property& charge = property("charge");
    const auto write = [&](std::uint64_t step, const Property& of, double value) {
        tree.set_step(step);
        const Tree::CauseScope cause(tree, Writer::console);
        tree.set(balls[0], of, value);
    };
    write(10, mass, 5);
    tree.barrier();
    const Snapshot snapshot = tree.snapshot();
    write(20, charge, 2);
    write(30, charge, 3);
    tree.barrier();
    CHECK(tree.last_writer(balls[0], charge).cause.step == 30);
    tree.restore(snapshot);
    CHECK(tree.step() == 10);
    CHECK(tree.last_writer(balls[0], mass).cause.writer == Writer::console);
    CHECK(tree.last_writer(balls[0], mass).cause.step == 10);
    CHECK(tree.last_writer(balls[0], charge).cause.text() == "restore, step 10");
    write(12, charge, 4);
    CHECK(tree.last_writer(balls[0], charge).cause.text() == "console, step 12");
}
}  // namespace writes_test
