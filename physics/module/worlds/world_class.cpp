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
    if (box.min.x() == box.max.x() || box.min.y() == box.max.y())
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
               "Pulls every dynamic body, as far as its gravity_scale lets it.",
               bound<&World::gravity, &World::set_gravity>(hosting)),
        {.name = "substeps",
         .type = Type::integer,
         .default_value = defaults.substeps,
         .range = {.min = 1, .max = 64},
         .doc = "Parts a step is solved in: more is stiffer and slower.",
         .binding = bound<&World::substeps, &World::set_substeps>(hosting)},
        {.name = "threads",
         .type = Type::integer,
         .default_value = 1,
         .range = {.min = 1, .max = 64},
         .doc = "How many threads share a step; the machine runs no more of them at a time than it "
                "has "
                "processors. The number changes no result.",
         .binding = accessor(
             hosting, [](Hosting& h, Row row) { return Value(h.world(row).threads()); },
             [](Hosting& h, Row row, const Value& value) { set_threads(h, row, value); }),
         .transient = true},
        choice<solvers, &World::solver, &World::set_solver>(
            hosting, "solver", solvers[0],
            "How contacts and joints are solved: \"soft_step\" sweeps over them in small steps and "
            "remembers; \"sequential\" goes over the contacts once, the worst first, as in 2008; "
            "\"direct\" solves all that touch each other as one problem."),
        {.name = "bounds",
         .type = Type::list,
         .unit = "m",
         .range = coordinates,
         .doc = "Walls round the world, given by their lower left and upper right corner; nil: "
                "none.",
         .binding = accessor(
             hosting, [](Hosting& h, Row row) { return bounds(h, row); },
             [](Hosting& h, Row row, const Value& value) { set_bounds(h, row, value); }),
         .nullable = true,
         .element = Type::vec2,
         .single_precision = true},
        flag("sleeping", defaults.sleeping,
             "What rests falls asleep and costs nothing until it is disturbed.",
             bound<&World::sleeping, &World::set_sleeping>(hosting)),
        flag("continuous", defaults.continuous,
             "However fast, bodies do not pass through static ones.",
             bound<&World::continuous, &World::set_continuous>(hosting)),
    };
}

std::vector<Property> mixing(Hosting& hosting) {
    return {
        choice<mix_rules, &World::friction_mix, &World::set_friction_mix>(
            hosting, "friction_mix", "geometric",
            "How the friction of two surfaces makes that of their contact: \"geometric\" is the "
            "root of their product."),
        choice<mix_rules, &World::restitution_mix, &World::set_restitution_mix>(
            hosting, "restitution_mix", "maximum",
            "How the restitution of two surfaces makes that of their contact."),
    };
}

std::vector<Property> tuning(Hosting& hosting) {
    const physics::WorldDef defaults;
    Property bounce =
        amount("bounds_restitution", defaults.bounds_restitution, "",
               "How much of its speed what hits the walls gets back.",
               bound<&World::bounds_restitution, &World::set_bounds_restitution>(hosting));
    bounce.range = fraction;
    return {
        amount("bounds_friction", defaults.bounds_friction, "", "Of the walls of the bounds.",
               bound<&World::bounds_friction, &World::set_bounds_friction>(hosting)),
        bounce,
        amount("restitution_threshold", defaults.restitution_threshold, "m/s",
               "Slower impacts do not bounce.",
               bound<&World::restitution_threshold, &World::set_restitution_threshold>(hosting)),
        amount("hit_threshold", defaults.hit_threshold, "m/s",
               "Slower impacts make no contact_hit.",
               bound<&World::hit_threshold, &World::set_hit_threshold>(hosting)),
        amount("sleep_speed", defaults.sleep_speed, "m/s", "What is slower than this rests.",
               bound<&World::sleep_speed, &World::set_sleep_speed>(hosting)),
        amount("sleep_delay", defaults.sleep_delay, "s",
               "How long something rests before it falls asleep.",
               bound<&World::sleep_delay, &World::set_sleep_delay>(hosting)),
        amount("contact_hertz", defaults.contact_hertz, "Hz",
               "Stiffness of contacts, at most a quarter of the rate of sub-steps.",
               bound<&World::contact_hertz, &World::set_contact_hertz>(hosting)),
        amount("contact_damping", defaults.contact_damping, "", "Damping ratio of contacts.",
               bound<&World::contact_damping, &World::set_contact_damping>(hosting)),
        amount("push_speed", defaults.push_speed, "m/s",
               "The fastest that an overlap is pushed apart.",
               bound<&World::push_speed, &World::set_push_speed>(hosting)),
    };
}

/// Step statistics that a user moved to another parent may outlive their world; then they show
/// those of limbo.
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
    statistics.doc = "What the last step of a world did, and how long that took.";
    statistics.creatable = false;
    statistics.properties = {
        statistic<&S::steps>(h, "steps", "Steps since the world was made."),
        statistic<&S::bodies>(h, "bodies", "Bodies in the world."),
        statistic<&S::awake_bodies>(h, "awake_bodies", "Bodies that took part in the step."),
        statistic<&S::shapes>(h, "shapes", "Shapes of all bodies."),
        statistic<&S::joints>(h, "joints", "Joints that act on a body."),
        statistic<&S::awake_joints>(h, "awake_joints", "Joints on a body that is awake."),
        statistic<&S::contacts>(h, "contacts", "Pairs of shapes near each other."),
        statistic<&S::awake_contacts>(h, "awake_contacts",
                                      "Pairs of shapes near each other of which a body is awake."),
        statistic<&S::touching>(h, "touching", "Pairs near enough to be solved."),
        statistic<&S::islands>(h, "islands", "Groups of bodies that sleep together."),
        statistic<&S::moved_proxies>(h, "moved_proxies", "Shapes that left their box in the tree."),
        statistic<&S::direct_solves>(h, "direct_solves",
                                     "Problems that the direct solver solved: every group of "
                                     "bodies that touch has two in a part of a step."),
        statistic<&S::direct_failures>(h, "direct_failures",
                                       "Problems too large for the direct solver, or without a "
                                       "solution: solved by sweeps instead."),
        statistic<&S::edits_ms>(h, "edits_ms", "Time to bring up to date what was edited."),
        statistic<&S::pairs_ms>(h, "pairs_ms", "Time of the broad phase."),
        statistic<&S::narrow_ms>(h, "narrow_ms", "Time of the manifolds."),
        statistic<&S::solve_ms>(h, "solve_ms", "Time of forces, contacts and joints."),
        statistic<&S::finish_ms>(h, "finish_ms", "Time of poses, boxes and continuous collision."),
        statistic<&S::sleep_ms>(h, "sleep_ms", "Time to find what rests."),
        statistic<&S::total_ms>(h, "total_ms", "Time of the whole step."),
    };
    hosting.statistics_class = &hosting.tree.define(std::move(statistics));
}

void define_world(Hosting& hosting) {
    property::ClassDescriptor world;
    world.snapshots = property::Snapshots::natively;
    world.name = "World";
    world.doc =
        "Bodies below it are simulated together. Its child `step` tells about the last "
        "step.";
    for (const auto& group : {simulation(hosting), mixing(hosting), tuning(hosting)})
        world.properties.insert(world.properties.end(), group.begin(), group.end());
    world.methods = world_methods(hosting);
    world.events = world_events();
    world.lifecycle =
        lifecycle_of<&Hosting::create_world, &Hosting::place_world, &Hosting::destroy_world>(
            hosting);
    world.lifecycle.draw_over = draw_world_overlays;
    hosting.world_class = &hosting.tree.define(std::move(world));
    hosting.mix_surfaces = hosting.world_class->event("mix_surfaces");
    hosting.filter_pair = hosting.world_class->event("filter_pair");
}

}  // namespace fettle::physics_module
