#include <contacts/narrow_phase.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

// After the solver: poses, rotated vertices, boxes. What a body needs besides goes into the lists
// of its piece; piece after piece, whoever did them, they are then taken over.

namespace fettle::physics::detail {
namespace {

/// Bodies that a thread takes at a time.
constexpr size_t piece_length = 64;

}  // namespace

void WorldData::finish_body(size_t place, float dt, FinishedPiece& piece) {
    const uint32_t slot = awake_bodies[place];
    BodyRecord& record = bodies[slot];
    BodyState& state = states[slot];
    const SolverBody& b = solver_bodies[place + 1];
    const float speed_limit = 1.5f * greatest_speed;
    state.velocity = {bounded(b.velocity.x, speed_limit), bounded(b.velocity.y, speed_limit)};
    state.angular_velocity = bounded(b.angular_velocity, 1e6f);
    record.step_force = {};
    record.step_torque = 0.0f;

    V2 shift = {bounded(b.shift.x, 1e6f), bounded(b.shift.y, 1e6f)};
    const float turn = bounded(b.turn, 1e3f);
    record.center = record.center + shift;
    record.center = {bounded(record.center.x, greatest_coordinate),
                     bounded(record.center.y, greatest_coordinate)};
    if (turn != 0.0f) {
        // The part of the turn that the angle is too coarse to hold is kept for the next step.
        const float sum = turn + record.angle_rest;
        const float angle = bounded(state.angle + sum, greatest_coordinate);
        record.angle_rest = sum - (angle - state.angle);
        state.angle = angle;
        const Rotation q = rotation_of(double(angle) + double(record.angle_rest));
        state.cosine = q.c;
        state.sine = q.s;
    }
    const Rotation q = {state.cosine, state.sine};
    state.position =
        to_vec2(bounded(record.center - rotate(q, record.local_center), greatest_coordinate));
    finish_shapes(slot, q, piece);
    // Slower ones cannot pass the reach of a speculative contact, or leave more than half of
    // them behind.
    const float near = max(0.5f * record.thickness, speculative_margin);
    if (settings.continuous && record.mobility == Mobility::dynamic &&
        length_squared(shift) > near * near) {
        stop_or_list({slot, record.center - shift, shift, turn}, piece);
    }

    const float speed =
        max(length(to_v2(state.velocity)), std::fabs(state.angular_velocity) * record.extent);
    record.sleep_time = speed < settings.sleep_speed ? record.sleep_time + dt : 0.0f;
    piece.sleep_candidates += record.sleep_time >= settings.sleep_delay;
}

void WorldData::finish_bodies(float dt) {
    const size_t count = awake_bodies.size();
    finished.resize((count + piece_length - 1) / piece_length);
    // Where a callback may have disabled a contact, who is stopped asks for it by its pair.
    if (self.see_contacts()) end_pairs(contact_list(), *this);
    share_out(threads, uint32_t(1 + finished.size()), [&](uint32_t block) {
        if (block == 0) {
            end_pairs(contact_list(), *this);
            return;
        }
        FinishedPiece& piece = finished[block - 1];
        piece.clear();
        const size_t end = std::min(block * piece_length, count);
        for (size_t place = (block - 1) * piece_length; place < end; ++place) {
            if (place + bodies_ahead < end) bodies[awake_bodies[place + bodies_ahead]].prefetch();
            finish_body(place, dt, piece);
        }
    });
    sleep_candidates = 0;
    fast_bodies.clear();
    for (const FinishedPiece& piece : finished) {
        moved_shapes.insert(moved_shapes.end(), piece.moved.begin(), piece.moved.end());
        fast_bodies.insert(fast_bodies.end(), piece.fast.begin(), piece.fast.end());
        sleep_candidates += piece.sleep_candidates;
    }
    follow_placed();
}

/// The tree after the leaves that were placed in it.
void WorldData::follow_placed() {
    size_t placed = 0;
    for (const FinishedPiece& piece : finished) placed += piece.placed.size();
    statistics.moved_proxies += uint32_t(placed);
    if (!moving_tree.are_few(placed)) {
        moving_tree.refit(threads, paired_boxes);
        return;
    }
    for (const FinishedPiece& piece : finished)
        for (const int32_t leaf : piece.placed) moving_tree.follow(leaf);
}

/// Lists those that have left their fat boxes and have others now.
void WorldData::finish_shapes(uint32_t body, Rotation q, FinishedPiece& piece) {
    for (uint32_t s = bodies[body].first_shape; s != none; s = shapes[s].next) {
        if (!is_solid(s)) continue;
        place_shape(s, q);
        if (contains(fat_boxes[s], grow(boxes[s], speculative_margin))) continue;
        fat_boxes[s] = grow(boxes[s], fat_margin(s));
        moving_tree.place(shapes[s].proxy, fat_boxes[s]);
        piece.placed.push_back(shapes[s].proxy);
        if (shapes[s].moved) continue;
        shapes[s].moved = true;
        piece.moved.push_back(s);
    }
}

}  // namespace fettle::physics::detail
