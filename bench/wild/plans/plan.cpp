#include "wild/plans/plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fettle::bench::wild {

Vec2 Swing::velocity(double time) const {
    const double rate = 2 * std::numbers::pi * hertz;
    return reach * float(rate * std::cos(rate * time));
}

float JointPlan::number(const std::string& setter, float otherwise) const {
    return vector(setter, {otherwise, 0}).x;
}

Vec2 JointPlan::vector(const std::string& setter, const Vec2& otherwise) const {
    const auto found = std::ranges::find(settings, setter, &Setting::setter);
    return found == settings.end() ? otherwise : found->value;
}

void JointPlan::set(const Setting& setting) {
    const auto found = std::ranges::find(settings, setting.setter, &Setting::setter);
    if (found == settings.end())
        settings.push_back(setting);
    else
        found->value = setting.value;
}

bool WorldPlan::edited_at(int step) const {
    return std::ranges::count(edits, step, &Edit::step) > 0 ||
           std::ranges::count(bodies, step, &BodyPlan::born) > 0 ||
           std::ranges::count(joints, step, &JointPlan::born) > 0;
}

int WorldPlan::last_edit() const {
    int last = 0;
    for (const Edit& edit : edits) last = std::max(last, edit.step);
    for (const BodyPlan& body : bodies) last = std::max(last, body.born);
    for (const JointPlan& joint : joints) last = std::max(last, joint.born);
    return last;
}

void WorldPlan::remove_body(int index) {
    for (int i = int(joints.size()) - 1; i >= 0; --i)
        if (joints[std::size_t(i)].a == index || joints[std::size_t(i)].b == index) remove_joint(i);
    const auto of_bodies = [](const Edit& edit) {
        return edit.target == Target::body || edit.target == Target::shape;
    };
    std::erase_if(edits, [&](const Edit& edit) { return of_bodies(edit) && edit.object == index; });
    for (Edit& edit : edits)
        if (of_bodies(edit) && edit.object > index) --edit.object;
    for (JointPlan& joint : joints) {
        if (joint.a > index) --joint.a;
        if (joint.b > index) --joint.b;
    }
    bodies.erase(bodies.begin() + index);
}

void WorldPlan::remove_joint(int index) {
    std::erase_if(edits, [&](const Edit& edit) {
        return edit.target == Target::joint && edit.object == index;
    });
    for (Edit& edit : edits)
        if (edit.target == Target::joint && edit.object > index) --edit.object;
    joints.erase(joints.begin() + index);
}

void WorldPlan::remove_shape(int body, int shape) {
    const auto of_body = [&](const Edit& edit) {
        return edit.target == Target::shape && edit.object == body;
    };
    std::erase_if(edits, [&](const Edit& edit) { return of_body(edit) && edit.shape == shape; });
    for (Edit& edit : edits)
        if (of_body(edit) && edit.shape > shape) --edit.shape;
    auto& shapes = bodies[std::size_t(body)].shapes;
    shapes.erase(shapes.begin() + shape);
}

Vec2 placed(const Vec2& point, const Vec2& origin, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return origin + Vec2(c * point.x - s * point.y, s * point.x + c * point.y);
}

Vec2 local(const Vec2& point, const Vec2& origin, float angle) {
    return placed(point - origin, Vec2{}, -angle);
}

bool may_collide(const ShapeDef& a, const ShapeDef& b) {
    if (a.sensor || b.sensor) return false;
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

}  // namespace fettle::bench::wild
