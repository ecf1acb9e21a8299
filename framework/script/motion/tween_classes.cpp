#include <algorithm>

#include <fettle/property/last_value.h>

#include <motion/ease.h>
#include <motion/tween_classes.h>

namespace fettle::script {

using property::ClassDescriptor;
using property::Event;
using property::Method;
using property::Row;
using property::Tree;

namespace {

Method stop_method() {
    return {.name = "stop",
            .doc = "Ends it where it is, without the event, and deletes it.",
            .call = [](void*, Tree& tree, Handle self, Row,
                       std::span<const Value>) -> property::Result {
                tree.destroy(self);
                return Value();
            },
            .effect = property::Effect::tree};
}

Property paused_property() {
    return {.name = "paused",
            .type = Type::boolean,
            .default_value = false,
            .doc = "Whether it stands still."};
}

Property pauses_property() {
    return {.name = "pauses",
            .type = Type::boolean,
            .default_value = true,
            .doc =
                "Whether it pauses with the game and follows time.scale. false: it moves in "
                "real time, at each picture, as a pause menu needs it. In a group, that of the "
                "outermost group counts."};
}

Property loops_property() {
    return {.name = "loops",
            .type = Type::integer,
            .default_value = 1,
            .range = {0, 1'000'000'000},
            .doc = "How often it runs before it ends; 0: until it is stopped."};
}

Property turn_property() {
    return {.name = "turn",
            .type = Type::integer,
            .default_value = 0,
            .doc = "How many runs are complete.",
            .hidden = true};
}

Property reversed_property() {
    return {.name = "reversed",
            .type = Type::boolean,
            .default_value = false,
            .doc = "Whether its group runs backwards now.",
            .hidden = true};
}

Property over_property() {
    return {.name = "over",
            .type = Type::boolean,
            .default_value = false,
            .doc = "Whether it has come to its end.",
            .hidden = true};
}

std::vector<std::string> kinds_of_ease() {
    std::vector<std::string> names = ease_names();
    names.emplace_back("curve");
    return names;
}

/// The properties that a script gives to a tween.
std::vector<Property> settings_of_tween() {
    return {{.name = "target",
             .type = Type::reference,
             .doc = "The instance whose property changes. The tween ends with it.",
             .reference_class = "Object"},
            {.name = "property",
             .type = Type::text,
             .default_value = "",
             .doc = "The name of the property that changes; empty for a pause in a sequence."},
            {.name = "from",
             .type = Type::nil,
             .doc = "The value at the beginning: the one that the property has when the tween "
                    "begins, unless it is set before.",
             .any_type = true},
            {.name = "to", .type = Type::nil, .doc = "The value at the end.", .any_type = true},
            {.name = "seconds",
             .type = Type::number,
             .default_value = 1.0,
             .unit = "s",
             .range = {0, 1e9},
             .doc = "How long it takes, in simulation time; in real time without `pauses`."},
            {.name = "ease",
             .type = Type::text,
             .default_value = "linear",
             .doc = "How the part of the way depends on the part of the time; \"curve\" takes it "
                    "from `curve`.",
             .enumerators = kinds_of_ease()},
            {.name = "curve",
             .type = Type::list,
             .default_value = property::List{},
             .doc = "Parts of the way at equal distances of time, joined by straight lines. A "
                    "function given as ease is kept here as 257 of its values.",
             .element = Type::number},
            loops_property(),
            {.name = "alternate",
             .type = Type::boolean,
             .default_value = false,
             .doc = "Whether every second run goes back."}};
}

/// The state of a tween in time.
std::vector<Property> state_of_tween() {
    return {{.name = "progress",
             .type = Type::number,
             .default_value = 0.0,
             .range = {0, 1},
             .doc = "The part of the time that has passed in this run. Setting it jumps there at "
                    "the next step."},
            paused_property(),
            pauses_property(),
            turn_property(),
            reversed_property(),
            {.name = "shown",
             .type = Type::number,
             .default_value = -1.0,
             .doc = "The progress that the property shows; below 0 before the tween begins.",
             .hidden = true},
            over_property()};
}

ClassDescriptor tween_descriptor() {
    std::vector<Property> properties = settings_of_tween();
    for (Property& each : state_of_tween()) properties.push_back(std::move(each));
    return {.name = "Tween",
            .doc =
                "Moves a property of an instance from its value to another in some time. "
                "tween(...) makes it below `game.tweens`, where it runs.",
            .properties = std::move(properties),
            .methods = {stop_method()},
            .events = {Event{.name = "finished",
                             .doc = "It has reached its end; it is deleted at the next step."}}};
}

/// How long a tween or a group takes, and how much of that has passed, s. Of an endless one, a run.
struct Extent {
    double length = 0, passed = 0;
    /// Several such runs, of which `done` are complete.
    Extent repeated(double runs, double done) const {
        return runs > 1 ? Extent{length * runs, length * done + passed} : *this;
    }
};

double runs_of(const Tree& tree, Handle each) {
    return last_value(tree, each, "loops").as_double();
}

Extent extent(const Tree& tree, Handle each, int depth);

/// Of one run.
Extent extent_of_run(const Tree& tree, Handle each, int depth) {
    if (const Property* seconds = tree.find(each, "seconds")) {
        const double length = last_value(tree, each, *seconds).as_double();
        return {length, length * last_value(tree, each, "progress").as_double()};
    }
    const Property* kind = tree.find(each, "kind");
    if (kind == nullptr || depth >= deepest_tweens) return {};
    const bool together = last_value(tree, each, *kind).text() == in_parallel;
    Extent sum;
    for (const Handle child : tree.children(each)) {
        const Extent part = extent(tree, child, depth + 1);
        sum.length = together ? std::max(sum.length, part.length) : sum.length + part.length;
        sum.passed = together ? std::max(sum.passed, part.passed) : sum.passed + part.passed;
    }
    // The shorter ones begin later in a run that goes back.
    if (together) sum.passed = std::max(sum.passed, last_value(tree, each, "run_time").as_double());
    return sum;
}

/// Of all runs.
Extent extent(const Tree& tree, Handle each, int depth) {
    const Extent run = extent_of_run(tree, each, depth);
    return tree.find(each, "loops") == nullptr
               ? run
               : run.repeated(runs_of(tree, each), last_value(tree, each, "turn").as_double());
}

Value progress_of_group(void*, const Tree& tree, Handle self) {
    if (last_value(tree, self, "over").boolean()) return 1.0;
    const Extent all = extent_of_run(tree, self, 0);
    return all.length > 0 ? std::min(all.passed / all.length, 1.0) : 0.0;
}

ClassDescriptor group_descriptor() {
    Property progress{.name = "progress",
                      .type = Type::number,
                      .range = {0, 1},
                      .doc = "The part of the time that has passed in this run.",
                      .read_only = true,
                      .transient = true,
                      .simulated = true};
    progress.binding.kind = property::BindingKind::node;
    progress.binding.node_get = progress_of_group;
    return {.name = "TweenGroup",
            .doc =
                "Tweens that run one after the other, or together. tween.sequence and "
                "tween.parallel make it below `game.tweens`, where it runs.",
            .properties = {{.name = "kind",
                            .type = Type::text,
                            .default_value = in_sequence,
                            .doc = "Whether one follows the other or all run together.",
                            .enumerators = {in_sequence, in_parallel}},
                           loops_property(),
                           {.name = "alternate",
                            .type = Type::boolean,
                            .default_value = false,
                            .doc = "Whether every second run goes back, the last of a sequence "
                                   "first."},
                           progress,
                           paused_property(),
                           pauses_property(),
                           turn_property(),
                           {.name = "run_time",
                            .type = Type::number,
                            .default_value = 0.0,
                            .unit = "s",
                            .doc = "How long this run of a parallel group has taken.",
                            .hidden = true},
                           reversed_property(),
                           over_property()},
            .methods = {stop_method()},
            .events = {Event{.name = "finished",
                             .doc = "All in it have ended; it is deleted at the next step."}}};
}

}  // namespace

double seconds_of(const Tree& tree, Handle each) {
    return extent(tree, each, 0).length;
}

double seconds_of_run(const Tree& tree, Handle group) {
    return extent_of_run(tree, group, 0).length;
}

TweenClasses define_tween_classes(Tree& tree) {
    const auto defined = [&tree](ClassDescriptor descriptor) -> const Class& {
        if (const Class* known = tree.find_class(descriptor.name)) return *known;
        return tree.define(std::move(descriptor));
    };
    const Class& tween = defined(tween_descriptor());
    const Class& group = defined(group_descriptor());
    const Class& holder = defined({.name = "Tweens",
                                   .doc = "The tweens of the game, in the order in which they run.",
                                   .stem = tweens_name});
    const auto of = [](const Class& in, const char* name) -> const Property& {
        return *in.property(name);
    };
    const auto running = [&](const Class& in) -> RunningClass {
        return {.of = in,
                .paused = of(in, "paused"),
                .pauses = of(in, "pauses"),
                .loops = of(in, "loops"),
                .alternate = of(in, "alternate"),
                .turn = of(in, "turn"),
                .reversed = of(in, "reversed"),
                .over = of(in, "over"),
                .finished = *in.event("finished")};
    };
    return {.tween = {running(tween), of(tween, "target"), of(tween, "property"), of(tween, "from"),
                      of(tween, "to"), of(tween, "seconds"), of(tween, "ease"), of(tween, "curve"),
                      of(tween, "progress"), of(tween, "shown")},
            .group = {running(group), of(group, "kind"), of(group, "run_time")},
            .holder = holder};
}

}  // namespace fettle::script
