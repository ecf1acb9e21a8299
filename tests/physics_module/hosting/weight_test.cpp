// The estimate of the memory that a game takes, compared with what the allocator counts.

#include "catch.h"

#include <functional>

#include <malloc.h>

#include "game.h"

namespace weight_test {

using namespace fettle::physics_module::testing;

namespace {

double allocated() {
    const struct mallinfo2 all = mallinfo2();
    return double(all.uordblks) + double(all.hblkhd);
}

struct Sample {
    const char* name;
    int count;
    std::function<void(Game&, int)> make;
};

List zigzag(int count) {
    List points;
    for (int i = 0; i < count; ++i) points.push_back(Vec2(i, i % 2));
    return points;
}

}  // namespace

TEST_CASE("the estimated memory of bodies is close to their real memory") {
    if (allocated() == 0) return;  // the allocator of a sanitizer does not count
    const Sample sample = GENERATE(
        Sample{"circles", 5000, [](Game& g, int i) { g.body("Circle", Vec2(3 * i, 0)); }},
        Sample{"boxes", 5000, [](Game& g, int i) { g.body("Box", Vec2(3 * i, 0)); }},
        Sample{"fixed boxes", 5000,
               [](Game& g, int i) { g.body("Box", Vec2(3 * i, 0), "static"); }},
        Sample{"a row of boxes that touch", 5000,
               [](Game& g, int i) { g.body("Box", Vec2(1.0 * i, 0)); }},
        Sample{"boxes that touch on all sides", 5000,
               [](Game& g, int i) { g.body("Box", Vec2(1.0 * (i % 70), 1.0 * (i / 70))); }},
        Sample{"chains", 5,
               [](Game& g, int i) {
                   const Handle body = g.make("Body", g.world(),
                                              {{"type", "static"}, {"position", Vec2(0, 10 * i)}});
                   g.make("Chain", body, {{"points", zigzag(1000)}});
               }},
        Sample{"joints", 3000, [](Game& g, int i) {
                   const Handle body = g.body("Circle", Vec2(3 * i, 0));
                   g.make("RevoluteJoint", g.world(),
                          {{"body_a", body}, {"anchor_b", Vec2(3 * i, 0)}});
               }});
    CAPTURE(sample.name);
    Game game;
    game.step();
    const double memory = allocated();
    const auto weight = double(game.tree.weight());
    for (int i = 0; i < sample.count; ++i) sample.make(game, i);
    game.step(3);
    const double ratio = (double(game.tree.weight()) - weight) / (allocated() - memory);
    CAPTURE(ratio);
    CHECK(ratio > 0.7);
    CHECK(ratio < 1.8);
}

}  // namespace weight_test
