#include <checks/hooks.h>
#include <handles/live.h>

#include <algorithm>

// Accounts of the velocities of a body: the causes of their changes in the last step.

namespace fettle::physics {

using namespace detail;

void World::keep_account(BodyId body) {
    WorldData& data = edit(__func__);
    if (!data.is_valid(body)) refuse_dangling("body", link_, body.index, body.generation);
    std::vector<VelocitySums>& all = data.self.sums;
    const auto of_body = [&](const VelocitySums& sums) { return sums.body == body; };
    std::erase_if(all, [&](const VelocitySums& sums) { return !data.is_valid(sums.body); });
    if (std::any_of(all.begin(), all.end(), of_body)) return;
    const bool full = all.size() == most_accounts;
    if (full) all.erase(all.begin());
    all.push_back({.body = body});
    if (full)
        log(LogLevel::note,
            "World::keep_account: the account that began first ends, because a "
            "world keeps eight at most");
}

std::optional<VelocityAccount> World::account(BodyId body) const {
    const WorldData& data = *data_;
    const auto& all = data.self.sums;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const VelocitySums& sums) { return sums.body == body; });
    if (found == all.end() || found->step == 0 || found->step != data.steps ||
        found->solver_body == 0)
        return std::nullopt;
    const VelocitySums& sums = *found;
    const auto change_by = [&](Vec2 impulse) {
        return Vec2{sums.inverse_mass.x * impulse.x, sums.inverse_mass.y * impulse.y};
    };
    VelocityAccount account;
    account.earlier = sums.earlier;
    account.before = sums.before;
    account.after = sums.after;
    const float acted = 1.0f - sums.without_forces;
    account.gravity = acted * sums.gravity;
    account.force = acted * sums.force;
    account.applied = acted * sums.applied;
    account.fields = acted * sums.fields;
    account.damping = sums.damping;
    Vec2 rest =
        sums.after - sums.before -
        (account.gravity + account.force + account.applied + account.fields + account.damping);
    const VelocitySums::OfTurn& turn = sums.turn;
    account.turn = {.earlier = turn.earlier,
                    .before = turn.before,
                    .after = turn.after,
                    .torque = acted * turn.torque,
                    .applied = acted * turn.applied,
                    .fields = acted * turn.fields,
                    .damping = turn.damping,
                    .size = turn.inverse_inertia * turn.size};
    float turn_rest =
        turn.after - turn.before -
        (account.turn.torque + account.turn.applied + account.turn.fields + account.turn.damping);
    for (const VelocitySums::OfContact& sum : sums.contacts) {
        const Vec2 change = change_by(sum.impulse);
        const float turned = turn.inverse_inertia * sum.twist;
        rest = rest - change;
        turn_rest -= turned;
        account.contacts.push_back(
            {sum.own, sum.other, sum.body, sum.impulse, change, sum.twist, turned});
    }
    for (const VelocitySums::OfJoint& sum : sums.joints) {
        const Vec2 change = change_by(sum.impulse);
        const float turned = turn.inverse_inertia * sum.twist;
        rest = rest - change;
        turn_rest -= turned;
        account.joints.push_back({sum.joint, sum.impulse, change, sum.twist, turned});
    }
    account.rest = rest;
    account.turn.rest = turn_rest;
    return account;
}

}  // namespace fettle::physics
