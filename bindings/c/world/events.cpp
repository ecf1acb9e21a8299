#include <fettle/physics_c/events.h>

#include <calls/calls.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

template <class Event>
fettle_contact_event contact_in_c(const Event& e) {
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
fettle_contact_event in_c(const ContactBeginEvent& event) {
    return contact_in_c(event);
}
fettle_contact_event in_c(const ContactPersistEvent& event) {
    return contact_in_c(event);
}
fettle_contact_event in_c(const ContactHitEvent& event) {
    return contact_in_c(event);
}
fettle_contact_end_event in_c(const ContactEndEvent& e) {
    return {converted(e.shape_a), converted(e.shape_b), converted(e.body_a), converted(e.body_b)};
}
fettle_sensor_event in_c(const SensorEvent& e) {
    return {converted(e.sensor), converted(e.visitor), converted(e.sensor_body),
            converted(e.visitor_body)};
}
fettle_joint_break_event in_c(const JointBreakEvent& e) {
    return {converted(e.joint), converted(e.body_a), converted(e.body_b), converted(e.force),
            e.torque};
}
fettle_joint_load_event in_c(const JointLoadEvent& e) {
    return {converted(e.joint), converted(e.body_a), converted(e.body_b), converted(e.force),
            e.torque};
}
fettle_id in_c(const BodyId& id) {
    return converted(id);
}

template <class Event, class InC>
void copy_events(const std::vector<Event>& events, std::vector<InC>& kept, const InC*& begin,
                 uint32_t& count) {
    kept.clear();
    for (const Event& event : events) kept.push_back(in_c(event));
    begin = kept.data();
    count = uint32_t(kept.size());
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_world_events(fettle_world* world, fettle_events* events) {
    return guarded(__func__, [&] {
        fettle_events& target = needed("events", events);
        const fettle::physics::Events& of = live(world).events();
        ReturnedEvents& kept = world->events;
        fettle_events result{};
        const auto all = [&](const auto& list, auto& copies, auto& begin, uint32_t& count) {
            copy_events(list, copies, begin, count);
        };
        all(of.contact_begin, kept.contact_begin, result.contact_begin, result.contact_begin_count);
        all(of.contact_persist, kept.contact_persist, result.contact_persist,
            result.contact_persist_count);
        all(of.contact_end, kept.contact_end, result.contact_end, result.contact_end_count);
        all(of.contact_hit, kept.contact_hit, result.contact_hit, result.contact_hit_count);
        all(of.sensor_begin, kept.sensor_begin, result.sensor_begin, result.sensor_begin_count);
        all(of.sensor_end, kept.sensor_end, result.sensor_end, result.sensor_end_count);
        all(of.joint_broke, kept.joint_broke, result.joint_broke, result.joint_broke_count);
        all(of.joint_loaded, kept.joint_loaded, result.joint_loaded, result.joint_loaded_count);
        all(of.slept, kept.slept, result.slept, result.slept_count);
        all(of.woke, kept.woke, result.woke, result.woke_count);
        target = result;
    });
}
