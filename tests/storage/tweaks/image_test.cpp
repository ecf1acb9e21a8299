// Special values in the journal: a tweak that is made again sets them bit for bit.

#include <cmath>

#include "catch.h"
#include "tweak_run.h"

namespace image_test {

using namespace scene_test;

TEST_CASE("a tweak that is made again or kept sets exactly the same value") {
    const std::vector<Value> values = {
        Value(true),
        Value(-2),
        Value(INT64_MIN),
        Value(INT64_MAX),
        Value(std::int64_t{9007199254740993}),
        Value(-0.0),
        Value(5e-324),
        Value(infinity),
        Value(-infinity),
        Value(0.1),
        Value(""),
        Value(std::string(300'000, 'x')),
        Value(std::string("a\0b\xff\"\n%", 7)),
        Value(Vec2(-0.0, -infinity)),
        Value(Color{0.1f, 0.5f, 1, 0}),
        Value(List{Value(1), Value(1.0), Value(Vec2(1, 2)), Value("x"), Value(List{Value(2)})}),
        Value(List{}),
    };
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] {
            for (std::size_t i = 0; i < values.size(); ++i)
                run.tree.set_or_add(a, "v" + std::to_string(i), values[i]);
            run.tree.set(a, "gain", 0.3);
            run.tree.set(a, "offset", Vec2(0.1, 1e30));
            run.tree.set(a, "tint", Color{0.1f, 0.2f, 0.3f, 0.4f});
        });
        CHECK(run.tweaks->list().size() == values.size() + 3);
    }
    const auto check = [&](Run& run) {
        const Handle a = run.at("world.a");
        for (std::size_t i = 0; i < values.size(); ++i) {
            INFO(i);
            CHECK(run.tree.get(a, "v" + std::to_string(i)) == values[i]);
        }
        CHECK(run.tree.get(a, "gain") == Value(static_cast<double>(0.3f)));
        CHECK(run.tree.get(a, "offset") ==
              Value(Vec2(static_cast<double>(0.1f), static_cast<double>(1e30f))));
        CHECK(run.tree.get(a, "tint") == Value(Color{0.1f, 0.2f, 0.3f, 0.4f}));
    };
    {
        Run run(folder);
        run.add("Thing", "a");
        const Tree::CauseScope scope(run.tree, Writer::console);
        CHECK(run.tweaks->reapply("**").problems.empty());
        check(run);
        run.barrier();
        CHECK(run.tweaks->keep("**").count == values.size() + 3);
    }
    Run run(folder);
    run.tweaks->placed(run.add("Thing", "a"));
    CHECK(run.reported.empty());
    check(run);
}

}  // namespace image_test
