// A body that can rest comes to rest in time.

#include <algorithm>
#include <cmath>

#include "report/table.h"
#include "wild/checks/check.h"
#include "wild/checks/facts.h"

namespace fettle::bench::wild {
namespace {

/// Box2D lets heaps of hundreds of bodies sleep within 5 s of their fall, and these worlds have
/// some tens. A fall from the height of the grammar takes 1.7 s.
constexpr double allowed = 8;  // s after the last edit

/// How long round bodies may roll: rolling resistance of coefficient c slows a disc by 2/3 c g.
double rolling_time(const WorldPlan& plan) {
    double longest = 0;
    for (const BodyPlan& body : plan.bodies)
        for (const ShapePlan& shape : body.shapes) {
            if (shape.def.rolling_resistance <= 0) continue;
            const double speed =
                body.def.velocity.length() + reach_of(body) * std::abs(body.def.angular_velocity);
            longest = std::max(longest, speed / (6.7 * shape.def.rolling_resistance));
        }
    return longest;
}

class Rest : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.step == 0) {
            judged_ = can_rest(moment.plan);
            allowed_ = allowed + rolling_time(moment.plan);
        }
        if (!judged_) return {};
        time_ = moment.step <= moment.plan.last_edit() ? 0 : time_ + moment.dt;
        if (time_ <= allowed_) return {};
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
    bool judged_ = false;
    double allowed_ = allowed;
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Check> check_rest(const WorldPlan&) {
    return std::make_unique<Rest>();
}

}  // namespace fettle::bench::wild
