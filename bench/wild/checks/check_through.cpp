// No body passes through a static or kinematic body; bullets and moving bodies do not pass through
// each other.

#include <algorithm>
#include <map>

#include "report/table.h"
#include "wild/checks/groups.h"
#include "wild/checks/passages.h"

namespace fettle::bench::wild {
namespace {

/// The library pushes overlapping shapes apart with up to 3 m/s, so an overlap that it still pushes
/// back is gone after a quarter of a second. A body that is inside or behind an obstacle for longer
/// has passed through it, unless a load holds it a little way in.
constexpr double push_time = 0.25;  // s

/// A body that was made inside another one is outside when it has overlapped none for this long.
constexpr double apart_time = 1;  // s

std::string words(const char* verb, const Passage& passage, int entered) {
    return "body " + std::to_string(passage.body) + verb + std::to_string(passage.obstacle) +
           ", entered at step " + std::to_string(entered);
}

class Through : public Check {
  public:
    Through(const WorldPlan& plan, bool bullets)
        : bullets_(bullets),
          passages_(plan, [&](const auto& obstacle, const auto& of_obstacle, const auto& body,
                              const auto& of_body) {
              if (!plan.def.continuous || !may_collide(of_obstacle.def, of_body.def)) return false;
              if (bullets) return !is_fixed(obstacle) && (obstacle.def.bullet || body.def.bullet);
              return is_fixed(obstacle);
          }) {}

    std::optional<std::string> violation(const Moment& moment) override {
        record_overlaps(moment);
        record_held(moment);
        const auto crossed = passages_.of(moment);
        if (!crossed.empty() && !bullets_) pulled_ = pulled(moment);
        for (const Passage& passage : crossed)
            if (auto what = cross(passage, moment)) return what;
        time_ += moment.dt;
        if (bullets_) return {};
        for (const auto& [pair, entry] : inside_) {
            const Passage& passage = entry.passage;
            const BodyNow& body = moment.after[std::size_t(passage.body)];
            if (passages_.is_left_out(passage.body) || passages_.is_left_out(passage.obstacle))
                continue;
            if (body.exists && time_ - entry.time > push_time && passages_.is_past(passage, moment))
                return words(" passes through body ", passage, entry.step);
        }
        return {};
    }

  private:
    struct Entry {
        Passage passage;
        int step;
        double time;
    };

    std::optional<std::string> cross(const Passage& passage, const Moment& moment) {
        const auto found = inside_.find(passage.pair());
        if (found == inside_.end()) {
            const bool enters = (passage.sense > 0 || passage.kind == Outline::Kind::line) &&
                                !began_inside(std::size_t(passage.body));
            if (enters && !is_squeezed(passage, moment))
                inside_.insert({passage.pair(), {passage, moment.step, time_}});
            return {};
        }
        const Entry entry = found->second;
        if (passage.sense == entry.passage.sense) return {};
        inside_.erase(found);
        // The body leaves a solid on the side opposite to the one where it entered. A kinematic
        // body may carry it in one step against a body that is held, before the two have a contact.
        if (passage.kind == Outline::Kind::solid && !is_crushed(passage, moment) &&
            passage.normal.dot(entry.passage.normal) < Passage::opposite)
            return words(" passes through body ", passage, entry.step);
        return {};
    }

    /// A body that is made deep inside another one, or around which an obstacle is made, came from
    /// neither side, and a chain does not hold what is behind it. Its crossings count only when it
    /// has been apart for some time.
    void record_overlaps(const Moment& moment) {
        overlapped_.resize(moment.after.size(), -apart_time);
        for (std::size_t i = 0; i < overlapped_.size(); ++i)
            if ((began_inside(i) || is_new(int(i), moment) || touches_new(i, moment)) &&
                (moment.after[i].deepest > 0.01f || passages_.is_around_line(int(i), moment)))
                overlapped_[i] = time_;
    }
    static bool is_new(int body, const Moment& moment) {
        return body != the_world && moment.plan.bodies[std::size_t(body)].born == moment.step;
    }
    static bool touches_new(std::size_t body, const Moment& moment) {
        return std::ranges::any_of(moment.after[body].touched,
                                   [&](int other) { return is_new(other, moment); });
    }
    bool began_inside(std::size_t body) const { return time_ - overlapped_[body] < apart_time; }

    /// True if a body is or was pressed between a kinematic and another obstacle, or between a
    /// bullet and another body: it then has to overlap one of the two. Through a static obstacle,
    /// only joints may pull it.
    bool is_squeezed(const Passage& passage, const Moment& moment) const {
        const BodyNow& obstacle = moment.after[std::size_t(passage.obstacle)];
        if (obstacle.type != BodyType::static_body)
            return touches_others(moment, passage.body, passage.obstacle) ||
                   is_near_other_fixed(moment, passage.body, passage.obstacle) ||
                   is_crushed(passage, moment);
        return pulled_[std::size_t(passage.body)];
    }
    bool is_crushed(const Passage& passage, const Moment& moment) const {
        return moment.after[std::size_t(passage.obstacle)].type != BodyType::static_body &&
               time_ - held_[std::size_t(passage.body)] < push_time;
    }

    /// A kinematic body passes through what it crushes, which a static body pushes out first, also
    /// through the others of a row and through joints.
    void record_held(const Moment& moment) {
        held_.resize(moment.after.size(), -1);
        const std::vector<bool> held = held_by_static(moment);
        for (std::size_t i = 0; i < held_.size(); ++i)
            if (held[i]) held_[i] = time_;
    }

    const bool bullets_;
    Passages passages_;
    std::map<decltype(Passage().pair()), Entry> inside_;
    std::vector<bool> pulled_;
    std::vector<double> overlapped_;  // time at which a body that was made inside another was in it
    std::vector<double> held_;        // time at which a static body held the body last, s
    double time_ = 0;
};

/// The border of the world pushes back however deep a body is in it, and a thin one in a pile may
/// sink in by half of it. So only a body that is outside for longer than this is lost.
constexpr double push_back_time = 1;  // s

class Border : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        const auto& bounds = moment.plan.def.bounds;
        if (!bounds) return {};
        outside_.resize(moment.after.size(), 0);
        left_out_.resize(moment.after.size(), false);
        for (std::size_t i = 0; i < moment.after.size(); ++i) {
            const BodyNow& body = moment.after[i];
            // A body that begins outside does not count.
            if (moment.edited_bodies[i] || (moment.plan.bodies[i].born == moment.step &&
                                            is_outside(moment.before[i], *bounds)))
                left_out_[i] = true;
            const bool out = body.exists && body.type == BodyType::dynamic_body && !left_out_[i] &&
                             is_solid(moment.plan.bodies[i]) && is_outside(body, *bounds);
            outside_[i] = out ? outside_[i] + moment.dt : 0;
            if (outside_[i] > push_back_time)
                return "body " + std::to_string(i) + " is outside of the bounds, at " +
                       figure(body.center.x) + ", " + figure(body.center.y);
        }
        return {};
    }

  private:
    static bool is_outside(const BodyNow& body, const Aabb& bounds) {
        return (body.center - bounds.min).smallest() < 0 ||
               (bounds.max - body.center).smallest() < 0;
    }
    /// The center of mass of one convex shape is in the shape.
    static bool is_solid(const BodyPlan& body) {
        return body.shapes.size() == 1 && !body.shapes[0].def.sensor &&
               (body.shapes[0].def.mask & 1) != 0 &&
               !std::holds_alternative<Concave>(body.shapes[0].geometry);
    }
    std::vector<double> outside_;
    std::vector<bool> left_out_;  // were edited, or began outside
};

class Both : public Check {
  public:
    explicit Both(const WorldPlan& plan) : through_(plan, false) {}
    std::optional<std::string> violation(const Moment& moment) override {
        auto what = through_.violation(moment);
        return what ? what : border_.violation(moment);
    }

  private:
    Through through_;
    Border border_;
};

}  // namespace

std::unique_ptr<Check> check_through(const WorldPlan& plan) {
    return std::make_unique<Both>(plan);
}

std::unique_ptr<Check> check_bullets(const WorldPlan& plan) {
    return std::make_unique<Through>(plan, true);
}

}  // namespace fettle::bench::wild
