// The properties, methods and events of Emitter.

#include <algorithm>
#include <numbers>

#include <emitters/emitters.h>
#include <properties/properties.h>

namespace fettle::visuals {

using property::accessor;
using property::Handle;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

constexpr std::int64_t most_particles = 200'000;

}  // namespace

std::vector<Property> Emitters::flow_properties() {
    return {
        {.name = "rate",
         .type = Type::number,
         .default_value = 20.0,
         .unit = "1/s",
         .range = {0, 1e6},
         .doc = "Number of particles that begin in a second."},
        {.name = "burst",
         .type = Type::integer,
         .range = {0, static_cast<double>(most_particles)},
         .doc = "Number of particles that begin at once, when it is placed or when `playing` "
                "becomes true."},
        {.name = "playing",
         .type = Type::boolean,
         .default_value = true,
         .doc = "Whether new particles begin. Those that have begun live on."},
        {.name = "limit",
         .type = Type::integer,
         .default_value = 1000,
         .range = {0, static_cast<double>(most_particles)},
         .doc = "Largest number of particles at a time; no further ones begin. All emitters "
                "together have at most 500 000."},
        {.name = "seed",
         .type = Type::integer,
         .range = {0, 1e15},
         .doc = "Emitters with the same seed and properties make the same particles."},
        {.name = "shape",
         .type = Type::text,
         .default_value = "point",
         .doc = "Where particles begin: at its position, anywhere in an ellipse (circle) or a "
                "rectangle (box) of the size `area`, or on the line around the ellipse (ring).",
         .enumerators = {"point", "circle", "ring", "box"}},
        {.name = "area",
         .type = Type::vec2,
         .default_value = Vec2(1, 1),
         .unit = "m",
         .range = {0, 1e6},
         .doc = "Width and height of the shape; pixels in a layer on the screen."},
        {.name = "space",
         .type = Type::text,
         .default_value = "world",
         .doc = "world: particles stay where they are when the emitter moves on. local: they move "
                "and turn with it.",
         .enumerators = {"world", "local"}},
        {.name = "count",
         .type = Type::integer,
         .doc = "Number of particles now.",
         .binding = accessor(*this,
                             [](Emitters& e, property::Row row) {
                                 return Value(
                                     static_cast<std::int64_t>(e.rows_[row].particles.size()));
                             }),
         .read_only = true,
         .transient = true,
         .simulated = true},
    };
}

std::vector<Property> Emitters::motion_properties() {
    return {
        position_property("Where it is, relative to its parent; pixels in a layer on the "
                          "screen."),
        {.name = "angle",
         .type = Type::number,
         .unit = "rad",
         .range = {-1e6, 1e6},
         .doc = "Direction in which particles fly: 0 is to the right, pi / 2 upwards. Relative to "
                "its parent."},
        {.name = "spread",
         .type = Type::number,
         .default_value = 2 * std::numbers::pi,
         .unit = "rad",
         .range = {0, 2 * std::numbers::pi},
         .doc = "Angle between the outermost directions. 2 pi: all directions."},
        {.name = "speed",
         .type = Type::number,
         .default_value = 2.0,
         .unit = "m/s",
         .range = {-1e6, 1e6},
         .doc = "Speed at which particles begin; pixels in a layer on the screen."},
        {.name = "lifetime",
         .type = Type::number,
         .default_value = 1.0,
         .unit = "s",
         .range = {1e-3, 1e4},
         .doc = "Time after which a particle ends."},
        {.name = "randomness",
         .type = Type::number,
         .default_value = 0.3,
         .range = {0, 1},
         .doc = "Share by which lifetime, speed and size of a particle are larger or smaller."},
        {.name = "gravity",
         .type = Type::vec2,
         .unit = "m/s\xC2\xB2",
         .range = {-1e6, 1e6},
         .doc = "Acceleration of all particles; pixels, y down, in a layer on the screen."},
        {.name = "damping",
         .type = Type::number,
         .unit = "1/s",
         .range = {0, 1e4},
         .doc = "Share of their velocity that particles lose in a second, for small values."},
        {.name = "rotation",
         .type = Type::number,
         .unit = "rad/s",
         .range = {-1e4, 1e4},
         .doc = "How fast particles turn, half of them to either side. Unless it is 0, each begins "
                "at an angle of its own."},
    };
}

std::vector<Property> Emitters::look_properties() {
    return {
        {.name = "image",
         .type = Type::text,
         .doc = "An image file in the game's folder; a soft white dot if it is empty."},
        {.name = "size",
         .type = Type::list,
         .default_value = property::List{Value(0.2)},
         .unit = "m",
         .range = {0, 1e6},
         .doc = "Heights of a particle over its life, at equal distances from its beginning to its "
                "end; pixels in a layer on the screen.",
         .element = Type::number},
        {.name = "color",
         .type = Type::list,
         .default_value =
             property::List{Value(property::Color{1, 1, 1, 1}), Value(property::Color{1, 1, 1, 0})},
         .range = {0, 1},
         .doc = "Colors over its life, by which those of the image are multiplied.",
         .element = Type::color},
        blend_property(),
        visible_property(),
        {.name = "smooth",
         .type = Type::boolean,
         .default_value = images_.smooth.value_or(true),
         .doc = "Whether pixels are mixed when the image is enlarged; otherwise each is a square."},
    };
}

std::vector<property::Method> Emitters::methods() {
    property::Method emit{
        .name = "emit",
        .parameters = {{.name = "count",
                        .type = Type::integer,
                        .doc = "Number of particles, up to `limit` at a time."}},
        .required = 1,
        .doc = "Lets particles begin at once, in the next step, also while it is not playing.",
        .context = this,
        .call = [](void* context, property::Tree&, Handle, property::Row row,
                   std::span<const Value> given) -> property::Result {
            State& state = static_cast<Emitters*>(context)->rows_[row].state;
            const std::int64_t more =
                std::clamp<std::int64_t>(given[0].integer(), 0, most_particles);
            state.wanted = static_cast<std::uint32_t>(
                std::min<std::int64_t>(most_particles, state.wanted + more));
            return Value();
        },
        .effect = property::Effect::memory};
    property::Method clear{.name = "clear",
                           .doc = "Removes all particles.",
                           .context = this,
                           .call = [](void* context, property::Tree&, Handle, property::Row row,
                                      std::span<const Value>) -> property::Result {
                               static_cast<Emitters*>(context)->rows_[row].particles.clear();
                               return Value();
                           },
                           .effect = property::Effect::memory};
    return {emit, clear};
}

property::Lifecycle Emitters::lifecycle() {
    property::Lifecycle made;
    made.context = this;
    made.create = [](void* context, property::Tree&, Handle self) {
        return static_cast<Emitters*>(context)->add(self);
    };
    made.destroy = [](void* context, property::Tree&, Handle, property::Row row) {
        auto& e = *static_cast<Emitters*>(context);
        e.rows_[row] = {};
        e.free_.push_back(row);
    };
    made.draw = [](void* context, const property::Tree&, Handle, property::Row row,
                   property::Painter& painter, double alpha) {
        auto& e = *static_cast<Emitters*>(context);
        e.draw(e.rows_[row], painter, alpha);
    };
    return made;
}

void Emitters::define(property::Tree& tree) {
    tree_ = &tree;
    property::ClassDescriptor described{
        .name = "Emitter",
        .doc =
            "Sparks, smoke, rain: many small pictures that begin here, fly, change and end. Its "
            "parent moves it: a body, a sprite, or any instance with a `position`.",
        .snapshots = property::Snapshots::natively,
        .weight = 900};
    for (const auto& group : {flow_properties(), motion_properties(), look_properties()})
        described.properties.insert(described.properties.end(), group.begin(), group.end());
    described.methods = methods();
    described.events = {{.name = "finished",
                         .doc = "Its last particle has ended, and no other will begin by itself: "
                                "`rate` is 0, or it is not playing."}};
    described.lifecycle = lifecycle();
    const property::Class& made = tree.define(std::move(described));
    class_ = &made;
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("rate"),       of("burst"),   of("lifetime"), of("speed"),    of("spread"),
           of("randomness"), of("gravity"), of("damping"),  of("size"),     of("color"),
           of("rotation"),   of("image"),   of("shape"),    of("area"),     of("space"),
           of("limit"),      of("seed"),    of("playing"),  of("position"), of("angle"),
           of("blend"),      of("visible"), of("smooth")};
    finished_ = made.event("finished");
}

}  // namespace fettle::visuals
