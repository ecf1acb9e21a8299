#include <mover/support.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {
namespace {

bool is_pushed(const Load& load) {
    return load.force.x != 0.0f || load.force.y != 0.0f || load.torque != 0.0f;
}

}  // namespace

bool is_supported(const WorldData& data, uint32_t body, uint32_t left_out) {
    constexpr size_t most = 64;  // examined bodies; a larger heap counts as supported
    if (data.field_slots.count > 0) return true;
    std::vector<uint32_t> group = {body};
    bool supported = false;
    const auto reach = [&](uint32_t other) {
        if (other == left_out && left_out != 0) return;
        supported = supported || data.bodies[other].mobility != Mobility::dynamic;
        if (std::find(group.begin(), group.end(), other) == group.end()) group.push_back(other);
    };
    for (size_t i = 0; i < group.size() && !supported; ++i) {
        const BodyRecord& record = data.bodies[group[i]];
        if (i >= most || is_pushed(record.load) || is_pushed(record.step_load)) return true;
        data.for_each_joint(group[i], [&](uint32_t joint, uint32_t side) {
            if (data.joints[joint].moves()) reach(data.joints[joint].bodies[side ^ 1]);
        });
        data.for_each_contact(group[i], [&](uint32_t contact) {
            if (data.contacts[contact].acts()) reach(data.other_body(contact, group[i]));
        });
    }
    return supported;
}

}  // namespace fettle::physics::detail
