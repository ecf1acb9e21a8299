#include <checks/hooks.h>
#include <state/limits.h>
#include <step/gather.h>
#include <world/live.h>

#include <algorithm>
#include <cmath>

// The functions of the user that move single bodies. A velocity function is called once in a step,
// and not in each sub-step: sub-steps run on several threads, and the solver may repeat the sum of
// all changes of a sub-step in the next one. The change of velocity that the function wants is
// spread over the sub-steps like that of a force, so contacts carry the body as they carry a
// weight.

namespace fettle::physics {

using namespace detail;

namespace {

/// The functions of a body, to be set; a body without any gets an entry in the order of the slots.
BodyFunctions& functions_of(WorldSelf& self, BodyId body) {
    auto& all = self.functions;
    const auto place = std::lower_bound(
        all.begin(), all.end(), body.index,
        [](const BodyFunctions& each, uint32_t slot) { return each.body.index < slot; });
    if (place == all.end() || place->body.index != body.index)
        return *all.insert(place, BodyFunctions{.body = body});
    if (place->body != body) *place = BodyFunctions{.body = body};  // of a destroyed body
    return *place;
}

/// `function` goes to the entry of the body; an entry without functions is removed. The old
/// function is destroyed last, because its destructor may use the world.
template <class Function>
void set_function(WorldData& data, BodyId body, Function BodyFunctions::*which,
                  Function& function) {
    auto& all = data.self.functions;
    BodyFunctions& own = functions_of(data.self, body);
    std::swap(own.*which, function);
    if (!own.velocity && !own.position) all.erase(all.begin() + (&own - all.data()));
    data.change<wake_body>(body.index);
}

/// The value that a function of the user has set, within limits; NaN: what was there.
template <class Number>
Number taken(Number set, Number before, float most) {
    if (!std::isnan(set)) return bounded(set, most);
    log(LogLevel::warning, "a function that moves a body set NaN, which changes nothing");
    return before;
}

/// The change of one sub-step that takes `from` to `to` in all.
float share_of(float from, float to, int substeps) {
    return (to - from) / float(substeps);
}

}  // namespace

void WorldData::ask_velocity_functions(float dt, int substeps) {
    for (BodyFunctions& each : self.functions) {
        each.moves = is_valid(each.body) && bodies[each.body.index].solver_index != 0;
        if (!each.moves || !each.velocity) continue;
        const uint32_t slot = each.body.index;
        const bool commanded = bodies[slot].mobility != Mobility::dynamic;
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
        const bool answered = self.ask(in_velocity, [&] { each.velocity(edit); });
        self.tell([&] {
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
        const Vec2 wanted = {taken(edit.velocity.x, usual.velocity.x, greatest_speed),
                             taken(edit.velocity.y, usual.velocity.y, greatest_speed)};
        const float turn = taken(edit.angular_velocity, usual.angular_velocity, 1e6f);
        if (commanded) {  // nothing else changes its velocity
            b.velocity = wanted;
            b.angular_velocity = turn;
            limit_commanded(*this, bodies[slot], b);
            continue;
        }
        if (wanted != usual.velocity) {
            f.change = {share_of(b.velocity.x, wanted.x, substeps),
                        share_of(b.velocity.y, wanted.y, substeps)};
            f.keep = {1.0f, 1.0f};
        }
        if (turn != usual.angular_velocity) {
            f.turn_change = share_of(b.angular_velocity, turn, substeps);
            f.turn_keep = 1.0f;
        }
    }
}

void WorldData::ask_position_functions(float dt) {
    bool placed = false;
    for (const BodyFunctions& each : self.functions) {
        if (!each.moves || !each.position || !is_valid(each.body)) continue;
        const uint32_t slot = each.body.index;
        const Pose before = previous[slot], usual = {states[slot].position, states[slot].angle};
        PositionEdit edit = {{self.link->world, each.body}, dt, before, usual};
        const bool answered = self.ask(in_position, [&] { each.position(edit); });
        self.tell([&] {
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
        const Position position = {
            taken(edit.pose.position.x, usual.position.x, greatest_coordinate),
            taken(edit.pose.position.y, usual.position.y, greatest_coordinate)};
        const float angle = taken(edit.pose.angle, usual.angle, greatest_coordinate);
        if (position == usual.position && angle == usual.angle) continue;
        teleport(*this, slot, position, angle);
        previous[slot] = before;
        placed = true;
    }
    if (placed) refresh({});  // reads after a step find nothing out of date
}

void Body::set_velocity_function(VelocityFunction function) {
    FETTLE_EDIT_BODY
    set_function(data, id_, &BodyFunctions::velocity, function);
}

void Body::set_position_function(PositionFunction function) {
    FETTLE_EDIT_BODY
    set_function(data, id_, &BodyFunctions::position, function);
}

}  // namespace fettle::physics
