#include "wild/minimize.h"

#include <algorithm>
#include <cmath>

namespace fettle::bench::wild {
namespace {

class Minimizer {
  public:
    Minimizer(WorldPlan plan, const Fails& fails) : plan_(std::move(plan)), fails_(fails) {}

    WorldPlan run() {
        cut_steps();
        // A removal may make another one possible that failed before.
        for (bool smaller = true; smaller && budget_ > 0;) {
            smaller = remove_edits();
            smaller |= remove_bodies();
            smaller |= remove_joints();
            smaller |= remove_others();
        }
        cut_steps();
        simplify_settings();
        simplify_shapes();
        for (const float per_unit : {1.0f, 10.0f, 100.0f, 1000.0f}) round_numbers(per_unit);
        remove_bodies();
        cut_steps();
        return std::move(plan_);
    }

  private:
    bool accept(WorldPlan candidate) {
        if (budget_ <= 0) return false;
        budget_ -= static_cast<long long>(candidate.steps) * (int(candidate.bodies.size()) + 1);
        if (!fails_(candidate)) return false;
        plan_ = std::move(candidate);
        return true;
    }
    template <class Change>
    bool attempt(const Change& change) {
        WorldPlan candidate = plan_;
        change(candidate);
        return accept(std::move(candidate));
    }

    void cut_steps() {
        for (int cut = plan_.steps / 2; cut > 0;) {
            const int kept = plan_.steps - cut;
            if (kept < 1 || !attempt([&](WorldPlan& plan) { plan.steps = kept; }))
                cut /= 2;
            else
                cut = std::min(cut, plan_.steps / 2);
        }
        // Edits after the last step have no effect, so they are left out.
        attempt([](WorldPlan& plan) {
            std::erase_if(plan.edits, [&](const Edit& edit) { return edit.step >= plan.steps; });
        });
    }

    /// Removes runs of items, from long runs to single ones, the last items first.
    template <class Count, class Remove>
    bool remove(const Count& count, const Remove& remove_one) {
        bool removed = false;
        for (int length = std::max(1, count(plan_) / 2); length > 0; length /= 2)
            for (int last = count(plan_) - 1; last >= 0; last -= length) {
                last = std::min(last, count(plan_) - 1);
                removed |= attempt([&](WorldPlan& plan) {
                    for (int i = last; i >= 0 && i > last - length && i < count(plan); --i)
                        remove_one(plan, i);
                });
            }
        return removed;
    }
    bool remove_edits() {
        return remove([](const WorldPlan& plan) { return int(plan.edits.size()); },
                      [](WorldPlan& plan, int i) { plan.edits.erase(plan.edits.begin() + i); });
    }
    bool remove_bodies() {
        return remove([](const WorldPlan& plan) { return int(plan.bodies.size()); },
                      [](WorldPlan& plan, int i) { plan.remove_body(i); });
    }
    bool remove_joints() {
        return remove([](const WorldPlan& plan) { return int(plan.joints.size()); },
                      [](WorldPlan& plan, int i) { plan.remove_joint(i); });
    }
    bool remove_others() {
        bool removed =
            remove([](const WorldPlan& plan) { return int(plan.fields.size()); },
                   [](WorldPlan& plan, int i) { plan.fields.erase(plan.fields.begin() + i); });
        // A body without shapes would have a mass of its own, so the first shape stays.
        for (int body = 0; body < int(plan_.bodies.size()); ++body)
            removed |= remove(
                [&](const WorldPlan& plan) {
                    return int(plan.bodies[std::size_t(body)].shapes.size()) - 1;
                },
                [&](WorldPlan& plan, int shape) { plan.remove_shape(body, shape + 1); });
        for (std::size_t joint = 0; joint < plan_.joints.size(); ++joint)
            removed |= remove(
                [&](const WorldPlan& plan) { return int(plan.joints[joint].settings.size()); },
                [&](WorldPlan& plan, int i) {
                    auto& settings = plan.joints[joint].settings;
                    settings.erase(settings.begin() + i);
                });
        return removed;
    }

    /// Sets a member to its default, unless it has it.
    template <class Definition, class Value, class Of>
    void restore(Value Definition::*member, const Of& of) {
        const Value usual = Definition{}.*member;
        if (!(of(plan_).*member == usual))
            attempt([&](WorldPlan& plan) { of(plan).*member = usual; });
    }

    void simplify_settings() {
        const auto def = [](WorldPlan& plan) -> WorldDef& { return plan.def; };
        restore(&WorldDef::solver, def);
        restore(&WorldDef::substeps, def);
        restore(&WorldDef::sleeping, def);
        restore(&WorldDef::gravity, def);
        restore(&WorldDef::bounds, def);
        restore(&WorldDef::bounds_restitution, def);
        if (plan_.lengths != std::vector{1.0f / 60})
            attempt([](WorldPlan& plan) { plan.lengths = {1.0f / 60}; });
        for (std::size_t i = 0; i < plan_.bodies.size() && budget_ > 0; ++i) {
            const auto body = [i](WorldPlan& plan) -> BodyDef& { return plan.bodies[i].def; };
            restore(&BodyDef::angle, body);
            restore(&BodyDef::velocity, body);
            restore(&BodyDef::angular_velocity, body);
            restore(&BodyDef::gravity_scale, body);
            restore(&BodyDef::linear_damping, body);
            restore(&BodyDef::angular_damping, body);
            restore(&BodyDef::bullet, body);
            restore(&BodyDef::locked_rotation, body);
            if (plan_.bodies[i].born > 0)
                attempt([&](WorldPlan& plan) { plan.bodies[i].born = 0; });
            for (std::size_t s = 0; s < plan_.bodies[i].shapes.size(); ++s) {
                const auto shape = [i, s](WorldPlan& plan) -> ShapeDef& {
                    return plan.bodies[i].shapes[s].def;
                };
                restore(&ShapeDef::density, shape);
                restore(&ShapeDef::friction, shape);
                restore(&ShapeDef::restitution, shape);
                restore(&ShapeDef::rolling_resistance, shape);
                restore(&ShapeDef::surface_speed, shape);
                restore(&ShapeDef::group, shape);
            }
        }
    }

    /// Removes rounding, and replaces unusual shapes by boxes of their size.
    void simplify_shapes() {
        for (std::size_t i = 0; i < plan_.bodies.size() && budget_ > 0; ++i)
            for (std::size_t s = 0; s < plan_.bodies[i].shapes.size(); ++s) {
                const auto replace = [&](const Geometry& by) {
                    return attempt(
                        [&](WorldPlan& plan) { plan.bodies[i].shapes[s].geometry = by; });
                };
                const Geometry now = plan_.bodies[i].shapes[s].geometry;
                if (const auto* box = std::get_if<Box>(&now); box && box->rounding > 0)
                    replace(Box{box->width, box->height, box->center, box->angle, 0});
                if (const auto* polygon = std::get_if<Polygon>(&now)) {
                    const float size = 2 * polygon->vertices[0].length();
                    if (!replace(Box{.width = size, .height = size}) && polygon->rounding > 0)
                        replace(Polygon{polygon->vertices, 0});
                }
                if (const auto* e = std::get_if<Ellipse>(&now))
                    replace(Box{2 * e->radius_x, 2 * e->radius_y, e->center, e->angle, 0});
                if (const auto* concave = std::get_if<Concave>(&now)) drop_vertices(i, s, *concave);
            }
    }
    void drop_vertices(std::size_t body, std::size_t shape, Concave concave) {
        for (std::size_t k = concave.vertices.size(); k-- > 0 && concave.vertices.size() > 3;) {
            Concave fewer = concave;
            fewer.vertices.erase(fewer.vertices.begin() + std::ptrdiff_t(k));
            if (attempt([&](WorldPlan& plan) { plan.bodies[body].shapes[shape].geometry = fewer; }))
                concave = fewer;
        }
    }

    void round_numbers(float per_unit) {
        const auto rounded = [&](float number) { return std::round(number * per_unit) / per_unit; };
        const auto change = [&](const auto& of) {
            const Vec2 now = of(plan_), wanted{rounded(now.x), rounded(now.y)};
            if (now != wanted) attempt([&](WorldPlan& plan) { of(plan) = wanted; });
        };
        const auto change_number = [&](const auto& of) {
            const float wanted = rounded(of(plan_));
            if (of(plan_) != wanted) attempt([&](WorldPlan& plan) { of(plan) = wanted; });
        };
        for (std::size_t i = 0; i < plan_.bodies.size() && budget_ > 0; ++i) {
            change([&](WorldPlan& p) -> Vec2& { return p.bodies[i].def.position; });
            change([&](WorldPlan& p) -> Vec2& { return p.bodies[i].def.velocity; });
            change_number([&](WorldPlan& p) -> float& { return p.bodies[i].def.angle; });
            change_number([&](WorldPlan& p) -> float& { return p.bodies[i].def.angular_velocity; });
            for (std::size_t s = 0; s < plan_.bodies[i].shapes.size(); ++s) {
                if (!std::holds_alternative<Box>(plan_.bodies[i].shapes[s].geometry)) continue;
                const auto box = [&](WorldPlan& p) -> Box& {
                    return std::get<Box>(p.bodies[i].shapes[s].geometry);
                };
                if (rounded(box(plan_).width) > 0)
                    change_number([&](WorldPlan& p) -> float& { return box(p).width; });
                if (rounded(box(plan_).height) > 0)
                    change_number([&](WorldPlan& p) -> float& { return box(p).height; });
            }
        }
    }

    WorldPlan plan_;
    const Fails& fails_;
    /// Remaining budget: steps times bodies, for all calls of `fails` together.
    long long budget_ = 4'000'000;
};

}  // namespace

WorldPlan minimized(WorldPlan plan, const Fails& fails) {
    return Minimizer(std::move(plan), fails).run();
}

}  // namespace fettle::bench::wild
