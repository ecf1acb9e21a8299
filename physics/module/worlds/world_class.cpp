// World: settings of the simulation, and statistics of the last step.

#include <algorithm>
#include <array>
#include <stdexcept>

#include <bindings/bindings.h>
#include <drawing/drawing.h>
#include <events/events.h>
#include <worlds/world_class.h>

namespace fettle::physics_module {
namespace {

using physics::StepStatistics;
using physics::World;

Value bounds(Hosting& hosting, Row row) {
    const auto& bounds = hosting.world(row).bounds();
    return bounds ? to_value(*bounds) : Value();
}

constexpr std::array<const char*, 5> mix_rules = {"average", "minimum", "maximum", "multiply",
                                                  "geometric"};

constexpr std::array<const char*, 3> solvers = {"soft_step", "sequential", "direct"};

void set_bounds(Hosting& hosting, Row row, const Value& value) {
    World& world = hosting.world(row);
    if (value.is_nil()) return world.set_bounds(std::nullopt);
    const auto box = from_value<physics::Aabb>(value);
    if (box.min.x == box.max.x || box.min.y == box.max.y)
        throw std::invalid_argument("expected two corners of a box, got two points in a line");
    world.set_bounds(box);
}

void set_threads(Hosting& hosting, Row row, const Value& value) {
    try {
        hosting.world(row).set_threads(from_value<int>(value));
    } catch (const std::runtime_error& refusal) {  // the system provides no more threads
        throw std::invalid_argument(refusal.what());
    }
}

std::vector<Property> simulation(Hosting& hosting) {
    const physics::WorldDef defaults;
    return {
        vector("gravity", widen(defaults.gravity), "m/s\xC2\xB2",
               "Acceleration of every dynamic body, times its gravity_scale.",
               bound<&World::gravity, &World::set_gravity>(hosting)),
        {.name = "substeps",
         .type = Type::integer,
         .default_value = defaults.substeps,
         .range = {.min = 1, .max = 64},
         .doc = "Number of parts in which a step is solved: more is stiffer and slower. A step "
                "that is longer than 1/60 s, or much longer than the last one, gets up to four "
                "times as many.",
         .binding = bound<&World::substeps, &World::set_substeps>(hosting)},
        {.name = "threads",
         .type = Type::integer,
         .default_value = 1,
         .range = {.min = 1, .max = 64},
         .doc = "Number of threads for a step; at most as many run at a time as the machine has "
                "processors. The number changes no result.",
         .binding = accessor(
             hosting, [](Hosting& h, Row row) { return Value(h.world(row).threads()); },
             [](Hosting& h, Row row, const Value& value) { set_threads(h, row, value); }),
         .transient = true},
        choice<solvers, &World::solver, &World::set_solver>(
            hosting, "solver", solvers[0],
            "How contacts and joints are solved: \"soft_step\" solves them one after the other "
            "in small steps with warm starting, and is right for nearly all games; \"direct\" "
            "solves "
            "all that touch each other as one problem: slow for many bodies, and it holds bodies "
            "some hundreds of times heavier than those below them; \"sequential\" solves the "
            "contacts once, the worst first, as was usual in 2008, to compare: it does not hold a "
            "heavy box on a light one."),
        {.name = "bounds",
         .type = Type::list,
         .unit = "m",
         .range = coordinates,
         .doc = "Walls around the world, given by their lower left and upper right corner; nil: "
                "none. They are of category 1, so a shape whose `mask` lacks that bit passes "
                "through them.",
         .binding = accessor(
             hosting, [](Hosting& h, Row row) { return bounds(h, row); },
             [](Hosting& h, Row row, const Value& value) { set_bounds(h, row, value); }),
         .nullable = true,
         .element = Type::vec2,
         .single_precision = true},
        flag("sleeping", defaults.sleeping,
             "True if resting bodies fall asleep, which saves time, until they are disturbed.",
             bound<&World::sleeping, &World::set_sleeping>(hosting)),
        flag("continuous", defaults.continuous,
             "True if bodies cannot pass through static ones at any speed.",
             bound<&World::continuous, &World::set_continuous>(hosting)),
    };
}

std::vector<Property> mixing(Hosting& hosting) {
    return {
        choice<mix_rules, &World::friction_mix, &World::set_friction_mix>(
            hosting, "friction_mix", "geometric",
            "Friction of a contact from those of its two surfaces: \"geometric\" is the root of "
            "their product."),
        choice<mix_rules, &World::restitution_mix, &World::set_restitution_mix>(
            hosting, "restitution_mix", "maximum",
            "Restitution of a contact from those of its two surfaces."),
    };
}

std::vector<Property> tuning(Hosting& hosting) {
    const physics::WorldDef defaults;
    Property bounce =
        amount("bounds_restitution", defaults.bounds_restitution, "",
               "Share of the speed with which bodies separate from the walls of the bounds.",
               bound<&World::bounds_restitution, &World::set_bounds_restitution>(hosting));
    bounce.range = fraction;
    Property most_speed =
        number("max_speed", defaults.max_speed, "m/s",
               "Limit of the speed of every body. Body.max_speed is the limit of one.",
               bound<&World::max_speed, &World::set_max_speed>(hosting));
    most_speed.range = {.min = 1e-30, .max = defaults.max_speed};
    return {
        amount("bounds_friction", defaults.bounds_friction, "",
               "Friction of the walls of the bounds.",
               bound<&World::bounds_friction, &World::set_bounds_friction>(hosting)),
        bounce,
        amount("restitution_threshold", defaults.restitution_threshold, "m/s",
               "Slower impacts do not bounce.",
               bound<&World::restitution_threshold, &World::set_restitution_threshold>(hosting)),
        amount("hit_threshold", defaults.hit_threshold, "m/s",
               "Slower impacts cause no contact_hit.",
               bound<&World::hit_threshold, &World::set_hit_threshold>(hosting)),
        amount("sleep_speed", defaults.sleep_speed, "m/s", "A body that is slower than this rests.",
               bound<&World::sleep_speed, &World::set_sleep_speed>(hosting)),
        amount("sleep_delay", defaults.sleep_delay, "s",
               "Time for which a body must rest before it falls asleep.",
               bound<&World::sleep_delay, &World::set_sleep_delay>(hosting)),
        amount("contact_hertz", defaults.contact_hertz, "Hz",
               "Stiffness of contacts, at most a quarter of the rate of sub-steps.",
               bound<&World::contact_hertz, &World::set_contact_hertz>(hosting)),
        amount("contact_damping", defaults.contact_damping, "", "Damping ratio of contacts.",
               bound<&World::contact_damping, &World::set_contact_damping>(hosting)),
        amount("push_speed", defaults.push_speed, "m/s",
               "Largest speed at which two bodies that overlap are pushed apart. Of many in one "
               "place, the outer ones are faster: each is pushed by the one inside of it.",
               bound<&World::push_speed, &World::set_push_speed>(hosting)),
        most_speed,
    };
}

/// A user may move the instance of the statistics to another parent, so that it outlives its world.
/// Then the statistics of limbo are shown.
const StepStatistics& statistics_of(Hosting& hosting, Row row) {
    const HostedWorld* hosted = hosting.world_at(world_number(row));
    return (hosted != nullptr ? hosted : hosting.world_at(limbo))->world.statistics();
}

template <auto Member>
Property statistic(Hosting& hosting, const char* name, const char* doc) {
    using Figure = std::remove_cvref_t<decltype(std::declval<StepStatistics>().*Member)>;
    constexpr bool is_time = std::is_same_v<Figure, float>;
    return {
        .name = name,
        .type = is_time ? Type::number : Type::integer,
        .unit = is_time ? "ms" : "",
        .doc = doc,
        .binding = accessor(
            hosting, [](Hosting& h, Row row) { return to_value(statistics_of(h, row).*Member); }),
        .read_only = true,
        .transient = true,
        .simulated = true,
        .single_precision = is_time};
}

}  // namespace

void define_step_statistics(Hosting& hosting) {
    using S = StepStatistics;
    Hosting& h = hosting;
    property::ClassDescriptor statistics;
    statistics.snapshots = property::Snapshots::natively;
    statistics.name = "StepStatistics";
    statistics.doc = "Statistics of the last step of a world, and the time that it took.";
    statistics.creatable = false;
    statistics.properties = {
        statistic<&S::steps>(h, "steps", "Number of steps since the world was made."),
        statistic<&S::bodies>(h, "bodies", "Number of bodies in the world."),
        statistic<&S::awake_bodies>(h, "awake_bodies",
                                    "Number of bodies that took part in the step."),
        statistic<&S::shapes>(h, "shapes", "Number of shapes of all bodies."),
        statistic<&S::joints>(h, "joints", "Number of joints that act on a body."),
        statistic<&S::awake_joints>(h, "awake_joints", "Number of joints on a body that is awake."),
        statistic<&S::contacts>(h, "contacts", "Number of pairs of shapes near each other."),
        statistic<&S::awake_contacts>(
            h, "awake_contacts",
            "Number of pairs of shapes near each other with a body that is "
            "awake."),
        statistic<&S::touching>(h, "touching", "Number of pairs near enough to be solved."),
        statistic<&S::islands>(h, "islands", "Number of groups of bodies that sleep together."),
        statistic<&S::moved_proxies>(h, "moved_proxies",
                                     "Number of shapes that left their box in the tree."),
        statistic<&S::direct_solves>(
            h, "direct_solves",
            "Number of problems that the direct solver solved: two in a part "
            "of a step for every group of bodies that touch."),
        statistic<&S::direct_failures>(
            h, "direct_failures",
            "Number of problems too large for the direct solver, or without a "
            "solution, which were solved by iteration instead."),
        statistic<&S::edits_ms>(h, "edits_ms", "Time to bring edited data up to date."),
        statistic<&S::pairs_ms>(h, "pairs_ms", "Time of the broad phase."),
        statistic<&S::narrow_ms>(h, "narrow_ms", "Time of the manifolds."),
        statistic<&S::solve_ms>(h, "solve_ms", "Time of forces, contacts and joints."),
        statistic<&S::finish_ms>(h, "finish_ms", "Time of poses, boxes and continuous collision."),
        statistic<&S::sleep_ms>(h, "sleep_ms", "Time to find resting bodies."),
        statistic<&S::total_ms>(h, "total_ms", "Time of the whole step."),
    };
    hosting.classes.statistics = &hosting.tree.define(std::move(statistics));
}

void define_world(Hosting& hosting) {
    property::ClassDescriptor world;
    world.snapshots = property::Snapshots::natively;
    world.name = "World";
    world.doc = "Bodies below it are simulated together. Its child `step` describes the last step.";
    for (const auto& group : {simulation(hosting), mixing(hosting), tuning(hosting)})
        world.properties.insert(world.properties.end(), group.begin(), group.end());
    world.methods = world_methods(hosting);
    world.methods.push_back(ghosts_method(hosting));
    world.events = world_events();
    world.lifecycle =
        lifecycle_of<&Hosting::create_world, &Hosting::place_world, &Hosting::destroy_world>(
            hosting);
    world.lifecycle.draw_over = draw_world_overlays;
    hosting.classes.world = &hosting.tree.define(std::move(world));
    hosting.declared.mix_surfaces = hosting.classes.world->event("mix_surfaces");
    hosting.declared.filter_pair = hosting.classes.world->event("filter_pair");
}

}  // namespace fettle::physics_module
