// Onion skins: earlier and later poses of the selected instance.

#include <algorithm>

#include "catch.h"
#include "rig.h"

namespace onion_skins_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

/// A game in which `world.ball` moves to the right, with `view.show.onion_skins`.
struct SkinnedRig : Rig {
    std::int64_t now = 0;
    int reads = 0;
    SkinnedRig() {
        property::ClassDescriptor show;
        show.name = "Show";
        show.snapshots = property::Snapshots::never;
        show.properties = {{.name = "onion_skins",
                            .type = Type::boolean,
                            .default_value = Value(false),
                            .doc = "An overlay.",
                            .transient = true}};
        property::ClassDescriptor view;
        view.name = "View";
        const Handle of = tree.create(tree.define(std::move(view)), tree.root(), "view");
        tree.create(tree.define(std::move(show)), of, "show");
        key("grave");
        draw(2);
        state().options.review = [this](std::int64_t from, std::int64_t to, const auto& visit) {
            ++reads;
            const auto here = static_cast<std::int64_t>(tree.step());
            for (std::int64_t n = std::max<std::int64_t>(0, from); n <= std::min(now, to); ++n) {
                place(n);
                visit(n);
            }
            place(here);
        };
        console.select(ball());
        property::set(tree, "view.show.onion_skins", Value(true));
    }
    Handle ball() { return tree.child(tree.child(tree.root(), "world"), "ball"); }
    void place(std::int64_t n) {
        const property::Tree::CauseScope cause(tree, property::Writer::simulation);
        tree.set_step(static_cast<std::uint64_t>(n));
        property::set(tree, "world.ball.position", Value(Vec2(0.1 * static_cast<double>(n), -4)));
    }
    void step_to(std::int64_t n) {
        for (; now < n; console.after_step(), console.between_frames()) place(++now);
    }
    const console::OnionSkins& skins() { return state().onion_skins; }
};

}  // namespace

TEST_CASE_METHOD(SkinnedRig, "onion skins are poses at regular intervals before the present") {
    step_to(50);
    CHECK(skins().shown_at(50) == std::vector<std::int64_t>{0, 15, 30, 45});
    CHECK(skins().skins().size() >= 50);
    for (const auto& skin : skins().skins())
        CHECK(skin.pose.origin.x == Approx(0.1 * static_cast<double>(skin.step)));
}

TEST_CASE_METHOD(SkinnedRig, "after going back the later poses are skins too") {
    step_to(60);
    place(20);
    CHECK(skins().shown_at(20) == std::vector<std::int64_t>{0, 15, 30, 45, 60});
    // The game continues from there: the later poses are removed.
    now = 20;
    step_to(22);
    CHECK(skins().shown_at(22) == std::vector<std::int64_t>{0, 15});
}

TEST_CASE_METHOD(SkinnedRig, "onion skins are along the whole past and are read when needed") {
    property::set(tree, "view.show.onion_skins", Value(false));
    step_to(2000);
    property::set(tree, "view.show.onion_skins", Value(true));
    console.between_frames();
    CHECK(reads == 1);
    step_to(2100);
    CHECK(reads == 1);  // new steps are recorded without reading the past
    const auto shows_all_around = [&](std::int64_t step) {
        place(step);
        console.between_frames();
        const auto shown = skins().shown_at(step);
        constexpr int both = 2 * (console::OnionSkins::drawn + 1);
        CHECK(shown.size() == (step % console::OnionSkins::apart == 0 ? both - 1 : both));
        CHECK(shown.front() < step);
        CHECK(shown.back() > step);
        for (const auto& skin : skins().skins())
            CHECK(skin.pose.origin.x == Approx(0.1 * static_cast<double>(skin.step)));
    };
    shows_all_around(507);
    CHECK(reads == 2);
    for (std::int64_t step = 508; step < 550; ++step) shows_all_around(step);
    CHECK(reads == 2);
    for (std::int64_t step = 560; step > 200; step -= 10) shows_all_around(step + 7);
    CHECK(reads < 12);
    place(2100);
    console.between_frames();
    CHECK(skins().shown_at(2100).size() == console::OnionSkins::drawn);
    // The game goes on from an earlier step.
    place(1007);
    console.between_frames();
    now = 1007;
    step_to(1010);
    CHECK(skins().shown_at(1010).back() == 1005);
    CHECK(skins().skins().back().step == 1010);
}

TEST_CASE_METHOD(SkinnedRig, "the number of poses of onion skins is limited") {
    const auto most = static_cast<std::int64_t>(console::OnionSkins::most);
    step_to(most + 500);
    CHECK(skins().skins().size() == console::OnionSkins::most);
    const int before = reads;
    place(200);
    for (int i = 0; i < 5; ++i) console.between_frames();
    CHECK(reads == before + 1);
    CHECK(skins().skins().size() <= console::OnionSkins::most);
    CHECK(skins().shown_at(200).size() > 20);
}

TEST_CASE_METHOD(SkinnedRig,
                 "onion skins read the past when they are shown and end with their instance") {
    property::set(tree, "view.show.onion_skins", Value(false));
    step_to(40);
    CHECK(skins().skins().empty());
    property::set(tree, "view.show.onion_skins", Value(true));
    console.between_frames();
    CHECK(skins().shown_at(40) == std::vector<std::int64_t>{0, 15, 30});
    tree.destroy(ball());
    console.between_frames();
    draw();
    CHECK(skins().skins().empty());
}

}  // namespace onion_skins_test
