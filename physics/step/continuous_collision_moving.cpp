#include <geometry/trigonometry.h>
#include <step/obstacle.h>

#include <algorithm>

// Impacts of moving bodies with each other: of bullets with all bodies, and of kinematic bodies
// with dynamic bodies. The impacts are processed in the order of time. Each changes the motions of
// two bodies for the rest of the step; then the impacts of these bodies are computed again. An
// impact of dynamic bodies changes no velocity, except that it undoes the forces of the time that
// it removes: the next step finds contacts. A kinematic body may stand still then, so what it hits
// gets its velocity at once (kinematic_hits.cpp). Only where the centroid of a body is at a dynamic
// obstacle already, an impulse stops their approach, because the contact of a thin body that turns
// fast cannot.
// - Two dynamic bodies stop. One that is neither fast nor a bullet goes on, and the other one keeps
//   its place beside it.
// - A kinematic body (`driven`) does not stop. It carries the other body along, and the bodies that
//   this one meets. A fixed obstacle stops a carried body: then the kinematic body passes through
//   it.

namespace fettle::physics::detail {
namespace {

/// A body may be at two others at once. A body that slides more often is between two others, and
/// stops.
constexpr int most_slides = 2;

/// A way that ends no deeper than this below the surface along which the body slides is kept, m.
constexpr float end_gap = 0.0002f;

struct Mover {
    uint32_t body = none;
    Motion motion;
    Motion whole;           ///< without the impacts
    Box4 box;               ///< around all shapes, on the way that is left
    uint32_t place = none;  ///< in the list of fast bodies
    uint32_t version = 0;
    uint32_t carrier = none;  ///< the body that carries it along
    uint32_t hit_by = none;   ///< the kinematic body that reached it within the step
    Vec2 away;                ///< from a dynamic carrier, when it met it
    int slides = 0;           ///< how often it slid along another body
    bool driven = false;
    bool slow = false;     ///< a driven body that meets only what is fast seen from it
    bool stops = false;    ///< at other dynamic bodies
    bool blocked = false;  ///< by a fixed obstacle
    bool changed = false;
};

struct Meeting {
    float time;
    uint32_t a, b;  ///< bodies
    uint32_t version_a, version_b;
    uint32_t shape_a, shape_b;
    /// The body with its centroid at the other one already, and the displacement in the rest of the
    /// step that keeps it from going farther.
    uint32_t slides = none;
    Vec2 back = {};
    /// From the kinematic body to the other one; else zero.
    Vec2 normal = {};

    /// The earliest one is first in a heap.
    bool operator<(const Meeting& other) const {
        if (time != other.time) return time > other.time;
        return a != other.a ? a > other.a : b > other.b;
    }
};

class MovingImpacts {
  public:
    explicit MovingImpacts(const FinishInput& in) : in_(in), mover_of_(in.scratch.mover_of) {
        mover_of_.resize(in.objects.bodies.size(), none);
    }
    ~MovingImpacts() {
        for (const Mover& mover : movers_) mover_of_[mover.body] = none;
    }
    MovingImpacts(const MovingImpacts&) = delete;
    MovingImpacts& operator=(const MovingImpacts&) = delete;

    void run() {
        const std::vector<FastBody>& fast = in_.scratch.fast_bodies;
        for (size_t i = 0; i < fast.size(); ++i) {
            if (!fast[i].meets_moving) continue;
            Mover& mover = add(fast[i].body, fast[i].motion);
            mover.place = uint32_t(i);
            mover.stops = !mover.driven;
        }
        const size_t count = movers_.size();
        for (size_t i = 0; i < count; ++i) find_meetings(i, 0.0f, true);
        while (!queue_.empty()) {
            std::pop_heap(queue_.begin(), queue_.end());
            const Meeting next = queue_.back();
            queue_.pop_back();
            if (next.version_a == version_of(next.a) && next.version_b == version_of(next.b))
                meet(mover(next.a), mover(next.b), next);
        }
        place_changed_bodies();
        // What reaches a kinematic body at rest is pushed in the next step, as by a fixed one, when
        // all shapes that lie flush beside each other are known.
        for (const Mover& mover : movers_)
            if (mover.hit_by != none && mover.hit_by == mover.carrier && !mover.blocked &&
                in_motion(in_.objects, in_.columns, mover.hit_by))
                hit_by_kinematic(in_, mover.hit_by, mover.body);
    }

  private:
    const BodyRecord& record(uint32_t body) const { return in_.objects.bodies[body]; }
    uint32_t version_of(uint32_t body) const {
        return mover_of_[body] == none ? 0 : movers_[mover_of_[body]].version;
    }
    Motion motion_of(uint32_t body) const {
        if (mover_of_[body] != none) return movers_[mover_of_[body]].motion;
        const uint32_t index = record(body).solver_index;
        if (index == 0 || index >= in_.bodies.solver_bodies.size())
            return at_rest(record(body).center);
        const SolverBody& b = in_.bodies.solver_bodies[index];
        return motion_to(record(body).center, shift_of(b), turn_of(b));
    }
    Mover& add(uint32_t body, const Motion& motion) {
        mover_of_[body] = uint32_t(movers_.size());
        Mover& mover = movers_.emplace_back();
        mover.body = body;
        mover.motion = mover.whole = motion;
        mover.stops = record(body).flags.bullet;
        mover.driven = record(body).mobility == Mobility::kinematic;
        mover.slow = mover.driven && !(way_of(record(body), motion) > near_motion(record(body)));
        mover.box = swept_boxes(mover, 0.0f);
        return mover;
    }
    size_t mover(uint32_t body) {
        if (mover_of_[body] == none) add(body, motion_of(body));
        return mover_of_[body];
    }
    Box4 swept_boxes(const Mover& mover, float now) const {
        Box4 all = no_box;
        for_each_pushing(in_.objects, mover.body, [&](uint32_t s) {
            all = unite(all, swept_box(in_, s, mover.motion, now));
        });
        return all;
    }

    /// True if a body without a contact with the slow driven body may reach it in this step.
    bool may_reach(uint32_t body, const Mover& driven) const {
        Motion seen = motion_of(body);
        const Vec2 apart = seen.center(1.0f) - driven.motion.center(1.0f);
        seen.velocity = seen.velocity - driven.motion.velocity - cross(driven.motion.turn, apart);
        seen.turn -= driven.motion.turn;
        return way_of(record(body), seen) > least_hit_motion(record(body));
    }
    /// True if the motions of the two bodies are compared.
    bool are_compared(const Mover& mover, uint32_t other) const {
        if (other == mover.body) return false;
        const BodyRecord &a = record(mover.body), &b = record(other);
        if (a.mobility == Mobility::kinematic || b.mobility == Mobility::kinematic)
            return a.mobility != b.mobility;
        const uint32_t index = mover_of_[other];
        return a.flags.bullet || b.flags.bullet || mover.carrier != none ||
               (index != none && movers_[index].carrier != none);
    }

    /// Finds the bodies that the body meets from `now` on. `first`: this is called for all bodies
    /// in turn.
    void find_meetings(size_t i, float now, bool first) {
        const Mover mover = movers_[i];
        // At first, fast bullets find the fast bodies that are not bullets, and such a body finds
        // only slow bullets. When its motion has changed, all bodies are compared with it again.
        const bool searches =
            mover.driven || record(mover.body).flags.bullet || mover.carrier != none;
        if (!searches && in_.objects.kinematic_bodies == 0 && in_.objects.bullets == 0) return;
        for_each_pushing(in_.objects, mover.body, [&](uint32_t s) {
            in_.boxes.moving_tree.query(swept_box(in_, s, mover.motion, now), [&](uint32_t other) {
                const uint32_t body = in_.objects.forms[other].body;
                if (mover_of_[body] == none && are_compared(mover, body) &&
                    (!mover.slow || may_reach(body, mover)))
                    compare(mover, s, other, now);
            });
        });
        if (!searches && first) return;
        for (size_t k = 0; k < movers_.size(); ++k) {
            const Mover& other = movers_[k];
            // Of two bodies that search for each other, the first one finds the second one.
            if (first && k < i && (other.driven || record(other.body).flags.bullet)) continue;
            if (!overlap(mover.box, other.box) || !are_compared(mover, other.body)) continue;
            if (mover.slow && first && !may_reach(other.body, mover)) continue;
            for_each_pushing(in_.objects, mover.body, [&](uint32_t s) {
                for_each_pushing(in_.objects, other.body, [&](uint32_t o) {
                    if (overlap(swept_box(in_, s, mover.motion, now),
                                swept_box(in_, o, other.motion, now)))
                        compare(mover, s, o, now);
                });
            });
        }
    }

    void compare(const Mover& mover, uint32_t shape, uint32_t other, float now) {
        const uint32_t body = in_.objects.forms[other].body;
        if (!may_meet(in_, shape, other)) return;
        const Motion motion = motion_of(body);
        // A driven body does not stop: the core of the body that it carries along counts. Of two
        // other bodies, neither may reach the core of the other.
        const Impact of_other = time_of_impact(in_, other, motion, shape, mover.motion, now);
        Impact of_this;
        if (!mover.driven) of_this = time_of_impact(in_, shape, mover.motion, other, motion, now);
        const float time = min(of_other.time, of_this.time);
        if (time >= 1.0f) return;
        Meeting meeting = {time, mover.body, body, mover.version, version_of(body), shape, other};
        const bool this_one = of_this.time <= of_other.time;
        const Vec2 back = this_one ? of_this.back : of_other.back;
        if (length_squared(back) > 0.0f) {
            meeting.slides = this_one ? mover.body : body;
            const Motion& obstacle = this_one ? motion : mover.motion;
            meeting.back = rotate(rotation_of(obstacle.rotation(1.0f)), back);
        }
        meeting.normal = this_one ? of_this.normal : of_other.normal;
        if (this_one == mover.driven) meeting.normal = -meeting.normal;
        queue_.push_back(meeting);
        std::push_heap(queue_.begin(), queue_.end());
    }

    void meet(size_t i, size_t k, const Meeting& meeting) {
        const float now = meeting.time;
        const auto rank = [&](size_t m) {
            return movers_[m].driven ? 2 : is_driven_along(m) ? 1 : 0;
        };
        if (rank(k) > rank(i)) std::swap(i, k);
        const Mover first = movers_[i], second = movers_[k];
        if (rank(i) == 0 || first.blocked) {
            if (meeting.slides != none && slide(meeting)) return;
            for (const auto& [stopped, other] : {std::pair(i, k), std::pair(k, i)}) {
                if (!movers_[stopped].stops) continue;
                if (movers_[other].stops || movers_[stopped].carrier != none) {
                    stop(stopped, now, false);
                } else {
                    movers_[stopped].away = away_from(movers_[other].body, meeting);
                    carry(stopped, movers_[other].body, now);
                }
            }
            return;
        }
        const uint32_t carrier = first.driven ? first.body : first.carrier;
        if (first.driven) ++movers_[k].slides;
        if (second.blocked) {
            if (!first.driven) stop(i, now, true);
        } else if (rank(k) == 0) {
            if (first.driven && meeting.normal == Vec2{}) hit(k, carrier, now);
            carry(k, carrier, now, first.driven ? meeting.normal : Vec2{});
        } else if (second.carrier != carrier) {
            stop(k, now, true);  // it is between two driven bodies
        } else if (first.driven && second.slides <= most_slides) {
            carry(k, carrier, now, meeting.normal);  // it slid to another part of its carrier
        }
    }
    /// An impulse through the center of mass of the body that slides ends its approach. Then it
    /// moves along the other body. False if it has done so often in this step.
    bool slide(const Meeting& meeting) {
        Mover& sliding = movers_[mover(meeting.slides)];
        if (++sliding.slides > most_slides) return false;
        const uint32_t other = meeting.slides == meeting.a ? meeting.b : meeting.a;
        BodyState& a = in_.columns.states[meeting.slides];
        BodyState& b = in_.columns.states[other];
        const Vec2 n = normalized(meeting.back);
        const Vec2 arm =
            sliding.motion.center(meeting.time) - motion_of(other).center(meeting.time);
        const SolverBody immovable, &mass_a = mass_of(meeting.slides, immovable),
                                    &mass_b = mass_of(other, immovable);
        const float turn = mass_b.inverse_inertia * cross(arm, n);
        const float speed = dot(n, a.velocity - b.velocity - cross(b.angular_velocity, arm));
        const float mobility = mass_a.inverse_mass + mass_b.inverse_mass + turn * cross(arm, n);
        if (speed < 0.0f && mobility > 0.0f) {
            const float impulse = -speed / mobility;
            a.velocity = a.velocity + (mass_a.inverse_mass * impulse) * n;
            b.velocity = b.velocity - (mass_b.inverse_mass * impulse) * n;
            b.angular_velocity -= turn * impulse;
            limit_speed(in_, meeting.slides);
            limit_speed(in_, other);
        }
        Motion motion = sliding.motion;
        motion.velocity = motion.velocity + (1.0f / (1.0f - meeting.time)) * meeting.back;
        motion.from = sliding.motion.center(meeting.time);
        motion.angle = float(sliding.motion.rotation(meeting.time));
        motion.since = meeting.time;
        motion.until = min(sliding.motion.until,
                           time_of_impact_with_fixed(in_, sliding.body, motion, meeting.time).time);
        change(mover_of_[meeting.slides], motion, meeting.time);
        return true;
    }
    /// The inverse masses of a body that moves freely; else zeros.
    const SolverBody& mass_of(uint32_t body, const SolverBody& immovable) const {
        const BodyRecord& r = record(body);
        const bool free = r.mobility == Mobility::dynamic && r.solver_index != 0 &&
                          !r.flags.locked_x && !r.flags.locked_y && !r.flags.locked_rotation;
        return free ? in_.bodies.solver_bodies[r.solver_index] : immovable;
    }
    /// True if a driven body carries it, itself or with another one.
    bool is_driven_along(size_t i) const {
        const uint32_t carrier = movers_[i].carrier;
        return carrier != none && record(carrier).mobility == Mobility::kinematic;
    }

    void change(size_t i, const Motion& motion, float now) {
        Mover& mover = movers_[i];
        mover.motion = motion;
        mover.changed = true;
        ++mover.version;
        mover.box = swept_boxes(mover, now);
        find_meetings(i, now, false);
        // What it carries follows its new motion.
        const uint32_t body = movers_[i].body;
        for (size_t k = 0; k < movers_.size(); ++k)
            if (movers_[k].carrier == body && !movers_[k].blocked) carry(k, body, now);
    }
    void stop(size_t i, float now, bool blocked) {
        movers_[i].blocked |= blocked;
        const Motion& motion = movers_[i].motion;
        if (!motion.moves_after(now)) return;
        undo_forces(in_, movers_[i].body, motion.until - now);
        change(i, at_rest(motion.center(now), float(motion.rotation(now))), now);
    }
    /// The direction from a body of a meeting to the other one.
    Vec2 away_from(uint32_t body, const Meeting& meeting) const {
        const bool from_a = body == meeting.a;
        const auto sweep = [&](uint32_t shape) {
            const uint32_t its = in_.objects.forms[shape].body;
            return Sweep{solid_of(in_.objects, in_.columns, shape), motion_of(its),
                         record(its).extent};
        };
        return direction_between(sweep(from_a ? meeting.shape_a : meeting.shape_b),
                                 sweep(from_a ? meeting.shape_b : meeting.shape_a), meeting.time);
    }
    /// The body had no contact with the kinematic body in this step, and meets it now.
    void hit(size_t i, uint32_t kinematic, float now) {
        movers_[i].hit_by = kinematic;
        if (record(movers_[i].body).solver_index != 0)
            undo_forces(in_, movers_[i].body, max(movers_[i].motion.until - now, 0.0f));
    }
    /// The body is carried along: it turns with the carrier and goes no nearer to it. `normal`:
    /// from the carrier to the body; the body keeps its motion along the surface and away from it.
    /// Without a normal it moves as if it were fixed to the carrier: it has just arrived, and if it
    /// went on, the next step would find no contact that changes its velocity.
    void carry(size_t i, uint32_t carrier, float now, Vec2 normal = {}) {
        const Motion driver = motion_of(carrier);
        const Motion& before = movers_[i].motion;
        const float left = 1.0f - now;
        Motion motion;
        motion.since = now;
        motion.from = before.center(now);
        motion.angle = float(before.rotation(now));
        const double turn = driver.rotation(1.0f) - driver.rotation(now);
        const Rotation turned = rotation_of(turn);
        const Vec2 arm = motion.from - driver.center(now);
        Vec2 turned_arm = rotate(turned, arm);
        // A dynamic body that turns takes it along only as far as its surface moves towards it: the
        // next step finds the place at which it has met the surface.
        if (const Vec2 away = movers_[i].away; away != Vec2{})
            turned_arm = arm + dot(turned_arm - arm, away) * away;
        Position end = driver.center(1.0f) + turned_arm;
        if (normal != Vec2{} && movers_[i].slides <= most_slides) {
            const Vec2 own = unrotate(turned, before.center(1.0f) - end);
            const float inwards = min(dot(own, normal), 0.0f);
            // Seen from a carrier that turns, its straight way is an arc, which may go into the
            // surface and out again.
            if (movers_[i].carrier == carrier && inwards > -end_gap) return;
            end = end + rotate(turned, own - inwards * normal);
        }
        motion.velocity = (1.0f / left) * (end - motion.from);
        motion.turn = float(turn) / left;
        motion.until = time_of_impact_with_fixed(in_, movers_[i].body, motion, now).time;
        movers_[i].blocked = motion.until < 1.0f;
        movers_[i].carrier = carrier;
        change(i, motion, now);
    }

    void place_changed_bodies() {
        FinishedPiece& piece = in_.scratch.finished.front();
        std::vector<FastBody>& fast = in_.scratch.fast_bodies;
        for (Mover& mover : movers_) {
            if (!mover.changed) continue;
            wake_body(in_.activity, mover.body);
            piece.clear();
            follow_motion(in_, mover.body, mover.motion, piece);
            follow_placed(in_, piece);
            // For the sensors on the way.
            if (mover.place == none) {
                mover.place = uint32_t(fast.size());
                fast.push_back({mover.body, mover.motion});
            }
            const double turn = mover.motion.rotation(1.0f) - mover.whole.rotation(0.0f);
            Motion& motion = fast[mover.place].motion;
            motion = {};
            motion.from = mover.whole.center(0.0f);
            motion.velocity = mover.motion.center(1.0f) - motion.from;
            motion.turn = float(turn);
            motion.angle = -motion.turn;
        }
    }

    const FinishInput& in_;
    std::vector<uint32_t>& mover_of_;
    std::vector<Mover> movers_;
    std::vector<Meeting> queue_;
};

}  // namespace

void meet_moving_bodies(const FinishInput& in) {
    const auto meets = [](const FastBody& body) { return body.meets_moving; };
    const std::vector<FastBody>& fast = in.scratch.fast_bodies;
    if (std::any_of(fast.begin(), fast.end(), meets)) MovingImpacts(in).run();
}

}  // namespace fettle::physics::detail
