#include "wild/plan_run.h"

#include <algorithm>
#include <stdexcept>

namespace fettle::bench::wild {
namespace {

/// Edits of surfaces and velocities leave shape, pose and kind of a body as they are.
bool changes_body(const Edit& edit) {
    if (edit.target != Target::body && edit.target != Target::shape) return false;
    for (const char* name : {"set_friction", "set_restitution", "set_surface_speed", "set_velocity",
                             "set_angular_velocity", "apply_impulse", "set_awake"})
        if (edit.setting.setter == name) return false;
    return true;
}

struct Watch {
    std::string name;
    std::unique_ptr<Check> check;
};

class WatchedRun {
  public:
    WatchedRun(const WorldPlan& plan, std::span<const Invariant> watched) : now_(plan) {
        for (const Invariant& invariant : watched)
            watches_.push_back({invariant.name, invariant.make_check(plan)});
    }

    void step(RunningWorld& world, int step, PlanRun& result) {
        world.prepare(step);
        const bool edited = now_.edited_at(step);
        if (edited || step == 0)
            world.read(before_);
        else
            before_ = after_;
        edited_bodies_.assign(now_.bodies.size(), false);
        if (edited) follow_edits(step);
        const float dt = now_.length_of(step);
        world.advance(dt);
        ++result.steps;
        world.read(after_);
        time_ += dt;
        const auto is_awake = [](const BodyNow& body) {
            return body.exists && body.awake && body.type == BodyType::dynamic_body;
        };
        if (std::ranges::any_of(after_, is_awake)) result.awake = time_;
        const Moment moment{now_,           step,    dt,     edited,
                            edited_bodies_, before_, after_, world.fettle()};
        std::erase_if(watches_, [&](const Watch& watch) {
            const auto what = watch.check->violation(moment);
            if (what) result.findings.push_back({watch.name, step, *what});
            return what.has_value();
        });
    }
    bool is_over() const { return watches_.empty(); }

  private:
    void follow_edits(int step) {
        for (const Edit& edit : now_.edits) {
            if (edit.step != step) continue;
            if (changes_body(edit)) edited_bodies_[std::size_t(edit.object)] = true;
            if (edit.target == Target::joint)
                now_.joints[std::size_t(edit.object)].set(edit.setting);
            if (edit.setting.setter == "set_gravity") now_.def.gravity = edit.setting.value;
            if (edit.setting.setter == "set_substeps")
                now_.def.substeps = int(edit.setting.value.x);
        }
    }

    WorldPlan now_;
    std::vector<Watch> watches_;
    std::vector<BodyNow> before_, after_;
    std::vector<bool> edited_bodies_;
    double time_ = 0;
};

}  // namespace

PlanRun try_plan(const WorldPlan& plan, const MakeWorld& make, std::span<const Invariant> watched) {
    PlanRun result;
    int step = 0;
    try {
        const std::unique_ptr<RunningWorld> world = make(plan);
        WatchedRun run(plan, watched);
        for (; step < plan.steps && !run.is_over(); ++step) run.step(*world, step, result);
    } catch (const std::exception& error) {
        result.findings.push_back({"throws", step, error.what()});
    }
    return result;
}

std::vector<Invariant> invariants_named(const std::vector<std::string>& names) {
    std::vector<Invariant> chosen;
    for (const Invariant& invariant : invariants())
        if (names.empty() || std::ranges::count(names, invariant.name) > 0)
            chosen.push_back(invariant);
    for (const std::string& name : names)
        if (name != "same" && name != "throws" &&
            std::ranges::count(chosen, name, &Invariant::name) == 0) {
            std::string all = "same, throws";
            for (const Invariant& invariant : invariants()) all += ", " + invariant.name;
            throw std::invalid_argument("\"" + name + "\" is not an invariant; there are " + all);
        }
    return chosen;
}

}  // namespace fettle::bench::wild
