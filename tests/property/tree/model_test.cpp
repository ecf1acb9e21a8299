// The tree compared with a simple model: for random sequences of edits, simulated writes, creation,
// deletion, moves, watching and barriers, both must deliver the same changes.

#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "catch.h"
#include "fixture.h"

namespace model_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

using Key = std::pair<int, std::string>;  // instance number, property

struct ModelInstance {
    int parent = -1;  // -1: the world
    std::string name;
    bool alive = true;
    std::map<std::string, Value> values{
        {"mass", Value(1.0)}, {"velocity", Value(Vec2(0, 0))}, {"radius", Value(0.5)}};
};

struct ModelWatcher {
    enum Kind { cell, instance, of_class, pattern } kind;
    int target = 0;
    std::string property;
    bool active = true;
    int born = 0;  // number of changes queued before its registration
};

struct Pending {
    Key key;
    Value first_old, last_new;
    int last_queued = 0;
};

class Model {
  public:
    std::vector<ModelInstance> instances;
    std::vector<ModelWatcher> watchers;
    std::vector<Pending> pending;
    std::map<Key, Value> shadow;  // of simulated cells: the value that watchers got last
    int watcher_clock = 0;

    bool inside(int instance) const {
        return instances[static_cast<std::size_t>(instance)].parent == -1;
    }

    bool wants(const ModelWatcher& w, const Key& key) const {
        if (!w.active) return false;
        if (w.kind == ModelWatcher::cell) return w.target == key.first && w.property == key.second;
        if (w.kind == ModelWatcher::instance) return w.target == key.first;
        if (w.kind == ModelWatcher::of_class) return w.property == key.second;
        return w.property == key.second && inside(key.first);  // world.*.<property>
    }
    bool watched(const Key& key) const {
        return std::any_of(watchers.begin(), watchers.end(),
                           [&](const auto& w) { return wants(w, key); });
    }

    void edit(const Key& key, const Value& value) {
        Value& cell = instances[static_cast<std::size_t>(key.first)].values[key.second];
        if (cell == value) return;
        const Value old = cell;
        cell = value;
        if (!may_be_wanted(key)) return;
        note(key, old, value);
    }
    // The tree queues a change if it may have a watcher: one of the instance, or a broad one of the
    // name.
    bool may_be_wanted(const Key& key) const {
        return std::any_of(watchers.begin(), watchers.end(), [&](const ModelWatcher& w) {
            if (!w.active) return false;
            if (w.kind == ModelWatcher::cell || w.kind == ModelWatcher::instance)
                return w.target == key.first;
            return w.property == key.second;
        });
    }
    // A watcher that began after the change was queued has seen its last value: what follows is a
    // change of its own.
    void note(const Key& key, const Value& old, const Value& next) {
        shadow.erase(key);
        const auto found = std::find_if(pending.rbegin(), pending.rend(),
                                        [&](const Pending& p) { return p.key == key; });
        const bool joins = found != pending.rend() &&
                           std::none_of(watchers.begin(), watchers.end(), [&](const auto& w) {
                               return wants(w, key) && w.born > found->last_queued;
                           });
        if (!joins) {
            pending.push_back({key, old, next, watcher_clock});
            return;
        }
        found->last_new = next;
        found->last_queued = watcher_clock;
    }
    std::vector<std::string> deliver() {
        std::vector<std::string> log;
        for (const Pending& p : pending) {
            const ModelInstance& i = instances[static_cast<std::size_t>(p.key.first)];
            if (!i.alive) continue;
            if (p.last_new == p.first_old) continue;
            for (std::size_t w = 0; w < watchers.size(); ++w)
                if (wants(watchers[w], p.key) && watchers[w].born <= p.last_queued)
                    log.push_back(std::to_string(w) + " " + std::to_string(p.key.first) + "." +
                                  p.key.second + " " + value_text(p.first_old) + ">" +
                                  value_text(p.last_new));
        }
        pending.clear();
        return log;
    }
};

class Run {
  public:
    void step() {
        switch (*rc::gen::inRange(0, 12)) {
            case 0:
            case 1:
                return create();
            case 2:
                return destroy();
            case 3:
                return move();
            case 4:
            case 5:
                return watch();
            case 6:
                return stop();
            case 7:
                return barrier();
            case 8:
                return simulate();
            default:
                return edit();
        }
    }

    void barrier() {
        log_.clear();
        tree_.barrier();
        RC_ASSERT(log_ == model_.deliver());
        check_values();
    }

  private:
    std::optional<int> any_alive() {
        std::vector<int> alive;
        for (std::size_t i = 0; i < model_.instances.size(); ++i)
            if (model_.instances[i].alive) alive.push_back(static_cast<int>(i));
        if (alive.empty()) return std::nullopt;
        return alive[static_cast<std::size_t>(
            *rc::gen::inRange(0, static_cast<int>(alive.size())))];
    }
    Handle handle(int i) const { return handles_[static_cast<std::size_t>(i)]; }

    void create() {
        const std::string name = "n" + std::to_string(model_.instances.size());
        handles_.push_back(tree_.create(*module_.type, world_, name));
        numbers_[{handles_.back().index, handles_.back().generation}] =
            static_cast<int>(model_.instances.size());
        model_.instances.emplace_back().name = name;
    }
    void destroy() {
        const auto i = any_alive();
        if (!i) return;
        for (std::size_t c = 0; c < model_.instances.size(); ++c)
            if (model_.instances[c].alive &&
                tree_.is_below(handle(static_cast<int>(c)), handle(*i)))
                kill(static_cast<int>(c));
        kill(*i);
        tree_.destroy(handle(*i));
    }
    void kill(int i) {
        model_.instances[static_cast<std::size_t>(i)].alive = false;
        for (ModelWatcher& w : model_.watchers)
            if ((w.kind == ModelWatcher::cell || w.kind == ModelWatcher::instance) && w.target == i)
                w.active = false;
    }
    void move() {
        const auto i = any_alive();
        const auto to = any_alive();
        if (!i || *i == *to || tree_.is_below(handle(*to), handle(*i))) return;
        const bool up = *rc::gen::arbitrary<bool>();
        tree_.move(handle(*i), up ? world_ : handle(*to));
        model_.instances[static_cast<std::size_t>(*i)].parent = up ? -1 : *to;
        RC_ASSERT(tree_.name(handle(*i)) == model_.instances[static_cast<std::size_t>(*i)].name);
    }
    void edit() {
        const auto i = any_alive();
        if (!i) return;
        const double x = *rc::gen::inRange(1, 5);
        const int which = *rc::gen::inRange(0, 3);
        const std::string name = which == 0 ? "mass" : which == 1 ? "radius" : "velocity";
        const Value value = which == 2 ? Value(Vec2(x, 0)) : Value(x);
        tree_.set(handle(*i), name, value);
        model_.edit({*i, name}, value);
    }
    void simulate() {
        // A step writes velocities without notifying the tree. The barriers before and after it
        // separate these changes from those of edits.
        barrier();
        ++steps_;
        std::vector<Key> moved;
        for (std::size_t i = 0; i < model_.instances.size(); ++i) {
            if (!model_.instances[i].alive || !*rc::gen::arbitrary<bool>()) continue;
            const auto x = static_cast<float>(*rc::gen::inRange(1, 4));
            module_.ball(handles_[i]).velocity[1] = x;
            Value& cell = model_.instances[i].values["velocity"];
            const Value next = Vec2(cell.vec2().x, static_cast<double>(x));
            if (next == cell) continue;
            simulated_.insert_or_assign(static_cast<int>(i), std::pair(cell, next));
            cell = next;
        }
        tree_.set_step(steps_);
        tree_.stepped();
        log_.clear();
        tree_.barrier();
        // Changes of simulated cells are in the order in which the cells were first watched; the
        // model does not define that order.
        std::vector<std::string> expected;
        for (const auto& [i, change] : simulated_)
            for (std::size_t w = 0; w < model_.watchers.size(); ++w)
                if (model_.wants(model_.watchers[w], {i, "velocity"}))
                    expected.push_back(std::to_string(w) + " " + std::to_string(i) + ".velocity " +
                                       value_text(change.first) + ">" + value_text(change.second));
        simulated_.clear();
        std::sort(expected.begin(), expected.end());
        std::sort(log_.begin(), log_.end());
        RC_ASSERT(log_ == expected);
    }
    void watch() {
        const auto i = any_alive();
        if (!i) return;
        const auto kind = static_cast<ModelWatcher::Kind>(*rc::gen::inRange(0, 4));
        const int which = *rc::gen::inRange(0, 3);
        const std::string name = which == 0 ? "mass" : which == 1 ? "radius" : "velocity";
        const std::size_t number = model_.watchers.size();
        const auto handler = [this, number](const Change& c) {
            if (c.property->name == "area")
                return;  // a derived property: the model has only sources
            log_.push_back(std::to_string(number) + " " +
                           std::to_string(numbers_.at({c.instance.index, c.instance.generation})) +
                           "." + c.property->name + " " + value_text(c.old_value) + ">" +
                           value_text(c.new_value));
        };
        switch (kind) {
            case ModelWatcher::cell:
                connections_.push_back(tree_.watch(handle(*i), name, handler));
                break;
            case ModelWatcher::instance:
                connections_.push_back(tree_.watch(handle(*i), handler));
                break;
            case ModelWatcher::of_class:
                connections_.push_back(
                    tree_.watch(*module_.type, module_.type->property(name), handler));
                break;
            case ModelWatcher::pattern:
                connections_.push_back(tree_.watch_pattern("world.*." + name, handler));
                break;
        }
        ++model_.watcher_clock;
        model_.watchers.push_back({kind, *i, name, true, model_.watcher_clock});
    }
    void stop() {
        if (connections_.empty()) return;
        const auto w =
            static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(connections_.size())));
        connections_[w].stop();
        model_.watchers[w].active = false;
    }
    void check_values() {
        for (std::size_t i = 0; i < model_.instances.size(); ++i) {
            RC_ASSERT(tree_.alive(handles_[i]) == model_.instances[i].alive);
            if (!model_.instances[i].alive) continue;
            for (const auto& [name, value] : model_.instances[i].values)
                RC_ASSERT(tree_.get(handles_[i], name) == value);
        }
    }

    Tree tree_;
    BallModule module_{tree_};
    Handle world_ = tree_.create(tree_.object_class(), tree_.root(), "world");
    Model model_;
    std::vector<Handle> handles_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> numbers_;
    std::vector<Connection> connections_;
    std::vector<std::string> log_;
    std::map<int, std::pair<Value, Value>> simulated_;
    std::uint64_t steps_ = 0;
};

}  // namespace

TEST_CASE("random edits and watchers and deletions behave as in a simple model") {
    const bool holds = rc::check("tree equals model", [] {
        Run run;
        const int length = *rc::gen::inRange(1, 120);
        for (int i = 0; i < length; ++i) run.step();
        run.barrier();
    });
    CHECK(holds);
}

}  // namespace model_test
