#include <contacts/narrow_phase.h>
#include <geometry/trigonometry.h>
#include <sleep/rest.h>
#include <state/limits.h>
#include <state/place_shape.h>
#include <step/finish.h>

namespace fettle::physics::detail {
namespace {

/// Number of bodies in a task of a thread.
constexpr size_t bodies_of_piece = 64;

/// True if the shapes of the body turned in the step before.
bool turned_before(const ObjectState& objects, const BodyRecord& body) {
    for (uint32_t s = body.lists.first_shape; s != none; s = objects.shapes[s].next)
        if (objects.is_solid(s)) return objects.forms[s].turn != 0.0f;
    return false;
}

Vec2 limited_speed(Vec2 velocity, float most) {
    const Vec2 v = bounded(velocity, 2.0f * greatest_speed);
    if (!(length_squared(v) > most * most)) return v;
    return (most / length(v)) * v;
}

void finish_body(const FinishInput& in, size_t place, float dt, FinishedPiece& piece) {
    const uint32_t slot = in.active.awake_bodies[place];
    const WorldDef& settings = in.settings;
    BodyRecord& record = in.objects.bodies[slot];
    BodyState& state = in.columns.states[slot];
    const SolverBody& b = in.bodies.solver_bodies[place + 1];
    state.velocity = limited_speed(b.velocity, settings.max_speed);
    // A motor may exceed the limit in the last sub-step.
    const float turn_limit = dt > 0.0f ? greatest_turn * float(in.substeps) / dt : 1e6f;
    state.angular_velocity = bounded(b.angular_velocity, min(1e6f, turn_limit));
    record.step_load.force = {};
    record.step_load.torque = 0.0f;

    const Vec2 shift = shift_of(b);
    const float turn = turn_of(b);
    record.center = record.center + shift;
    record.center = {bounded(record.center.x, greatest_coordinate),
                     bounded(record.center.y, greatest_coordinate)};
    if (turn != 0.0f) {
        // The part of the rotation that the angle cannot represent is stored for the next step.
        const float sum = turn + record.angle_rest;
        const float angle = bounded(state.angle + sum, greatest_coordinate);
        record.angle_rest = sum - (angle - state.angle);
        state.angle = angle;
        const Rotation q = rotation_of(double(angle) + double(record.angle_rest));
        state.cosine = q.c;
        state.sine = q.s;
    }
    const Rotation q = {state.cosine, state.sine};
    state.position = bounded(record.center - rotate(q, record.local_center), greatest_coordinate);
    // A platform may stand still for long and have many shapes. They are updated in the first step
    // of rest, so that their turn becomes 0.
    const bool stands =
        record.mobility != Mobility::dynamic && shift.x == 0.0f && shift.y == 0.0f && turn == 0.0f;
    if (!stands || turned_before(in.objects, record)) finish_shapes(in, slot, q, piece);
    const float near = record.mobility == Mobility::kinematic ? least_driven_motion(record)
                                                              : least_hit_motion(record);
    if (settings.continuous && way_of(record, shift, turn) > near) {
        stop_or_list(in, slot, shift, turn, piece);
    }

    const float turning = state.angular_velocity * record.extent;
    float speed = max(length(state.velocity), std::fabs(turning));
    // Joints close a gap without a velocity: a body that they draw is not at rest.
    if (record.lists.first_joint != none && dt > 0.0f)
        speed = max(speed, max(length(shift), std::fabs(turn) * record.extent) / dt);
    count_rest(in.objects.sleep_speed_of(settings, record), settings.sleep_delay, record,
               in.objects.rest_poses[slot], state, speed, dt);
    piece.sleep_candidates += record.sleep_time >= settings.sleep_delay;
}

/// Updates the nodes above the leaves that were placed.
void follow_all_placed(const FinishInput& in) {
    const std::vector<FinishedPiece>& finished = in.scratch.finished;
    Tree& moving_tree = in.boxes.moving_tree;
    size_t placed = 0;
    for (const FinishedPiece& piece : finished) placed += piece.placed.size();
    in.statistics.moved_proxies += uint32_t(placed);
    if (!moving_tree.are_few(placed)) {
        moving_tree.refit(in.threads, in.boxes.paired_boxes);
        return;
    }
    for (const FinishedPiece& piece : finished)
        for (const int32_t leaf : piece.placed) moving_tree.enlarge_above(leaf);
}

}  // namespace

void finish_shapes(const FinishInput& in, uint32_t body, Rotation q, FinishedPiece& piece) {
    ObjectState& objects = in.objects;
    std::vector<ShapeRecord>& shapes = objects.shapes;
    std::vector<Box4>&boxes = in.boxes.boxes, &fat_boxes = in.boxes.fat_boxes;
    for (uint32_t s = objects.bodies[body].lists.first_shape; s != none; s = shapes[s].next) {
        if (!objects.is_solid(s)) continue;
        move_shape(objects, boxes, s, q, in.columns.states[body].angle);
        if (!shapes[s].crowded && contains(fat_boxes[s], grow(boxes[s], speculative_margin)))
            continue;
        fat_boxes[s] = grow(boxes[s], fat_margin(boxes[s]));
        in.boxes.moving_tree.place(shapes[s].proxy, fat_boxes[s]);
        piece.placed.push_back(shapes[s].proxy);
        if (shapes[s].moved) continue;
        shapes[s].moved = true;
        piece.moved.push_back(s);
    }
}

void follow_placed(const FinishInput& in, const FinishedPiece& piece) {
    for (const int32_t leaf : piece.placed) in.boxes.moving_tree.enlarge_above(leaf);
    std::vector<uint32_t>& moved = in.boxes.moved_shapes;
    moved.insert(moved.end(), piece.moved.begin(), piece.moved.end());
    in.statistics.moved_proxies += uint32_t(piece.placed.size());
}

uint32_t finish_bodies(const FinishInput& in, float dt) {
    const std::vector<uint32_t>& awake = in.active.awake_bodies;
    std::vector<FinishedPiece>& finished = in.scratch.finished;
    const size_t count = awake.size();
    finished.resize((count + bodies_of_piece - 1) / bodies_of_piece);
    // A fast body looks up its pairs, because their contacts may not act.
    if (in.skips) end_pairs(in.list, in.pairs);
    if (in.settings.continuous) list_driven_bodies(in);
    parallel_for(in.threads, uint32_t(1 + finished.size()), [&](uint32_t block) {
        if (block == 0) {
            end_pairs(in.list, in.pairs);
            return;
        }
        FinishedPiece& piece = finished[block - 1];
        piece.clear();
        const size_t end = std::min(block * bodies_of_piece, count);
        for (size_t place = (block - 1) * bodies_of_piece; place < end; ++place) {
            if (place + bodies_ahead < end)
                in.objects.bodies[awake[place + bodies_ahead]].prefetch();
            finish_body(in, place, dt, piece);
        }
    });
    uint32_t sleep_candidates = 0;
    std::vector<uint32_t>& moved_shapes = in.boxes.moved_shapes;
    std::vector<FastBody>& fast_bodies = in.scratch.fast_bodies;
    fast_bodies.clear();
    for (const FinishedPiece& piece : finished) {
        moved_shapes.insert(moved_shapes.end(), piece.moved.begin(), piece.moved.end());
        fast_bodies.insert(fast_bodies.end(), piece.fast.begin(), piece.fast.end());
        sleep_candidates += piece.sleep_candidates;
    }
    follow_all_placed(in);
    stop_fast_bodies(in);
    return sleep_candidates;
}

}  // namespace fettle::physics::detail
