#include <fettle/app/clock.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <fettle/property/error.h>

namespace fettle::app {

using property::Native;
using property::Property;
using property::Type;

namespace {

/// Marks a property that the loop computes: it changes every frame without reports, and is not
/// saved.
Property computed(Property property) {
    property.read_only = true;
    property.simulated = true;
    property.transient = true;
    return property;
}

std::vector<Property> user_settings(Clock& clock) {
    return {
        {.name = "dt",
         .type = Type::number,
         .default_value = 1.0 / 60,
         .unit = "s",
         .range = {1e-5, 1},
         .doc = "Length of a fixed step. Smaller steps are more exact and cost more.",
         .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.dt; })},
        {.name = "scale",
         .type = Type::number,
         .default_value = 1.0,
         .range = {0, 100},
         .doc = "Simulated seconds a real second: 0.1 is slow motion. A headless run ignores it.",
         .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.scale; })},
        {.name = "paused",
         .type = Type::boolean,
         .default_value = false,
         .doc = "Whether simulation time stands still. update and draw are still called.",
         .binding = column(clock, Native::boolean, 0, [](Clock& c) { return &c.paused; }),
         .transient = true},
        {.name = "step_once",
         .type = Type::boolean,
         .default_value = false,
         .doc = "Set it to make one step while paused; it is false again when the step is made.",
         .binding = column(clock, Native::boolean, 0, [](Clock& c) { return &c.step_once; }),
         .transient = true},
        {.name = "max_steps",
         .type = Type::integer,
         .default_value = 5,
         .range = {1, 1000},
         .doc = "How many steps a slow frame may make to catch up. What is due beyond that is "
                "dropped: the game slows down.",
         .binding = column(clock, Native::i32, 0, [](Clock& c) { return &c.max_steps; })},
    };
}

/// Settings for the timeline. They belong to the player, so saved games do not contain them.
std::vector<Property> timeline_settings(Clock& clock) {
    return {
        {.name = "rewind_limit",
         .type = Type::number,
         .default_value = 60.0,
         .unit = "s",
         .range = {0, 3600},
         .doc = "How much of the past is kept, for rewind and the time bar; 0: nothing.",
         .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.rewind_limit; }),
         .transient = true},
        {.name = "rewind_memory",
         .type = Type::number,
         .default_value = 128.0,
         .unit = "MiB",
         .range = {1, 65536},
         .doc =
             "How much memory the past and the history of edits may take together; where that is "
             "too little, less is kept. Undo has a quarter of it at most.",
         .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.rewind_memory; }),
         .transient = true},
        {.name = "branch_limit",
         .type = Type::integer,
         .default_value = 4,
         .range = {0, 16},
         .doc = "How many branches are kept besides the present one: what came later, where the "
                "game went on from an earlier step. 0: none.",
         .binding = column(clock, Native::i32, 0, [](Clock& c) { return &c.branch_limit; }),
         .transient = true},
        computed({.name = "branch",
                  .type = Type::text,
                  .doc = "The name of the present branch; time:name_branch changes it.",
                  .binding = property::accessor(
                      clock, [](Clock& c, property::Row) { return property::Value(c.branch); })}),
        computed({.name = "oldest",
                  .type = Type::integer,
                  .default_value = 0,
                  .unit = "",
                  .doc = "The first step to which you can go back.",
                  .binding = column(clock, Native::i64, 0, [](Clock& c) { return &c.oldest; })}),
        computed({.name = "newest",
                  .type = Type::integer,
                  .default_value = 0,
                  .doc = "The last step made; beyond `step` after going back, until a step is made "
                         "from there.",
                  .binding = column(clock, Native::i64, 0, [](Clock& c) { return &c.newest; })}),
    };
}

using Arguments = std::span<const property::Value>;

/// A method of `time` that needs a timeline. `Call` does the work.
template <auto Call>
property::Method travelling(Clock& clock, property::Method method) {
    method.context = &clock;
    method.call = [](void* context, property::Tree& tree, property::Handle, property::Row,
                     Arguments arguments) -> property::Result {
        const Clock& of = *static_cast<Clock*>(context);
        if (!of.timeline.go_to) throw std::invalid_argument("this game has no timeline");
        return Call(of, tree, arguments);
    };
    return method;
}

const property::Field branch_parameter{
    .name = "branch", .type = Type::text, .doc = "The name of a branch."};

const std::vector<property::Field> branch_fields = {
    {.name = "name", .type = Type::text, .doc = "Its name."},
    {.name = "fork",
     .type = Type::integer,
     .doc = "The last step that it has in common with the present branch."},
    {.name = "newest", .type = Type::integer, .doc = "Its last step."}};

property::Result go_to(const Clock& of, property::Tree& tree, Arguments arguments) {
    tree.require_changeable("go to another step");
    of.timeline.go_to(arguments[0].integer());
    return property::Value();
}

property::Result branches(const Clock& of, property::Tree&, Arguments) {
    std::vector<property::Record> all;
    for (const Branch& branch : of.timeline.branches())
        all.push_back({&branch_fields,
                       {property::Value(branch.name), property::Value(branch.fork),
                        property::Value(branch.newest)}});
    return all;
}

property::Result switch_to(const Clock& of, property::Tree& tree, Arguments arguments) {
    tree.require_changeable("go to another branch");
    of.timeline.switch_to(arguments[0].text());
    return property::Value();
}

property::Result name_branch(const Clock& of, property::Tree&, Arguments arguments) {
    of.timeline.name_branch(arguments[1].is_nil() ? of.branch : arguments[1].text(),
                            arguments[0].text());
    return property::Value();
}

property::Result forget_branch(const Clock& of, property::Tree& tree, Arguments arguments) {
    tree.require_changeable("forget a branch");
    of.timeline.forget_branch(arguments[0].text());
    return property::Value();
}

std::vector<property::Method> methods_of_time(Clock& clock) {
    using property::Effect;
    return {
        travelling<go_to>(
            clock, {.name = "go_to",
                    .parameters = {{.name = "step",
                                    .type = Type::integer,
                                    .doc = "From `oldest` to `newest`."}},
                    .required = 1,
                    .doc = "Goes to that step of the past, or back to the present, at the next "
                           "barrier. When a step is made from there, what came later becomes "
                           "another branch.",
                    .effect = Effect::tree}),
        travelling<branches>(
            clock, {.name = "branches",
                    .returns = branch_fields,
                    .many = true,
                    .doc = "The branches besides the present one, the oldest first. A branch is "
                           "what came later, where the game went on from an earlier step. It is "
                           "kept as long as the past.",
                    .effect = Effect::nothing}),
        travelling<switch_to>(
            clock,
            {.name = "switch_to",
             .parameters = {branch_parameter},
             .required = 1,
             .doc = "Makes that branch the present one and goes to its last step, at the next "
                    "barrier. The branch that was present is kept.",
             .effect = Effect::tree}),
        travelling<name_branch>(
            clock, {.name = "name_branch",
                    .parameters = {{.name = "name",
                                    .type = Type::text,
                                    .doc = "The new name, 1 to 40 bytes, of no other branch."},
                                   {.name = "branch",
                                    .type = Type::text,
                                    .doc = "The old name; the present branch if it is left out."}},
                    .required = 1,
                    .doc = "Gives a branch a name. Where there is no room for all, branches "
                           "without a name are dropped first.",
                    .effect = Effect::tree}),
        travelling<forget_branch>(clock, {.name = "forget_branch",
                                          .parameters = {branch_parameter},
                                          .required = 1,
                                          .doc = "Drops a branch, at the next barrier.",
                                          .effect = Effect::tree}),
    };
}

std::vector<Property> kept_by_the_loop(Clock& clock) {
    return {
        computed({.name = "step",
                  .type = Type::integer,
                  .default_value = 0,
                  .doc = "Fixed steps made since the game started.",
                  .binding = column(clock, Native::i64, 0, [](Clock& c) { return &c.step; })}),
        computed({.name = "now",
                  .type = Type::number,
                  .unit = "s",
                  .doc = "Simulation time since the game started.",
                  .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.now; })}),
        computed({.name = "real",
                  .type = Type::number,
                  .unit = "s",
                  .doc = "Real time since the game started, also while it is paused: the sum of "
                         "real_dt of all updates. It is never rewound. In a headless run, a frame "
                         "is as long as a step.",
                  .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.real; })}),
        computed({.name = "frame",
                  .type = Type::integer,
                  .default_value = 0,
                  .doc = "Frames made since the game started.",
                  .binding = column(clock, Native::i64, 0, [](Clock& c) { return &c.frame; })}),
        computed(
            {.name = "dropped_steps",
             .type = Type::integer,
             .default_value = 0,
             .doc = "Steps that were due but given up, since frames took too long.",
             .binding = column(clock, Native::i64, 0, [](Clock& c) { return &c.dropped_steps; })}),
        computed({.name = "alpha",
                  .type = Type::number,
                  .default_value = 1.0,
                  .range = {0, 1},
                  .doc = "How far the picture is between the last two steps.",
                  .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.alpha; })}),
        computed({.name = "fps",
                  .type = Type::number,
                  .unit = "1/s",
                  .doc = "Frames a second, smoothed. 0 in a headless run.",
                  .binding = column(clock, Native::f64, 0, [](Clock& c) { return &c.fps; })}),
    };
}

template <class Base>
Property timing(Timings& timings, const char* name, const char* doc, Base base) {
    return computed({.name = name,
                     .type = Type::number,
                     .unit = "ms",
                     .doc = doc,
                     .binding = column(timings, Native::f64, 0, base)});
}

std::vector<Property> timings_of(Timings& timings) {
    return {
        timing(timings, "input", "Delivering input to the game.",
               [](Timings& t) { return &t.input; }),
        timing(timings, "update", "The game's update(dt).", [](Timings& t) { return &t.update; }),
        timing(timings, "scripts", "Timers, coroutines and step(dt).",
               [](Timings& t) { return &t.scripts; }),
        timing(timings, "modules", "Steps of the modules: the physics.",
               [](Timings& t) { return &t.modules; }),
        timing(timings, "handlers", "Barriers: watchers and event handlers.",
               [](Timings& t) { return &t.handlers; }),
        timing(timings, "draw", "Drawing, layers included.", [](Timings& t) { return &t.draw; }),
        timing(timings, "wait",
               "Waiting for the screen, and what is in no other part; 0 in a headless run.",
               [](Timings& t) { return &t.wait; }),
        timing(timings, "frame", "The whole frame, waiting for the screen included.",
               [](Timings& t) { return &t.frame; }),
    };
}

}  // namespace

void Clock::require_usable() const {
    const auto require = [](const char* name, double value, bool good, const char* expected) {
        if (!good)
            throw property::Error(property::ErrorKind::out_of_range,
                                  std::string("time.") + name + " = " +
                                      property::number_text(value) + ": expected " + expected);
    };
    constexpr double limit = 1e6;  // s; sums of it stay far below the largest valid time
    require("dt", dt, dt > 0 && dt <= limit, "a time in seconds, more than 0 and at most 1e6");
    const auto amount = [](double value) { return value >= 0 && std::isfinite(value); };
    require("scale", scale, amount(scale), "a number, at least 0");
    require("max_steps", max_steps, max_steps >= 0, "a number of steps, at least 0");
    require("rewind_limit", rewind_limit, amount(rewind_limit), "a time in seconds, at least 0");
    require("rewind_memory", rewind_memory, rewind_memory >= 0 && rewind_memory <= 1e9,
            "an amount of MiB, at least 0 and at most 1e9");
}

void Clock::advance() {
    if (dt != origin_.dt) {
        origin_.now = now;
        origin_.step = step;
        origin_.dt = dt;
    }
    ++step;
    now = origin_.now + static_cast<double>(step - origin_.step) * dt;
}

struct ClockPart::State {
    std::int64_t step = 0;
    double now = 0, origin = 0;
    std::int64_t origin_step = 0;
    double origin_dt = 0;
};

ClockPart::State ClockPart::state() const {
    return {clock_.step, clock_.now, clock_.origin_.now, clock_.origin_.step, clock_.origin_.dt};
}

void ClockPart::set(const State& state) {
    clock_.step = state.step;
    clock_.now = state.now;
    clock_.origin_.now = state.origin;
    clock_.origin_.step = state.origin_step;
    clock_.origin_.dt = state.origin_dt;
}

property::Memory ClockPart::save(property::ByteWriter& to) const {
    to.put(state());
    return {};
}

std::function<void()> ClockPart::restore(property::ByteReader& from, const property::Memory&) {
    const auto read = from.get<State>();
    for (const double time : {read.now, read.origin, read.origin_dt})
        from.require(time >= 0 && time < 1e15, "an invalid time");
    constexpr std::int64_t limit = std::int64_t{1} << 52;  // more steps than any run makes
    from.require(read.step >= 0 && read.step < limit && read.origin_step >= 0 &&
                     read.origin_step <= read.step,
                 "an invalid step");
    return [this, read] { set(read); };
}

property::Memory ClockPart::changes() {
    return std::make_shared<const State>(state());
}

void ClockPart::redo(const property::Memory& changes) {
    set(*static_cast<const State*>(changes.get()));
}

std::size_t ClockPart::size_of(const property::Memory& changes) const {
    return changes == nullptr ? 0 : sizeof(State) + 32;
}

property::Handle define_clock(property::Tree& tree, Clock& clock) {
    std::vector<Property> properties = user_settings(clock);
    for (Property& property : kept_by_the_loop(clock)) properties.push_back(std::move(property));
    for (Property& property : timeline_settings(clock)) properties.push_back(std::move(property));
    const property::Class& time =
        tree.define({.name = "Time",
                     .doc = "Simulation time: how fast it passes, and how much has passed.",
                     .creatable = false,
                     .properties = std::move(properties),
                     .methods = methods_of_time(clock)});
    const property::Class& timings = tree.define(
        {.name = "Timings",
         .doc = "Where a frame's time goes, smoothed over about half a second. In a headless run a "
                "frame is one turn of the loop, and the half second is simulation time.",
         .creatable = false,
         .properties = timings_of(clock.timings)});
    const property::Handle instance = tree.create(time, tree.root(), "time");
    tree.create(timings, instance, "timings");
    return instance;
}

}  // namespace fettle::app
