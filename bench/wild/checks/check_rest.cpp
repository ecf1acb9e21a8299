// A body that can rest comes to rest in time.

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "report/table.h"
#include "wild/checks/check.h"
#include "wild/checks/facts.h"

namespace fettle::bench::wild {
namespace {

/// Box2D lets heaps of hundreds of bodies sleep within 5 s of their fall, and these worlds have
/// some tens. A fall from the height of the generator takes 1.7 s.
constexpr double allowed = 8;  // s after the last edit or fall

/// A tower may sway for seconds before it falls over. So the time begins again when the center of
/// mass of a body is lower than ever by more than this: that may happen a few times only.
constexpr float fall = 0.5f;  // m

/// How long round bodies may still roll: rolling resistance of coefficient c slows a disc by 2/3 c
/// g.
double rolling_time(const Moment& moment) {
    double longest = 0, to_sleep = 1;  // s
    for (std::size_t i = 0; i < moment.after.size(); ++i)
        for (const ShapePlan& shape : moment.plan.bodies[i].shapes)
            if (moment.after[i].exists && shape.def.rolling_resistance > 0)
                longest = std::max(longest, double(moment.after[i].velocity.length()) /
                                                (6.7 * double(shape.def.rolling_resistance)));
    return longest > 0 ? longest + to_sleep : 0;
}

class Rest : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.step == 0) judged_ = can_rest(moment.plan);
        if (!judged_) return {};
        const bool begins = moment.step <= moment.plan.last_edit() || falls(moment);
        time_ = begins ? 0 : time_ + moment.dt;
        if (time_ <= allowed) return {};
        if (!rolling_) rolling_ = rolling_time(moment);
        if (time_ <= allowed + *rolling_) return {};
        for (std::size_t i = 0; i < moment.after.size(); ++i) {
            const BodyNow& body = moment.after[i];
            // A body that fell off the ground falls forever.
            if (!body.exists || !body.awake || body.type != BodyType::dynamic_body ||
                body.position.y < -2)
                continue;
            return "body " + std::to_string(i) + " is awake, at " + figure(body.velocity.length()) +
                   " m/s and " + figure(body.angular_velocity) + " rad/s";
        }
        return {};
    }

  private:
    bool falls(const Moment& moment) {
        lowest_.resize(moment.after.size(), std::numeric_limits<float>::max());
        bool fell = false;
        for (std::size_t i = 0; i < lowest_.size(); ++i) {
            const BodyNow& body = moment.after[i];
            if (!body.exists || body.position.y < -2 || body.center.y > lowest_[i] - fall) continue;
            lowest_[i] = body.center.y;
            fell = true;
        }
        return fell;
    }

    std::vector<float> lowest_;  // heights of the centers of mass, m
    bool judged_ = false;
    std::optional<double> rolling_;  // s that bodies may roll after the time allowed
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Check> check_rest(const WorldPlan&) {
    return std::make_unique<Rest>();
}

}  // namespace fettle::bench::wild
