#include <fettle/physics_c/account.h>

#include <calls/calls.h>

// Accounts of velocities.

namespace fettle::physics_c {

using namespace physics;

namespace {

fettle_turn_account turn_in_c(const TurnAccount& turn) {
    return {turn.earlier, turn.before,  turn.after, turn.torque, turn.applied,
            turn.fields,  turn.damping, turn.rest,  turn.size};
}

fettle_velocity_account account_in_c(const VelocityAccount& account) {
    return {converted(account.earlier), converted(account.before),  converted(account.after),
            converted(account.gravity), converted(account.force),   converted(account.applied),
            converted(account.fields),  converted(account.damping), converted(account.rest),
            turn_in_c(account.turn)};
}

std::optional<VelocityAccount> account_of(const fettle_world* world, fettle_id body) {
    return live(world).account(handle<Body>(world, body).id());
}

}  // namespace

fettle_contact_share converted(const ContactShare& share) {
    return {converted(share.own),
            converted(share.other),
            converted(share.body),
            converted(share.impulse),
            converted(share.change),
            share.twist,
            share.turn};
}

fettle_joint_share converted(const JointShare& share) {
    return {converted(share.joint), converted(share.impulse), converted(share.change), share.twist,
            share.turn};
}

}  // namespace fettle::physics_c

using namespace fettle::physics;
using namespace fettle::physics_c;

fettle_code fettle_world_keep_account(fettle_world* world, fettle_id body) {
    return guarded(__func__, [&] { editable(world).keep_account(handle<Body>(world, body).id()); });
}

fettle_code fettle_world_account(const fettle_world* world, fettle_id body, bool* is_set,
                                 fettle_velocity_account* account) {
    return guarded(__func__, [&] {
        bool& set = needed("is_set", is_set);
        fettle_velocity_account& result = needed("the result", account);
        const auto found = account_of(world, body);
        set = found.has_value();
        result = found ? account_in_c(*found) : fettle_velocity_account{};
    });
}

fettle_code fettle_world_account_contacts(const fettle_world* world, fettle_id body,
                                          fettle_contact_share* out, uint32_t room,
                                          uint32_t* count) {
    return guarded(__func__, [&] {
        const auto found = account_of(world, body);
        write_list(found ? found->contacts : std::vector<ContactShare>(), out, room, count);
    });
}

fettle_code fettle_world_account_joints(const fettle_world* world, fettle_id body,
                                        fettle_joint_share* out, uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        const auto found = account_of(world, body);
        write_list(found ? found->joints : std::vector<JointShare>(), out, room, count);
    });
}
