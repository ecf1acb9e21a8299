#include <geometry/trigonometry.h>
#include <state/joint_kind.h>
#include <step/time_of_impact.h>

#include <algorithm>

// Bodies with joints that continuous collision stops. If such a body were put back alone, its
// partners would still move through the rest of the step, and the joints would be torn apart by
// that distance. So each partner is put back to the last moment at which the joint between them is
// hardly wider than without the impact, and so on from partner to partner. Each may be a little
// ahead of the one before, so an impact on the end of a long chain does not stop all of it. A body
// is put back only along its own path, where nothing stopped it: so it passes through nothing.

namespace fettle::physics::detail {
namespace {

/// By how much an impact may widen a joint: m, or as a part of the thickness of the thinner body,
/// whichever is less; at high speeds, as a part of the distance that the partner moves in the step.
/// There the solver leaves wider gaps anyway, and fewer bodies of a chain are put back.
constexpr float usual_widening = 0.5f * speculative_margin;
constexpr float widening_of_thickness = 0.5f;
constexpr float widening_of_distance = 0.05f;

/// The last moment is searched in equal parts of the time, and then by bisection.
constexpr int parts_of_time = 8;
constexpr int bisections = 5;
/// A body is put back only if its motion ends earlier by at least this part of the step.
constexpr float least_time = 1.0f / 64.0f;

class JoinedBodies {
  public:
    explicit JoinedBodies(const FinishInput& in) : in_(in), place_of_(in.scratch.mover_of) {
        place_of_.resize(in.objects.bodies.size(), none);
        const std::vector<FastBody>& fast = in.scratch.fast_bodies;
        for (size_t i = 0; i < fast.size(); ++i) {
            place_of_[fast[i].body] = uint32_t(i);
            before_.push_back(fast[i].motion.until);
            if (fast[i].joined) waiting_.push_back({fast[i].motion.until, fast[i].body});
        }
        std::make_heap(waiting_.begin(), waiting_.end());
    }
    ~JoinedBodies() {
        for (const FastBody& fast : in_.scratch.fast_bodies) place_of_[fast.body] = none;
    }
    JoinedBodies(const JoinedBodies&) = delete;
    JoinedBodies& operator=(const JoinedBodies&) = delete;

    void run() {
        while (!waiting_.empty()) {
            std::pop_heap(waiting_.begin(), waiting_.end());
            const Waiting next = waiting_.back();
            waiting_.pop_back();
            if (next.time <= fast_at(next.body).motion.until) put_back_partners(next.body);
        }
        place_changed_bodies();
    }

  private:
    struct Waiting {
        float time;
        uint32_t body;
        /// The earliest one is first in a heap.
        bool operator<(const Waiting& other) const {
            return time != other.time ? time > other.time : body > other.body;
        }
    };

    const BodyRecord& record(uint32_t body) const { return in_.objects.bodies[body]; }
    FastBody& fast_at(uint32_t body) { return in_.scratch.fast_bodies[place_of_[body]]; }

    /// The motion of the body as if nothing had stopped it.
    Motion whole_motion(uint32_t body) const {
        const uint32_t index = record(body).solver_index;
        if (record(body).mobility == Mobility::fixed || index == 0)
            return at_rest(record(body).center);
        const SolverBody& b = in_.bodies.solver_bodies[index];
        Motion motion = motion_to(record(body).center, shift_of(b), turn_of(b));
        if (place_of_[body] != none) {
            const Motion& stopped = in_.scratch.fast_bodies[place_of_[body]].motion;
            motion.from = stopped.from;
            motion.angle = stopped.angle;
        }
        return motion;
    }
    Motion motion_of(uint32_t body) const {
        return place_of_[body] != none ? in_.scratch.fast_bodies[place_of_[body]].motion
                                       : whole_motion(body);
    }

    /// The rotation of a body at a moment, and its anchor.
    struct End {
        Rotation q;
        Position anchor;
    };
    End end_at(uint32_t body, const Position& local, const Motion& motion, float time) const {
        if (body == 0) return {{}, local};
        const BodyState& state = in_.columns.states[body];
        const Rotation moved = rotation_of(motion.rotation(time)), now = {state.cosine, state.sine};
        const Rotation q = {moved.c * now.c - moved.s * now.s, moved.s * now.c + moved.c * now.s};
        return {q, motion.center(time) + rotate(q, Vec2(local) - record(body).local_center)};
    }
    static JointPlace place_between(const JointRecord& joint, const End& a, const End& b) {
        return {a.anchor, b.anchor, a.q, joint.anchors[0]};
    }

    void put_back_partners(uint32_t body) {
        for (uint32_t edge = record(body).lists.first_joint; edge != none;) {
            const JointRecord& joint = in_.objects.joints[edge >> 1];
            const uint32_t side = edge & 1, partner = joint.bodies[1 - side];
            edge = joint.edges[side].next;
            if (!joint.moves() || joint_kind(joint.type).separation == nullptr) continue;
            if (record(partner).mobility != Mobility::dynamic) continue;
            const float time = last_close_time(joint, side);
            if (time < motion_of(partner).until - least_time) put_back(partner, time);
        }
    }

    /// The last moment at which the joint is hardly wider than without the impact, if its body of
    /// `side` is stopped.
    float last_close_time(const JointRecord& joint, uint32_t side) const {
        const uint32_t body = joint.bodies[side], partner = joint.bodies[1 - side];
        const Motion stopped = motion_of(body), moving = motion_of(partner);
        const auto separation = [&](const End& of_body, const End& of_partner) {
            return joint_kind(joint.type)
                .separation(joint, side == 0 ? place_between(joint, of_body, of_partner)
                                             : place_between(joint, of_partner, of_body));
        };
        const auto both_at = [&](float time) {
            return separation(
                end_at(body, joint.anchors[side], whole_motion(body), time),
                end_at(partner, joint.anchors[1 - side], whole_motion(partner), time));
        };
        const End end = end_at(body, joint.anchors[side], stopped, 1.0f);
        const auto gap_at = [&](float time) {
            return separation(end, end_at(partner, joint.anchors[1 - side], moving, time));
        };
        const float thickness = min(record(body).thickness, record(partner).thickness);
        const float widening = max(min(usual_widening, widening_of_thickness * thickness),
                                   widening_of_distance * length(whole_motion(partner).velocity));
        const float allowed = max(both_at(0.0f), both_at(1.0f)) + widening;
        return last_moment(gap_at, allowed, moving.until);
    }

    /// The last moment until `end` at which the gap is at most `allowed`; else that of the smallest
    /// gap.
    static float last_moment(auto&& gap_at, float allowed, float end) {
        float narrowest = 1e30f, best = end;
        for (int part = parts_of_time; part >= 0; --part) {
            const float time = end * float(part) / float(parts_of_time), gap = gap_at(time);
            if (gap <= allowed) {
                if (part == parts_of_time) return end;
                float low = time, high = end * float(part + 1) / float(parts_of_time);
                for (int i = 0; i < bisections; ++i) {
                    const float middle = 0.5f * (low + high);
                    (gap_at(middle) <= allowed ? low : high) = middle;
                }
                return low;
            }
            if (gap < narrowest) narrowest = gap, best = time;
        }
        return best;
    }

    void put_back(uint32_t body, float time) {
        if (place_of_[body] == none) {
            FastBody fast;
            fast.body = body;
            fast.motion = whole_motion(body);
            fast.meets_moving = in_.objects.bullets > 0 || in_.objects.kinematic_bodies > 0;
            place_of_[body] = uint32_t(in_.scratch.fast_bodies.size());
            in_.scratch.fast_bodies.push_back(fast);
            before_.push_back(1.0f);
        }
        fast_at(body).motion.until = time;
        waiting_.push_back({time, body});
        std::push_heap(waiting_.begin(), waiting_.end());
    }

    void place_changed_bodies() {
        FinishedPiece& piece = in_.scratch.finished.front();
        for (size_t i = 0; i < before_.size(); ++i) {
            FastBody& fast = in_.scratch.fast_bodies[i];
            if (fast.motion.until == before_[i]) continue;
            undo_forces(in_, fast.body, before_[i] - fast.motion.until);
            piece.clear();
            follow_motion(in_, fast.body, fast.motion, piece);
            follow_placed(in_, piece);
            fast.motion.angle = -fast.motion.until * fast.motion.turn;
        }
    }

    const FinishInput& in_;
    std::vector<uint32_t>& place_of_;  ///< by body: its place in the list of fast bodies
    std::vector<float> before_;        ///< of the fast bodies: the end of their motion before
    std::vector<Waiting> waiting_;     ///< bodies whose partners may have to be put back: a heap
};

}  // namespace

void put_back_joined(const FinishInput& in) {
    const auto joined = [](const FastBody& body) { return body.joined; };
    const std::vector<FastBody>& fast = in.scratch.fast_bodies;
    if (std::any_of(fast.begin(), fast.end(), joined)) JoinedBodies(in).run();
}

}  // namespace fettle::physics::detail
