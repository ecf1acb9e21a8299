#include <fettle/physics_c/events.h>

#include <calls/calls.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

template <class Event>
fettle_contact_event told_of_contact(const Event& e) {
    return {converted(e.shape_a),
            converted(e.shape_b),
            converted(e.body_a),
            converted(e.body_b),
            converted(e.point),
            converted(e.normal),
            e.speed,
            e.impulse,
            e.friction,
            e.restitution,
            e.part_a,
            e.part_b,
            e.material_a,
            e.material_b};
}
fettle_contact_event told_of(const ContactBeginEvent& event) {
    return told_of_contact(event);
}
fettle_contact_event told_of(const ContactPersistEvent& event) {
    return told_of_contact(event);
}
fettle_contact_event told_of(const ContactHitEvent& event) {
    return told_of_contact(event);
}
fettle_contact_end_event told_of(const ContactEndEvent& e) {
    return {converted(e.shape_a), converted(e.shape_b), converted(e.body_a), converted(e.body_b)};
}
fettle_sensor_event told_of(const SensorEvent& e) {
    return {converted(e.sensor), converted(e.visitor), converted(e.sensor_body),
            converted(e.visitor_body)};
}
fettle_joint_break_event told_of(const JointBreakEvent& e) {
    return {converted(e.joint), converted(e.body_a), converted(e.body_b), converted(e.force),
            e.torque};
}
fettle_joint_load_event told_of(const JointLoadEvent& e) {
    return {converted(e.joint), converted(e.body_a), converted(e.body_b), converted(e.force),
            e.torque};
}
fettle_id told_of(const BodyId& id) {
    return converted(id);
}

template <class Event, class Told>
void copy_events(const std::vector<Event>& events, std::vector<Told>& kept, const Told*& begin,
                 uint32_t& count) {
    kept.clear();
    for (const Event& event : events) kept.push_back(told_of(event));
    begin = kept.data();
    count = uint32_t(kept.size());
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_world_events(fettle_world* world, fettle_events* events) {
    return guarded(__func__, [&] {
        fettle_events& result = needed("events", events);
        const fettle::physics::Events& of = live(world).events();
        GivenEvents& kept = world->events;
        fettle_events told{};
        const auto all = [&](const auto& list, auto& copies, auto& begin, uint32_t& count) {
            copy_events(list, copies, begin, count);
        };
        all(of.contact_begin, kept.contact_begin, told.contact_begin, told.contact_begin_count);
        all(of.contact_persist, kept.contact_persist, told.contact_persist,
            told.contact_persist_count);
        all(of.contact_end, kept.contact_end, told.contact_end, told.contact_end_count);
        all(of.contact_hit, kept.contact_hit, told.contact_hit, told.contact_hit_count);
        all(of.sensor_begin, kept.sensor_begin, told.sensor_begin, told.sensor_begin_count);
        all(of.sensor_end, kept.sensor_end, told.sensor_end, told.sensor_end_count);
        all(of.joint_broke, kept.joint_broke, told.joint_broke, told.joint_broke_count);
        all(of.joint_loaded, kept.joint_loaded, told.joint_loaded, told.joint_loaded_count);
        all(of.slept, kept.slept, told.slept, told.slept_count);
        all(of.woke, kept.woke, told.woke, told.woke_count);
        result = told;
    });
}
