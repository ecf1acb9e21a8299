// What the console keeps of the past, after another branch of it has become the present one.

#include "catch.h"
#include "rig.h"

namespace branch_switch_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;
using property::Vec2;

namespace {

/// A game whose ball moves to the right in the branch "right" and to the left in the branch "left",
/// which part after step 40.
struct BranchedRig : Rig {
    static constexpr std::int64_t fork = 40;
    static inline const std::vector<property::Field> fields = {
        {.name = "name", .type = property::Type::text},
        {.name = "fork", .type = property::Type::integer},
        {.name = "newest", .type = property::Type::integer}};
    static inline bool has_parted = false;
    std::int64_t now = 0;
    int reads = 0;

    BranchedRig() {
        has_parted = false;
        property::ClassDescriptor time;
        time.name = "TimeWithBranches";
        time.properties.push_back({.name = "branch",
                                   .type = property::Type::text,
                                   .default_value = Value(std::string("right"))});
        time.methods.push_back(
            {.name = "branches",
             .returns = fields,
             .many = true,
             .call = [](void*, property::Tree& of, property::Handle, property::Row,
                        std::span<const Value>) -> property::Result {
                 std::vector<property::Record> others;
                 const bool right = property::get(of, "time.branch") == Value("right");
                 if (has_parted)
                     others.push_back({&fields,
                                       {Value(std::string(right ? "left" : "right")), Value(fork),
                                        Value(right ? 80 : 100)}});
                 return others;
             },
             .effect = property::Effect::nothing});
        property::ClassDescriptor show;
        show.name = "Show";
        show.properties = {
            {.name = "onion_skins", .type = property::Type::boolean, .default_value = Value(true)}};
        property::ClassDescriptor view;
        view.name = "View";
        tree.destroy(tree.child(tree.root(), "time"));
        tree.create(tree.define(std::move(time)), tree.root(), "time");
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
        console.select(tree.child(tree.child(tree.root(), "world"), "ball"));
        script::ConsoleFunctions functions = state().observing.functions();
        script::Observed position;
        position.text = position.path = "world.ball.position";
        position.value = [this] { return property::get(tree, "world.ball.position"); };
        functions.pin(position);
        functions.plot({position});
        console.between_frames();
    }
    double x_at(std::int64_t step) {
        const bool left = property::get(tree, "time.branch") == Value("left") && step > fork;
        return left ? -static_cast<double>(step) : static_cast<double>(step);
    }
    void place(std::int64_t n) {
        const property::Tree::CauseScope cause(tree, property::Writer::simulation);
        tree.set_step(static_cast<std::uint64_t>(n));
        property::set(tree, "world.ball.position", Value(Vec2(x_at(n), -4)));
    }
    void step_to(std::int64_t n) {
        for (; now < n; console.after_step(), console.between_frames()) place(++now);
    }
    void become(const char* branch, std::int64_t step) {
        const property::Tree::CauseScope cause(tree, property::Writer::simulation);
        property::set(tree, "time.branch", Value(std::string(branch)));
        now = step;
        place(step);
    }
    /// All that is kept is as it was in the present branch, without a gap.
    void check_kept(std::int64_t first) {
        const auto& skins = state().onion_skins.skins();
        REQUIRE_FALSE(skins.empty());
        CHECK(skins.back().step == now);
        for (const auto& skin : skins) CHECK(skin.pose.origin.x == x_at(skin.step));
        for (const auto* traces : {&state().observing.pins(), &state().observing.plots()})
            for (const console::Trace& trace : *traces) {
                REQUIRE(trace.samples().size() == static_cast<std::size_t>(now - first + 1));
                CHECK(trace.samples().back().step == now);
                for (const auto& sample : trace.samples()) CHECK(sample.x == x_at(sample.step));
            }
    }
};

}  // namespace

TEST_CASE_METHOD(
    BranchedRig,
    "a switch to another branch drops everything that the console kept of the former branch") {
    step_to(100);
    // The game goes on from an earlier step: what the console read up to that step is kept.
    const int before = reads;
    place(fork);
    console.between_frames();
    now = fork;
    has_parted = true;
    become("left", fork);
    step_to(80);
    CHECK(reads == before);
    check_kept(0);
    become("right", 100);
    console.between_frames();
    check_kept(0);
    // Also if the game goes on before the next frame.
    become("left", 80);
    place(++now);
    console.after_step();
    console.between_frames();
    check_kept(0);
    CHECK(reads == before + 4);  // by the skins and the traces, once for each change
}

TEST_CASE_METHOD(BranchedRig, "a break compares with values of the present branch only") {
    step_to(50);
    script::Observed mass;
    mass.text = mass.path = "world.ball.mass";
    mass.value = [this] { return property::get(tree, "world.ball.mass"); };
    (void)state().observing.functions().break_when(mass);
    property::set(tree, "world.ball.mass", Value(9.0));
    step_to(51);
    CHECK(logged("break at step 51"));
    property::set(tree, "world.ball.mass", Value(1.0));  // as it was at the fork
    has_parted = true;
    become("left", fork);
    step_to(45);
    CHECK_FALSE(logged("break at step 4"));
}

TEST_CASE("a property that differs in many instances has three lines") {
    Rig rig;
    const console::NotedValues a(rig.tree);
    const property::Handle world = rig.tree.child(rig.tree.root(), "world");
    for (const char* name : {"ball", "crate"})
        rig.tree.set(rig.tree.child(world, name), "mass", Value(7.0));
    rig.tree.create(rig.tree.class_named("Body"), world, "late");
    const auto lines = differences(rig.tree, a, console::NotedValues(rig.tree));
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "world.ball.mass: A 1 kg, B 7 kg");
    CHECK(lines[1] == "world.crate.mass: A 1 kg, B 7 kg");
    CHECK(lines[2] == "world.late: in B only");
    for (int i = 0; i < 4; ++i)
        rig.tree.create(rig.tree.class_named("Body"), world, "more" + std::to_string(i));
    const console::NotedValues c(rig.tree);
    for (const property::Handle each : rig.tree.children(world))
        rig.tree.set(each, "lives", Value(9));
    const auto many = differences(rig.tree, c, console::NotedValues(rig.tree));
    REQUIRE(many.size() == 3);
    CHECK(many[2] == "world.floor.lives: A 3, B 9; and in 5 others");
}

}  // namespace branch_switch_test
