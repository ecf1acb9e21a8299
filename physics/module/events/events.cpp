// Events of a step, reported to handlers. An event without handlers costs nothing: no record of it
// is made.

#include <utility>

#include <bindings/bindings.h>
#include <events/events.h>

namespace fettle::physics_module {
namespace {

using property::Event;
using property::Field;

/// At the beginning of a touch both shapes exist; at its end one of them may be deleted already.
enum class Moment { begin, end };

/// Fields of an event that both bodies get, each from its side.
std::vector<Field> pair_fields(Moment moment) {
    return {
        {"other", Type::reference, "",
         moment == Moment::begin
             ? "The other body; the world itself for its bounds."
             : "The other body; the world itself for its bounds. It may have been deleted: then "
               "the record's other_alive is false, and only alive(), name, class and is_a() can be "
               "used."},
        {.name = "shape",
         .type = Type::reference,
         .doc = "The shape of this body; nil for the capsule of a mover.",
         .reference_class = "Shape",
         .nullable = true},
        {.name = "other_shape",
         .type = Type::reference,
         .doc = "The shape of the other; nil for the bounds and for the capsule of a mover.",
         .reference_class = "Shape",
         .nullable = true},
    };
}

/// `impulse`: description of the event's impulse.
std::vector<Field> contact_fields(const std::string& impulse) {
    std::vector<Field> fields = pair_fields(Moment::begin);
    const std::vector<Field> rest = {
        {"point", Type::vec2, "m", "Point of the contact in the world."},
        {"normal", Type::vec2, "", "Direction from this body to the other; its length is 1."},
        {"impulse", Type::number, "N s", impulse},
        {"speed", Type::number, "m/s", "Speed at which they approached each other."},
        {.name = "friction", .doc = "Coefficient mixed from both surfaces.", .range = not_negative},
        {.name = "restitution", .doc = "Mixed from both surfaces.", .range = fraction},
    };
    fields.insert(fields.end(), rest.begin(), rest.end());
    return fields;
}

std::vector<Field> questioned_fields() {
    std::vector<Field> fields =
        contact_fields("Impulse between them in the step before; 0 if they have just met.");
    fields.push_back({"enabled", Type::boolean, "", "True if the contact acts in this step."});
    return fields;
}

Handle found(const std::unordered_map<std::uint32_t, Handle>& departed, std::uint32_t generation) {
    const auto at = departed.find(generation);
    return at == departed.end() ? Handle{} : at->second;
}

/// Adds the data of an impact for one of the two sides; `side`: -1 for the second.
void add_impact(std::vector<Value>& to, const auto& e, float side) {
    to.insert(to.end(),
              {to_value(e.point), to_value(physics::Vec2(side * e.normal)), to_value(e.impulse),
               to_value(e.speed), to_value(e.friction), to_value(e.restitution)});
}

}  // namespace

std::vector<Event> contact_events(std::string_view of) {
    const std::string self(of);
    const std::string each_pair =
        "Reported once for each pair of shapes: a body of two shapes causes two.";
    return {
        {.name = "contact_begin",
         .fields = contact_fields("Impulse of their first contact."),
         .doc = "The " + self + " began to touch another. " + each_pair},
        {.name = "contact_persist",
         .fields = contact_fields("Impulse between them in this step."),
         .doc = "The " + self + " still touches another: reported in every step after the first."},
        {.name = "before_solve",
         .fields = questioned_fields(),
         .doc = "Asked in the step, before a contact of the " + self +
                " acts: the handler may change friction and restitution, and with enabled = "
                "false both pass through each other in this step. Asked once for two shapes, "
                "however many parts of them touch. The handler cannot write anything else."},
        {.name = "contact_end",
         .fields = pair_fields(Moment::end),
         .doc = "The " + self + " stopped touching another. " + each_pair},
        {.name = "contact_hit",
         .fields = contact_fields(
             "Impulse that would stop the impact at the point with the highest speed of impact."),
         .doc = "The " + self + " was hit faster than the world's hit_threshold."},
        {.name = "sensor_begin",
         .fields = pair_fields(Moment::begin),
         .doc = "The " + self + " entered a sensor, or a shape entered this sensor. " + each_pair},
        {.name = "sensor_end",
         .fields = pair_fields(Moment::end),
         .doc = "The " + self + " left a sensor, or a shape left this sensor. " + each_pair},
    };
}

void Hosting::register_pair_events(const property::Class& defined, const Event* PairEvent::*of) {
    for (const auto& [event, name] : {std::pair(&declared.contact_begin, "contact_begin"),
                                      std::pair(&declared.contact_persist, "contact_persist"),
                                      std::pair(&declared.before_solve, "before_solve"),
                                      std::pair(&declared.contact_end, "contact_end"),
                                      std::pair(&declared.contact_hit, "contact_hit"),
                                      std::pair(&declared.sensor_begin, "sensor_begin"),
                                      std::pair(&declared.sensor_end, "sensor_end")})
        event->*of = defined.event(name);
}

Hosting::PairSide Hosting::pair_side(HostedWorld& hosted, physics::BodyId body,
                                     physics::ShapeId shape) const {
    physics::World& world = hosted.world;
    PairSide side;
    if (body.index == 0)
        side.body = hosted.self;  // the bounds
    else
        side.body = world.is_valid(body) ? unpack(world.body(body).user_data())
                                         : found(hosted.departed_bodies, body.generation);
    side.shape = world.is_valid(shape) ? unpack(world.shape(shape).user_data())
                                       : found(hosted.departed_shapes, shape.generation);
    return side;
}

/// `add_rest`: adds the values of the event other than its sides to the values of a record.
template <class AddRest>
void Hosting::emit_pair(const PairEvent& event, const PairSide& self, const PairSide& other,
                        const AddRest& add_rest) {
    const auto emit = [&](Handle to, const Event& which) {
        if (which.listeners == 0 || !tree.alive(to) || !tree.listens(to, which)) return;
        std::vector<Value> values;
        values.reserve(which.fields.size());
        values.insert(values.end(), {other.body, self.shape, other.shape});
        add_rest(values);
        tree.emit(to, which, std::move(values));
    };
    if (tree.alive(self.body) && tree.class_of(self.body).is_a(*classes.body))
        emit(self.body, *event.of_body);
    emit(self.shape, *event.of_shape);
}

void Hosting::report(HostedWorld& hosted) {
    const physics::Events& events = hosted.world.events();
    const auto pair = [&](const PairEvent& event, const auto& list, const auto& add_rest) {
        if (!event.has_handlers()) return;
        for (const auto& e : list) {
            const PairSide a = pair_side(hosted, e.body_a, e.shape_a);
            const PairSide b = pair_side(hosted, e.body_b, e.shape_b);
            emit_pair(event, a, b, [&](std::vector<Value>& to) { add_rest(to, e, 1.0f); });
            emit_pair(event, b, a, [&](std::vector<Value>& to) { add_rest(to, e, -1.0f); });
        }
    };
    const auto sensed = [&](const PairEvent& event, const auto& list) {
        if (!event.has_handlers()) return;
        for (const physics::SensorEvent& e : list) {
            const PairSide sensor = pair_side(hosted, e.sensor_body, e.sensor);
            const PairSide visitor = pair_side(hosted, e.visitor_body, e.visitor);
            emit_pair(event, sensor, visitor, [](std::vector<Value>&) {});
            emit_pair(event, visitor, sensor, [](std::vector<Value>&) {});
        }
    };
    const auto nothing = [](std::vector<Value>&, const auto&, float) {};
    const auto all = [](std::vector<Value>& to, const auto& e, float side) {
        add_impact(to, e, side);
    };
    pair(declared.contact_end, events.contact_end, nothing);
    pair(declared.contact_begin, events.contact_begin, all);
    pair(declared.contact_persist, events.contact_persist, all);
    pair(declared.contact_hit, events.contact_hit, all);
    sensed(declared.sensor_end, events.sensor_end);
    sensed(declared.sensor_begin, events.sensor_begin);
    const auto each = [&](const Event& event, const std::vector<physics::BodyId>& bodies) {
        if (event.listeners == 0) return;
        for (const physics::BodyId id : bodies)
            if (const Handle self = pair_side(hosted, id, {}).body;
                tree.alive(self) && tree.listens(self, event))
                tree.emit(self, event, {});
    };
    each(*declared.woke, events.woke);
    each(*declared.slept, events.slept);
    const auto strained = [&](const Event& event, const auto& reported) {
        for (const auto& e : reported) {
            const physics::Joint joint = hosted.world.joint(e.joint);
            const Handle self = joint ? instance_of(joint.user_data()) : Handle{};
            if (self && tree.listens(self, event))
                tree.emit(self, event, {to_value(e.force), to_value(e.torque)});
        }
    };
    strained(*declared.loaded, events.joint_loaded);
    strained(*declared.broke, events.joint_broke);
    hosted.departed_bodies.clear();
    hosted.departed_shapes.clear();
}

}  // namespace fettle::physics_module
