#include "wild/checks/groups.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace fettle::bench::wild {
namespace {

struct Links {
    bool contacts = false, joints = false;
};

/// The bodies for which `begins` holds, and those that links connect with them.
std::vector<bool> connected(const Moment& moment, Links links,
                            const std::function<bool(std::size_t body)>& begins) {
    std::vector<bool> reached(moment.after.size(), false);
    std::vector<int> open;
    const auto reach = [&](int index) {
        if (index == the_world || reached[std::size_t(index)]) return;
        reached[std::size_t(index)] = true;
        open.push_back(index);
    };
    for (std::size_t i = 0; i < moment.after.size(); ++i)
        if (moment.after[i].exists && begins(i)) reach(int(i));
    while (!open.empty()) {
        const int index = open.back();
        open.pop_back();
        for (const std::vector<BodyNow>* bodies : {&moment.before, &moment.after})
            for (const int other : (*bodies)[std::size_t(index)].touched)
                if (links.contacts && other != the_world &&
                    moment.after[std::size_t(other)].type == BodyType::dynamic_body)
                    reach(other);
        if (!links.joints) continue;
        for (const JointPlan& joint : moment.plan.joints) {
            if (joint.a == index) reach(joint.b);
            if (joint.b == index) reach(joint.a);
        }
    }
    return reached;
}

/// The kinematic bodies, and those that links connect with them.
std::vector<bool> connected_with_kinematic(const Moment& moment, Links links) {
    return connected(moment, links, [&](std::size_t body) {
        return moment.after[body].type == BodyType::kinematic_body;
    });
}

bool is_wedged(const Moment& moment, const JointPlan& joint) {
    if (joint.a == the_world || joint.b == the_world) return false;
    const std::vector<int>& one = moment.after[std::size_t(joint.a)].touched;
    return std::ranges::any_of(moment.after[std::size_t(joint.b)].touched, [&](int other) {
        return other != the_world && std::ranges::count(one, other) > 0 &&
               moment.after[std::size_t(other)].type == BodyType::dynamic_body;
    });
}

}  // namespace

std::vector<bool> held_by_static(const Moment& moment) {
    return connected(moment, {.contacts = true, .joints = true}, [&](std::size_t i) {
        const BodyNow& body = moment.after[i];
        return body.type == BodyType::static_body ||
               std::ranges::count(body.touched, the_world) > 0;
    });
}

std::vector<bool> pressed(const Moment& moment) {
    return connected_with_kinematic(moment, {.contacts = true, .joints = true});
}

std::vector<bool> pulled(const Moment& moment) {
    return connected_with_kinematic(moment, {.joints = true});
}

std::vector<bool> held_in_overlap(const Moment& moment) {
    return connected(moment, {.joints = true},
                     [&](std::size_t i) { return moment.after[i].deepest > 0.02f; });
}

std::vector<bool> joined_at_wedge(const Moment& moment) {
    std::vector<bool> wedged(moment.after.size(), false);
    if (moment.plan.def.solver == Solver::soft_step) return wedged;
    for (const JointPlan& joint : moment.plan.joints)
        if (is_wedged(moment, joint)) wedged[std::size_t(joint.a)] = true;
    return connected(moment, {.joints = true}, [&](std::size_t i) { return wedged[i]; });
}

std::vector<float> loads_of_joined(const Moment& moment) {
    std::vector<int> group(moment.after.size());
    std::iota(group.begin(), group.end(), 0);
    for (const JointPlan& joint : moment.plan.joints) {
        if (joint.a == the_world || joint.b == the_world) continue;
        const int kept = group[std::size_t(joint.a)], joined = group[std::size_t(joint.b)];
        std::ranges::replace(group, joined, kept);
    }
    std::vector<float> sums(group.size(), 0), loads(group.size());
    for (std::size_t i = 0; i < group.size(); ++i)
        if (moment.after[i].type == BodyType::dynamic_body)
            sums[std::size_t(group[i])] += moment.after[i].load;
    for (std::size_t i = 0; i < group.size(); ++i) loads[i] = sums[std::size_t(group[i])];
    return loads;
}

}  // namespace fettle::bench::wild
