// Settings of the player that are kept from run to run: the layout, and own commands.

#include <memory>
#include <optional>

#include "catch.h"
#include "rig.h"

namespace kept_layout_test {

using namespace fettle;
using console::test::RasterSurface;
using property::Value;

namespace {

/// A game with a console, as in one run of the program.
struct Run {
    explicit Run(console::Layout layout = {}, std::string first_commands = {},
                 std::optional<console::Layout>* kept = nullptr)
        : runtime((console::test::make_game(tree), tree), {}) {
        console::Options options;
        options.layout = std::move(layout);
        options.first_commands = std::move(first_commands);
        if (kept != nullptr)
            options.keep_layout = [kept](const console::Layout& made) { *kept = made; };
        lua = std::make_unique<console::Console>(tree, runtime, std::move(options));
    }
    void frame() {
        lua->between_frames();
        tree.barrier();
        lua->draw(surface, 1.0 / 60);
    }
    std::string text() {
        std::string all;
        for (const console::LogLine& line : lua->state().log.lines()) all += line.text + "\n";
        return all;
    }
    property::Tree tree;
    script::Runtime runtime;
    RasterSurface surface{1280, 720};
    std::unique_ptr<console::Console> lua;
};

}  // namespace

TEST_CASE("the console of the next run in a window goes on with the log") {
    Run first;
    first.lua->open();
    first.frame();
    first.lua->state().run("1 + 2");
    const auto seen = first.lua->continuation();
    Run next;
    next.lua->note("a new note");
    next.lua->continue_from(*seen);
    next.frame();
    CHECK(next.lua->is_open());
    const std::string text = next.text();
    INFO(text);
    CHECK(text.starts_with(first.text()));
    CHECK(text.ends_with("3\na new note\nthe game begins again\n"));

    first.lua->open(false);
    Run closed;
    closed.lua->continue_from(*first.lua->continuation());
    closed.frame();
    CHECK_FALSE(closed.lua->is_open());
}

TEST_CASE("the game that begins again has the same instance selected") {
    Run first;
    first.lua->open();
    first.frame();
    const auto ball = property::resolve(first.tree, "world.ball").instance;
    first.lua->select(ball);
    const auto seen = first.lua->continuation();
    Run next;
    next.lua->continue_from(*seen);
    next.frame();
    CHECK(next.lua->selected() == property::resolve(next.tree, "world.ball").instance);
    next.lua->state().run("it.mass = 7");
    CHECK(property::get(next.tree, "world.ball.mass") == Value(7.0));
    // Without a selection, the next run selects nothing.
    next.lua->select(std::vector<property::Handle>{});
    next.frame();
    CHECK_FALSE(next.lua->selected());
}

TEST_CASE("overlays that a person has switched on stay on when the game begins again") {
    const auto with_overlays = [](Run& run) {
        property::ClassDescriptor show{.name = "Show"};
        for (const char* name : {"contacts", "joints", "names"})
            show.properties.push_back(
                {.name = name, .type = property::Type::boolean, .default_value = Value(false)});
        property::Tree& tree = run.tree;
        return tree.create(tree.define(std::move(show)),
                           tree.create(tree.object_class(), tree.root(), "view"), "show");
    };
    Run first;
    const auto show = with_overlays(first);
    first.lua->open();
    first.frame();
    first.lua->state().run("view.show.contacts = true");
    {
        const property::Tree::CauseScope cause(first.tree, property::Writer::script);
        first.tree.set(show, "joints", Value(true));
    }
    Run next;
    const auto shown = with_overlays(next);
    next.lua->continue_from(*first.lua->continuation());
    next.frame();
    CHECK(next.tree.get(shown, "contacts") == Value(true));
    CHECK(next.tree.get(shown, "joints") == Value(false));
    CHECK(next.tree.get(shown, "names") == Value(false));
}

TEST_CASE("keys and words for commands stay when the game begins again") {
    Run first;
    first.lua->open();
    first.frame();
    first.lua->state().run("bind('f5', 'world.ball.mass = 7')");
    first.lua->state().run("alias('heavy', 'world.ball.mass =')");
    Run next;
    next.lua->continue_from(*first.lua->continuation());
    next.frame();
    CHECK(next.lua->handle(console::test::key_event("f5", true)));
    next.frame();
    CHECK(property::get(next.tree, "world.ball.mass") == Value(7.0));
    next.lua->state().run("heavy 12");
    CHECK(property::get(next.tree, "world.ball.mass") == Value(12.0));
}

TEST_CASE("conditions of break_when stay when the game begins again") {
    Run first;
    first.lua->open();
    first.frame();
    first.lua->state().run("break_when world.ball.mass > 5");
    first.lua->state().run("break_when(function() return world.crate.mass > 5 end)");
    Run next;
    next.lua->continue_from(*first.lua->continuation());
    next.frame();
    const auto& breaks = next.lua->state().observing.breaks();
    CHECK(breaks.texts() == std::vector<std::string>{"world.ball.mass > 5"});
    CHECK(breaks.size() == 1);  // a function may use variables of the run before
    next.lua->state().run("break_when()");
    CHECK(breaks.size() == 0);
}

TEST_CASE("a value pinned in an earlier run whose instance does not exist yet causes no message") {
    console::Layout layout;
    layout.pins = {"world.boss.mass"};
    layout.plots = {"world.boss.position"};
    Run run(layout);
    run.lua->open();
    run.frame();
    CHECK(run.lua->state().observing.pins().size() == 1);
    CHECK(run.text().find("boss") == std::string::npos);
    run.lua->state().run("pin world.boss.mass");
    CHECK(run.text().find("pin: world.boss: no such name") != std::string::npos);
}

TEST_CASE("sizes and pinned and plotted values are kept from run to run") {
    std::optional<console::Layout> kept;
    {
        Run first({}, {}, &kept);
        first.frame();
        first.lua->state().run("pin world.ball.mass");
        first.lua->state().run("pin(function() return 1 end)");
        first.lua->state().run("plot world.ball.position, world.ball.mass * 2");
        property::set(first.tree, "console.height", Value(0.7));
        property::set(first.tree, "console.scale", Value(1.5));
        first.lua->open();
        first.frame();
        CHECK_FALSE(kept);
        first.lua->open(false);
        REQUIRE(kept);
        kept.reset();
    }
    REQUIRE(kept);
    CHECK(kept->pins == std::vector<std::string>{"world.ball.mass"});
    CHECK(kept->plots == std::vector<std::string>{"world.ball.position", "world.ball.mass * 2"});
    Run second(*kept);
    CHECK(property::get(second.tree, "console.height").number() == Approx(0.7));
    CHECK(property::get(second.tree, "console.scale").number() == Approx(1.5));
    second.frame();
    auto& observing = second.lua->state().observing;
    REQUIRE(observing.pins().size() == 1);
    CHECK(observing.pins()[0].value() == Value(1.0));
    REQUIRE(observing.plots().size() == 2);
    CHECK(observing.plots()[1].what().text == "world.ball.mass * 2");
    CHECK_FALSE(second.runtime.running());
}

TEST_CASE("a layout that does not fit is reported and the rest is used") {
    console::Layout damaged;
    damaged.settings = {{"height", Value("tall")}, {"scale", Value(2.0)}, {"wings", Value(1.0)}};
    damaged.pins = {"world.ball.mass +", "world.ball.mass"};
    Run run(damaged);
    run.frame();
    CHECK(property::get(run.tree, "console.scale").number() == 2);
    CHECK(property::get(run.tree, "console.height").number() == Approx(0.45));
    CHECK(run.text().find("the layout of the last run: ") != std::string::npos);
    CHECK(run.lua->state().observing.pins().size() == 1);
}

TEST_CASE("commands of the player run before the first frame and an error does not end them") {
    Run run({},
            "world.ball.mass = 2\nworld.ball.masss()\nfor i = 1, 2 do\n  world.crate.mass = i\n"
            "end\n");
    run.frame();
    CHECK(property::get(run.tree, "world.ball.mass").number() == 2);
    CHECK(property::get(run.tree, "world.crate.mass").number() == 2);
    CHECK(run.text().find("did you mean \"mass\"?") != std::string::npos);
    run.lua->state().run("world.ball.mass = 3");
    run.frame();
    CHECK(property::get(run.tree, "world.ball.mass").number() == 3);
}

TEST_CASE("the log shows only lines with the text of the filter") {
    Run run;
    run.lua->open();
    run.lua->print("a wall was hit");
    run.lua->print("a coin was taken");
    run.lua->state().log.note("WALL");
    run.frame();
    const auto rows = [&] { return run.lua->state().views.log_view.shown_rows(); };
    const std::size_t all = rows().size();
    property::set(run.tree, "console.filter", Value("wall"));
    run.frame();
    CHECK(rows() == std::vector<std::string>{"a wall was hit", "WALL"});
    run.lua->print("another wall");
    run.lua->print("another coin");
    run.frame();
    CHECK(rows().size() == 3);
    property::set(run.tree, "console.filter", Value(""));
    run.frame();
    CHECK(rows().size() == all + 2);
    // By typing into the field of the title.
    const ImVec2 field = run.lua->state().screen.filter_rect.middle();
    for (const auto kind : {app::EventKind::mouse_moved, app::EventKind::mouse_pressed,
                            app::EventKind::mouse_released}) {
        app::InputEvent event;
        event.kind = kind;
        event.name = "left";
        event.x = field.x;
        event.y = field.y;
        run.lua->handle(event);
        run.frame();
    }
    for (const char32_t letter : U"coin") {
        if (letter == 0) break;
        app::InputEvent event;
        event.kind = app::EventKind::text;
        event.character = letter;
        run.lua->handle(event);
        run.frame();
    }
    CHECK(property::get(run.tree, "console.filter").text() == "coin");
    run.frame();
    CHECK(rows().size() == 2);
}

TEST_CASE("the log distinguishes prints of the game from prints of commands") {
    Run run;
    run.lua->print("tick");
    run.lua->print("tick");
    run.lua->state().run("print('tick')");
    const auto& lines = run.lua->state().log.lines();
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].kind == console::LineKind::game);
    CHECK(lines[0].count == 2);
    CHECK(lines[2].kind == console::LineKind::output);
}

}  // namespace kept_layout_test
