// A sensor reports the beginning of an overlap with every body whose inside (see passages.h) enters
// it: in the same step, or in the next step, which finds the overlaps at its start.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "wild/checks/passages.h"

namespace fettle::bench::wild {
namespace {

class Sensors : public Check {
  public:
    explicit Sensors(const WorldPlan& plan)
        : passages_(plan, [](const auto& obstacle, const auto& of_obstacle, const auto& body,
                             const auto& of_body) {
              const ShapeDef &a = of_obstacle.def, &b = of_body.def;
              return obstacle.def.type == BodyType::static_body && a.sensor && !b.sensor &&
                     (a.mask & b.category) != 0 && (b.mask & a.category) != 0 && !is_fixed(body);
          }) {}

    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.world == nullptr) return {};
        const Events& events = moment.world->events();
        std::set<Pair> reported;
        for (const SensorEvent& begin : events.sensor_begin) ++shapes_inside_[pair_of(begin)];
        for (const auto& [pair, shapes] : shapes_inside_) reported.insert(pair);
        for (const SensorEvent& end : events.sensor_end) {
            const auto pair = shapes_inside_.find(pair_of(end));
            if (pair != shapes_inside_.end() && --pair->second == 0) shapes_inside_.erase(pair);
        }
        // After an edit of its mask in between, no begin is due.
        for (const Entry& entry : entered_)
            if (!reported.contains(entry.pair) && !moment.edited_bodies[entry.body])
                return entry.words;
        entered_.clear();
        for (const Passage& passage : passages_.of(moment)) {
            if (passage.sense < 0) continue;
            // If the body touched another one, its way was not straight.
            const auto body = std::size_t(passage.body);
            if (moment.before[body].touching() || moment.after[body].touching()) continue;
            const std::uint32_t sensor = moment.after[std::size_t(passage.obstacle)].slot;
            const Pair pair = {sensor, moment.after[body].slot};
            if (reported.contains(pair)) continue;
            entered_.push_back({pair, body,
                                "body " + std::to_string(passage.body) +
                                    " enters the sensor on body " +
                                    std::to_string(passage.obstacle) + " at " +
                                    std::to_string(int(moment.after[body].velocity.length())) +
                                    " m/s, and no begin is reported"});
        }
        return {};
    }

  private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;  // slots of both bodies
    static Pair pair_of(const SensorEvent& event) {
        return {event.sensor_body.index, event.visitor_body.index};
    }

    struct Entry {
        Pair pair;
        std::size_t body;
        std::string words;
    };

    Passages passages_;
    std::map<Pair, int> shapes_inside_;  // the number of overlaps that have begun and not ended
    std::vector<Entry> entered_;         // in the last step, not reported yet
};

}  // namespace

std::unique_ptr<Check> check_sensors(const WorldPlan& plan) {
    return std::make_unique<Sensors>(plan);
}

}  // namespace fettle::bench::wild
