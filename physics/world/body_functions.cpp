#include <state/limits.h>
#include <step/gather.h>
#include <world/ignored_numbers.h>
#include <world/world_data.h>

#include <cmath>

// The functions of the user that move single bodies. A velocity function is called once in a step,
// and not in each sub-step: sub-steps run on several threads, and the solver may repeat the sum of
// all changes of a sub-step in the next one. The change of velocity that the function makes is
// spread over the sub-steps like that of a force, so contacts carry the body as they carry a
// weight.

namespace fettle::physics {

using namespace detail;

namespace {

/// Checks the values that a function of the user has set for a body.
struct SetValues {
    const char* function;
    uint32_t body;
    IgnoredNumbers& ignored;

    /// The value within limits; for NaN, the value before.
    template <class Number>
    Number accepted(Number set, Number before, float most, const char* name) const {
        const bool given = ignored.accepts(set, name, [&] {
            return std::string(function) + ", for body " + std::to_string(body) + ",";
        });
        return given ? bounded(set, most) : before;
    }
};

/// The change in each sub-step that changes `from` to `to` in a whole step.
float share_of(float from, float to, int substeps) {
    return (to - from) / float(substeps);
}

}  // namespace

void WorldData::call_velocity_functions(float dt, int substeps) {
    IgnoredNumbers ignored;
    for (BodyFunctions& each : self.functions) {
        each.moves = is_valid(each.body) && bodies[each.body.index].solver_index != 0;
        if (!each.moves || !each.velocity) continue;
        const uint32_t slot = each.body.index;
        const bool kinematic = bodies[slot].mobility != Mobility::dynamic;
        SolverBody& b = solver_bodies[bodies[slot].solver_index];
        SolverForce& f = solver_forces[bodies[slot].solver_index];
        VelocityEdit edit = {{self.link->world, each.body},
                             dt,
                             b.velocity,
                             b.angular_velocity,
                             b.velocity,
                             b.angular_velocity};
        for (int i = 0; i < substeps; ++i) {
            edit.velocity = {(edit.velocity.x + f.change.x) * f.keep.x,
                             (edit.velocity.y + f.change.y) * f.keep.y};
            edit.angular_velocity = (edit.angular_velocity + f.turn_change) * f.turn_keep;
        }
        const VelocityEdit usual = edit;
        const bool answered = self.call_user(in_velocity, [&] { each.velocity(edit); });
        self.record_answer([&] {
            return Answer{key_of(each.body),
                          0,
                          Answer::To::velocity,
                          answered,
                          true,
                          false,
                          0,
                          {edit.velocity.x, edit.velocity.y, edit.angular_velocity}};
        });
        if (!answered) continue;
        const SetValues values = {in_velocity, slot, ignored};
        const Vec2 wanted = {
            values.accepted(edit.velocity.x, usual.velocity.x, greatest_speed, "velocity"),
            values.accepted(edit.velocity.y, usual.velocity.y, greatest_speed, "velocity")};
        const float turn = values.accepted(edit.angular_velocity, usual.angular_velocity, 1e6f,
                                           "angular_velocity");
        if (kinematic) {  // nothing else changes its velocity
            b.velocity = wanted;
            b.angular_velocity = turn;
            limit_velocity(bodies[slot], b);
            continue;
        }
        if (wanted != usual.velocity) {
            if (AttractedBody* const pulled = attractions.find(bodies[slot].solver_index))
                *pulled = {};  // the function has the last word
            f.change = {share_of(b.velocity.x, wanted.x, substeps),
                        share_of(b.velocity.y, wanted.y, substeps)};
            f.keep = {1.0f, 1.0f};
        }
        if (turn != usual.angular_velocity) {
            f.turn_change = share_of(b.angular_velocity, turn, substeps);
            f.turn_keep = 1.0f;
        }
    }
    ignored.report();
}

void WorldData::call_position_functions(float dt) {
    bool placed = false;
    IgnoredNumbers ignored;
    for (const BodyFunctions& each : self.functions) {
        if (!each.moves || !each.position || !is_valid(each.body)) continue;
        const uint32_t slot = each.body.index;
        const Pose before = previous[slot], usual = {states[slot].position, states[slot].angle};
        PositionEdit edit = {{self.link->world, each.body}, dt, before, usual};
        const bool answered = self.call_user(in_position, [&] { each.position(edit); });
        self.record_answer([&] {
            return Answer{key_of(each.body),
                          0,
                          Answer::To::position,
                          answered,
                          true,
                          false,
                          0,
                          {edit.pose.position.x, edit.pose.position.y, edit.pose.angle}};
        });
        if (!answered) continue;
        const SetValues values = {in_position, slot, ignored};
        const Position position = {values.accepted(edit.pose.position.x, usual.position.x,
                                                   greatest_coordinate, "position"),
                                   values.accepted(edit.pose.position.y, usual.position.y,
                                                   greatest_coordinate, "position")};
        const float angle =
            values.accepted(edit.pose.angle, usual.angle, greatest_coordinate, "angle");
        if (position == usual.position && angle == usual.angle) continue;
        teleport(activity(), slot, position, angle);
        previous[slot] = before;
        placed = true;
    }
    ignored.report();
    if (placed) refresh({});  // reads after a step find nothing out of date
}

}  // namespace fettle::physics
