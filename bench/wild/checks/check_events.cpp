// Every begin event has its end event, and the lists of the world are consistent.

#include <set>
#include <utility>

#include "wild/checks/check.h"

namespace fettle::bench::wild {
namespace {

using ShapePair = std::pair<std::uint64_t, std::uint64_t>;

std::uint64_t key(const auto& id) {
    return std::uint64_t(id.index) << 32 | id.generation;
}
ShapePair unordered(const ShapeId& a, const ShapeId& b) {
    return std::minmax(key(a), key(b));
}

/// Pairs that began and did not end. Returns the error in an event; empty if there is none.
class Open {
  public:
    const char* begin(const ShapePair& pair) {
        return open_.insert(pair).second ? "" : " begins twice";
    }
    const char* end(const ShapePair& pair) {
        return open_.erase(pair) == 1 ? "" : " ends without a beginning";
    }
    const std::set<ShapePair>& pairs() const { return open_; }

  private:
    std::set<ShapePair> open_;
};

class BeginsAndEnds : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.world == nullptr) return {};
        const Events& events = moment.world->events();
        std::string wrong;
        const auto note = [&](const char* what, const char* problem) {
            if (*problem != 0 && wrong.empty()) wrong = std::string(what) + problem;
        };
        // A touch that lasts one step begins and ends in it; a touch that ends and begins again has
        // both events in this order. So the ends of open pairs are processed first.
        const auto follow = [&](Open& open, const char* what, const auto& begins, const auto& ends,
                                const auto& pair_of) {
            std::vector<ShapePair> late;
            for (const auto& event : ends) {
                const ShapePair pair = pair_of(event);
                if (open.pairs().contains(pair))
                    open.end(pair);
                else
                    late.push_back(pair);
            }
            for (const auto& event : begins) note(what, open.begin(pair_of(event)));
            for (const ShapePair& pair : late) note(what, open.end(pair));
        };
        follow(touches_, "a touch", events.contact_begin, events.contact_end,
               [](const auto& e) { return unordered(e.shape_a, e.shape_b); });
        follow(sensed_, "an overlap with a sensor", events.sensor_begin, events.sensor_end,
               [](const auto& e) {
                   return ShapePair{key(e.sensor), key(e.visitor)};
               });
        if (wrong.empty()) wrong = compare(*moment.world);
        return wrong.empty() ? std::nullopt : std::optional(wrong);
    }

  private:
    /// The pairs that touch now must be those that have begun and not ended.
    std::string compare(const World& world) const {
        std::set<ShapePair> touching;
        for (const Contact& contact : world.contacts())
            touching.insert(unordered(contact.shape_a, contact.shape_b));
        for (const ShapePair& pair : touching)
            if (!touches_.pairs().contains(pair)) return "a touch has not begun";
        for (const ShapePair& pair : touches_.pairs())
            if (!touching.contains(pair)) return "a touch is over and has not ended";
        return {};
    }
    Open touches_, sensed_;
};

class Consistent : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        // `validate` reads the whole world, which takes as long as many steps.
        if (moment.world == nullptr || (moment.step % 16 != 0 && !moment.is_last())) return {};
        return moment.world->validate();
    }
};

}  // namespace

std::unique_ptr<Check> check_events(const WorldPlan&) {
    return std::make_unique<BeginsAndEnds>();
}
std::unique_ptr<Check> check_consistent(const WorldPlan&) {
    return std::make_unique<Consistent>();
}

}  // namespace fettle::bench::wild
