// Events whose handlers answer inside a step: before a contact is solved, how surfaces mix, whether
// two shapes collide. The library has a callback only while there is a handler.

#include <utility>

#include <fettle/property/question.h>

#include <bindings/bindings.h>
#include <events/events.h>

namespace fettle::physics_module {

using property::Event;
using property::Field;

std::vector<Event> world_events() {
    const std::vector<Field> shapes = {
        {"shape", Type::reference, "",
         "One of the two shapes; nil for the bounds of the world and the capsule of a mover."},
        {"other_shape", Type::reference, "", "The second shape; nil for the capsule of a mover."},
        {"body", Type::reference, "", "Body of the first shape; the world itself for its bounds."},
        {"other", Type::reference, "", "Body of the second shape."},
    };
    std::vector<Field> mix = shapes, filter = shapes;
    const std::vector<Field> surface = {
        {"point", Type::vec2, "m", "Point of the contact in the world."},
        {"normal", Type::vec2, "", "Direction from the first shape to the second."},
        {"impulse", Type::number, "N s", "Impulse between them in the step before."},
        {"speed", Type::number, "m/s", "Speed at which they approach each other."},
        {.name = "friction",
         .doc = "Friction mixed by the rule of the world; may be changed.",
         .range = not_negative},
        {.name = "restitution",
         .doc = "Restitution mixed by the rule of the world; may be changed.",
         .range = fraction},
        {"surface_speed", Type::number, "m/s", "Speed of both surfaces together; may be changed."},
    };
    mix.insert(mix.end(), surface.begin(), surface.end());
    filter.push_back({"collide", Type::boolean, "", "True if they collide; may be changed."});
    return {
        {.name = "mix_surfaces",
         .fields = std::move(mix),
         .doc = "Asked in the step for every contact: the friction and restitution of two "
                "surfaces together. The handler cannot write anything else."},
        {.name = "filter_pair",
         .fields = std::move(filter),
         .doc = "Asked in the step when two shapes whose filters agree come near each other: "
                "whether they collide. The handler cannot write anything else."},
    };
}

/// Enables the events and callbacks of the library that have handlers; the others would cost time.
/// This wakes no body.
void Hosting::update_callbacks() {
    Wanted wanted;
    wanted.hits = declared.contact_hit.has_handlers();
    wanted.persisting = declared.contact_persist.has_handlers();
    wanted.before_solve = declared.before_solve.has_handlers();
    wanted.mixing = declared.mix_surfaces->listeners != 0;
    wanted.filter = declared.filter_pair->listeners != 0;
    if (wanted == wanted_) return;
    const Wanted before = std::exchange(wanted_, wanted);
    for (const auto& hosted : worlds_)
        if (hosted != nullptr) set_callbacks(*hosted, before);
}

void Hosting::set_callbacks(HostedWorld& hosted, const Wanted& before) {
    HostedWorld* const of = &hosted;
    physics::World& world = hosted.world;
    if (wanted_.hits != before.hits)
        for (physics::Shape& shape : world.shapes()) shape.set_hit_events(wanted_.hits);
    world.set_persist_events(wanted_.persisting);
    // Handlers may be functions of a script, and the tree is not made for several threads.
    physics::HostAccess::set_serial_callbacks(world, wanted_.before_solve || wanted_.mixing);
    if (wanted_.before_solve != before.before_solve) {
        world.set_before_solve(!wanted_.before_solve ? physics::ContactCallback()
                                                     : [this, of](physics::ContactEdit& contact) {
                                                           call_before_solve(*of, contact);
                                                       });
    }
    if (wanted_.mixing != before.mixing) {
        world.set_mixing(!wanted_.mixing ? physics::ContactCallback()
                                         : [this, of](physics::ContactEdit& contact) {
                                               call_mixing(*of, contact);
                                           });
    }
    if (wanted_.filter != before.filter) {
        world.set_filter(!wanted_.filter
                             ? physics::PairFilter()
                             : [this, of](const physics::Shape& a, const physics::Shape& b) {
                                   return call_filter(*of, a, b);
                               });
    }
}

void Hosting::call_before_solve(HostedWorld& hosted, physics::ContactEdit& contact) {
    const PairSide a = pair_side(hosted, contact.shape_a.body().id(), contact.shape_a.id());
    const PairSide b = pair_side(hosted, contact.shape_b.body().id(), contact.shape_b.id());
    const auto call_side = [&](const PairSide& self, const PairSide& other, float side) {
        const auto call_one = [&](Handle to, const Event& event) {
            if (event.listeners == 0 || !to || !tree.listens(to, event)) return;
            std::vector<Value> values = {
                other.body,
                self.shape,
                other.shape,
                to_value(contact.point),
                to_value(physics::Vec2(side * contact.normal)),
                to_value(contact.impulse),
                to_value(contact.speed),
                to_value(contact.friction),
                to_value(contact.restitution),
                to_value(contact.enabled),
            };
            property::call_handlers(tree, to, event, values, 7);
            contact.friction = from_value<float>(values[7]);
            contact.restitution = from_value<float>(values[8]);
            contact.enabled = from_value<bool>(values[9]);
        };
        if (self.body && tree.alive(self.body) && tree.class_of(self.body).is_a(*classes.body))
            call_one(self.body, *declared.before_solve.of_body);
        call_one(self.shape, *declared.before_solve.of_shape);
    };
    call_side(a, b, 1.0f);
    call_side(b, a, -1.0f);
}

void Hosting::call_mixing(HostedWorld& hosted, physics::ContactEdit& contact) {
    if (!tree.listens(hosted.self, *declared.mix_surfaces)) return;
    const PairSide a = pair_side(hosted, contact.shape_a.body().id(), contact.shape_a.id());
    const PairSide b = pair_side(hosted, contact.shape_b.body().id(), contact.shape_b.id());
    std::vector<Value> values = {
        a.shape,
        b.shape,
        a.body,
        b.body,
        to_value(contact.point),
        to_value(contact.normal),
        to_value(contact.impulse),
        to_value(contact.speed),
        to_value(contact.friction),
        to_value(contact.restitution),
        to_value(contact.surface_speed),
    };
    property::call_handlers(tree, hosted.self, *declared.mix_surfaces, values, 8);
    contact.friction = from_value<float>(values[8]);
    contact.restitution = from_value<float>(values[9]);
    contact.surface_speed = from_value<float>(values[10]);
}

bool Hosting::call_filter(HostedWorld& hosted, const physics::Shape& one,
                          const physics::Shape& other) {
    if (!hosted.self || !tree.listens(hosted.self, *declared.filter_pair)) return true;
    const PairSide a = pair_side(hosted, one.body().id(), one.id());
    const PairSide b = pair_side(hosted, other.body().id(), other.id());
    std::vector<Value> values = {a.shape, b.shape, a.body, b.body, true};
    property::call_handlers(tree, hosted.self, *declared.filter_pair, values, 4);
    return from_value<bool>(values[4]);
}

}  // namespace fettle::physics_module
