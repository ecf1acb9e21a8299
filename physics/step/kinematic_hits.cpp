#include <contacts/mixing.h>
#include <contacts/narrow_phase.h>
#include <contacts/reports.h>
#include <state/limits.h>
#include <step/time_of_impact.h>

#include <algorithm>
#include <optional>

// Hits by kinematic bodies that the solver did not see: at the beginning of the step the shapes had
// no contact, and they met within it. The kinematic body carries the other one along, but it may
// stand still in the next step: a piston or a flipper at its end. So the body gets the velocity of
// the impact at once, and the touch and the hit are reported in this step. In the next step the two
// shapes do not approach each other any more.

namespace fettle::physics::detail {
namespace {

/// Points whose gaps differ by less than this meet at the same time, m.
constexpr float same_gap = touch_distance;
/// Rounds over all points; a single point needs one.
constexpr int most_rounds = 60;

/// The velocities of the body that is hit, and how impulses change them.
struct HitBody {
    Vec2 velocity;
    float turn;
    Vec2 inverse_mass;  ///< 0 along a locked axis
    float inverse_inertia;

    HitBody(const BodyRecord& record, const BodyState& state)
        : velocity(state.velocity),
          turn(state.angular_velocity),
          inverse_mass{record.flags.locked_x ? 0.0f : record.inverse_mass,
                       record.flags.locked_y ? 0.0f : record.inverse_mass},
          inverse_inertia(record.flags.locked_rotation ? 0.0f : record.inverse_inertia) {}

    Vec2 at(Vec2 arm) const { return velocity + cross(turn, arm); }
    float response(Vec2 arm, Vec2 along) const {
        const float lever = cross(arm, along);
        return inverse_mass.x * along.x * along.x + inverse_mass.y * along.y * along.y +
               inverse_inertia * lever * lever;
    }
    void push(Vec2 arm, Vec2 impulse) {
        velocity.x += inverse_mass.x * impulse.x;
        velocity.y += inverse_mass.y * impulse.y;
        turn += inverse_inertia * cross(arm, impulse);
    }
};

/// A point of a contact, seen from the body that is hit.
struct HitPoint {
    uint32_t touch;  ///< index of its contact in the list
    Vec2 normal;     ///< from the kinematic body
    Vec2 arm;        ///< from the center of mass
    Vec2 surface;    ///< velocity of the kinematic body there
    float gap;
    float wanted = 0.0f;                 ///< velocity along the normal after the impact, m/s
    float pushed = 0.0f, rubbed = 0.0f;  ///< impulses

    float speed(const HitBody& body) const { return dot(normal, body.at(arm) - surface); }
};

struct HitTouch {
    uint32_t contact;      ///< none: two shapes without a record
    ContactRecord record;  ///< a copy
    bool first = false;    ///< the body that is hit is a
    Vec2 impulse = {};     ///< on the body that is hit
    float twist = 0.0f;
};

class Hit {
  public:
    Hit(const FinishInput& in, uint32_t kinematic, uint32_t body)
        : in_(in), kinematic_(kinematic), body_(body), hit_(record(), in.columns.states[body]) {
        find_points();
        keep_nearest();
    }
    void run() {
        if (in_.decision) ask_user();
        if (!push()) return;
        rub();
        for (const HitPoint& p : points_) {
            HitTouch& touch = touches_[p.touch];
            const Vec2 impulse = p.pushed * p.normal + p.rubbed * right_perp(p.normal);
            touch.impulse = touch.impulse + impulse;
            touch.twist += cross(p.arm, impulse);
        }
        for (const HitTouch& touch : touches_) {
            report(touch);
            add_to_account(touch);
        }
        BodyState& state = in_.columns.states[body_];
        state.velocity = bounded(hit_.velocity, greatest_speed);
        state.angular_velocity = bounded(hit_.turn, greatest_speed);
        limit_speed(in_, body_);
        in_.objects.bodies[body_].sleep_time = 0.0f;
    }

  private:
    BodyRecord& record() const { return in_.objects.bodies[body_]; }

    void find_points() {
        for_each_pushing(in_.objects, body_, [&](uint32_t own) {
            const Box4 around = grow(in_.boxes.boxes[own], speculative_margin);
            for_each_pushing(in_.objects, kinematic_, [&](uint32_t other) {
                if (overlap(around, in_.boxes.boxes[other]) && may_meet(in_, own, other))
                    add_touch(own, other);
            });
        });
    }
    void add_touch(uint32_t own, uint32_t other) {
        const uint32_t a = std::min(own, other), b = std::max(own, other);
        HitTouch touch;
        touch.contact = in_.boxes.pairs.find(a, b);
        if (touch.contact == PairSet::absent && !in_.objects.shapes[a].crowded &&
            !in_.objects.shapes[b].crowded) {
            count_contact(in_.objects, a, b);
            create_contact(in_.list, in_.settings, a, b);
            touch.contact = in_.boxes.pairs.find(a, b);
        }
        if (touch.contact == PairSet::absent) {
            // Crowded shapes choose their pairs at the beginning of the next step.
            touch.contact = none;
            touch.record.shape_a = a;
            touch.record.shape_b = b;
            touch.record.body_a = in_.objects.forms[a].body;
            touch.record.body_b = in_.objects.forms[b].body;
            remix(in_.objects, in_.settings, touch.record);
        } else {
            touch.record = in_.objects.contacts[touch.contact];
        }
        update_manifold(in_.objects, in_.columns, in_.settings, touch.record);
        touch.first = a == own;
        const Manifold& m = touch.record.manifold;
        const BodyState& driver = in_.columns.states[kinematic_];
        for (int k = 0; k < m.count; ++k) {
            const ManifoldPoint& p = m.points[k];
            const Vec2 arm = touch.first ? p.anchor_a : p.anchor_b;
            const Vec2 from = touch.first ? p.anchor_b : p.anchor_a;
            points_.push_back({uint32_t(touches_.size()), touch.first ? -m.normal : m.normal, arm,
                               driver.velocity + cross(driver.angular_velocity, from),
                               p.separation});
        }
        touches_.push_back(touch);
    }
    void keep_nearest() {
        float nearest = infinity;
        for (const HitPoint& p : points_) nearest = min(nearest, p.gap);
        std::erase_if(points_, [&](const HitPoint& p) {
            return p.gap > max(nearest, 0.0f) + same_gap ||
                   !(hit_.response(p.arm, p.normal) > 0.0f);
        });
    }
    bool approaches(const HitPoint& p) const { return p.speed(hit_) < 0.0f; }
    /// Leaves out the contacts that the callbacks of the user disable.
    void ask_user() {
        for (uint32_t i = 0; i < touches_.size(); ++i) {
            HitTouch& touch = touches_[i];
            const bool meets = std::any_of(points_.begin(), points_.end(), [&](const HitPoint& p) {
                return p.touch == i && approaches(p);
            });
            if (!meets || touch.contact == none) continue;
            in_.objects.contacts[touch.contact].manifold = touch.record.manifold;
            const bool acts = in_.decision(touch.contact);
            touch.record = in_.objects.contacts[touch.contact];
            if (!acts) std::erase_if(points_, [&](const HitPoint& p) { return p.touch == i; });
        }
    }
    /// Ends the approach of all points together. False if none approaches.
    bool push() {
        constexpr float accuracy = 1e-6f;
        float fastest = 0.0f;
        for (HitPoint& p : points_) {
            const float closing = -p.speed(hit_);
            fastest = max(fastest, closing);
            if (closing > in_.settings.restitution_threshold)
                p.wanted = touches_[p.touch].record.restitution * closing;
        }
        if (!(fastest > 0.0f)) return false;
        for (int round = 0; round < most_rounds; ++round) {
            float missing = 0.0f;
            for (HitPoint& p : points_) {
                const float lacks = p.wanted - p.speed(hit_);
                const float total = max(p.pushed + lacks / hit_.response(p.arm, p.normal), 0.0f);
                const float added = total - p.pushed;
                if (added == 0.0f) continue;
                missing = max(missing, std::fabs(lacks));
                p.pushed = total;
                hit_.push(p.arm, added * p.normal);
            }
            if (!(missing > accuracy * fastest)) break;
        }
        return true;
    }
    void rub() {
        constexpr int rounds = 8;
        for (int round = 0; round < rounds; ++round) {
            for (HitPoint& p : points_) {
                const HitTouch& touch = touches_[p.touch];
                const Vec2 t = right_perp(p.normal);
                // The surface speed is that of a against b.
                const float slip = dot(t, hit_.at(p.arm) - p.surface) + touch.record.surface_speed;
                const float response = hit_.response(p.arm, t);
                if (!(response > 0.0f)) continue;
                const float most = touch.record.friction * p.pushed;
                const float total = clamp(p.rubbed - slip / response, -most, most);
                hit_.push(p.arm, (total - p.rubbed) * t);
                p.rubbed = total;
            }
        }
    }
    /// Stores the contact, and reports it as the solver reports hits.
    void report(const HitTouch& touch) const {
        if (touch.contact == none || touch.impulse == Vec2{}) return;
        ContactRecord& c = in_.objects.contacts[touch.contact];
        c.manifold = touch.record.manifold;
        c.kept = false;
        // The velocities of the states are those at the impact, and forces add nothing to them.
        Touching touching = in_.list.touching;
        touching.substep = 0.0f;
        if (!c.touching) set_touching(touching, touch.contact, true);
        if (const auto hit = hit_of(touching, in_.settings.hit_threshold, touch.contact, nullptr))
            touching.events.contact_hit.push_back(*hit);
    }

    void add_to_account(const HitTouch& touch) const {
        const ContactRecord& c = touch.record;
        for (VelocitySums& sums : in_.sums) {
            if (sums.solver_body == 0 || sums.body.index != body_ || touch.impulse == Vec2{})
                continue;
            VelocitySums::OfContact& sum = sums.contacts.emplace_back();
            sum.contact = touch.contact;
            sum.own = shape_id(in_.objects, in_.columns, touch.first ? c.shape_a : c.shape_b);
            sum.other = shape_id(in_.objects, in_.columns, touch.first ? c.shape_b : c.shape_a);
            sum.body = body_id(in_.columns, kinematic_);
            sum.impulse = touch.impulse;
            sum.twist = touch.twist;
            sums.turn.size += std::fabs(touch.twist);
        }
    }

    const FinishInput& in_;
    uint32_t kinematic_, body_;
    HitBody hit_;
    std::vector<HitTouch> touches_;
    std::vector<HitPoint> points_;
};

}  // namespace

void hit_by_kinematic(const FinishInput& in, uint32_t kinematic, uint32_t body) {
    Hit(in, kinematic, body).run();
}

}  // namespace fettle::physics::detail
