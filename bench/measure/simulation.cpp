#include "measure/simulation.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "measure/timing.h"
#include "report/table.h"

namespace fettle::bench {

void measured_steps(Engine& engine, int steps) {
    for (int i = 0; i < steps; ++i) engine.step();
}

Simulation::Simulation(const Scene& scene, const EngineKind& kind)
    : Simulation(scene, std::string(kind.name), kind.make(scene)) {}

Simulation::Simulation(const Scene& scene, std::string name, std::unique_ptr<Engine> engine)
    : scene_(scene), name_(std::move(name)), engine_(std::move(engine)) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].path) driven_.push_back(i);
    }
    has_joint_.resize(scene.bodies.size(), false);
    for (const SceneJoint& joint : scene.joints)
        has_joint_[joint.body_a] = has_joint_[joint.body_b] = true;
}

StepTime Simulation::advance(int steps) {
    StepTime time;
    const int half = scene_.steps / 2;
    const int before = std::clamp(half - steps_, 0, steps);
    if (before > 0) time += timed_steps(before);
    if (before == steps) return time;
    const int target = steps_ - before + steps;
    if (steps_ == half) time += edited_step();
    const int rest = target - steps_;
    if (rest > 0) time += timed_steps(rest);
    return time;
}

StepTime Simulation::timed_steps(int steps) {
    const WallClock wall;
    const ThreadClock thread;
    make_steps(steps);
    return {wall.elapsed_ms(), thread.elapsed_ms()};
}

void Simulation::make_steps(int steps) {
    if (driven_.empty() && scene_.arrivals.empty()) {
        measured_steps(*engine_, steps);
        steps_ += steps;
        return;
    }
    for (int i = 0; i < steps; ++i) {
        const double end = static_cast<double>(steps_ + 1) * static_cast<double>(time_step);
        for (const std::size_t body : driven_) {
            const Point target = scene_.bodies[body].path(end);
            const Point from = engine_->motion(body).position;
            engine_->set_velocity(
                body, {(target.x - from.x) / time_step, (target.y - from.y) / time_step});
        }
        while (arrived_ < scene_.arrivals.size() && scene_.arrivals[arrived_].step <= steps_) {
            const std::size_t group = scene_.arrivals[arrived_++].group;
            engine_->replace_group(group, scene_.groups[group]);
        }
        measured_steps(*engine_, 1);
        ++steps_;
    }
}

std::size_t Simulation::topmost(bool free, float below) const {
    std::size_t top = scene_.bodies.size();
    float height = 0;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        if (scene_.bodies[i].motion != Motion::dynamic || (free && has_joint_[i])) continue;
        const float y = engine_->motion(i).position.y;
        if (y < below && (top == scene_.bodies.size() || y > height)) {
            top = i;
            height = y;
        }
    }
    return top;
}

StepTime Simulation::edited_step() {
    if (!scene_.groups.empty()) return timed_steps(1);  // the bodies outside groups do not move
    constexpr float any_height = std::numeric_limits<float>::max();
    std::size_t body = topmost(true, any_height);
    const bool held = body == scene_.bodies.size();
    if (held) body = topmost(false, any_height);
    // A body under a ceiling cannot move up, but then it can move down. If other bodies hit it in
    // this step, their impulses may hide the effect of the edit; then the next body is tried.
    constexpr int most_tried = 20;
    StepTime time;
    float moved = 0;
    for (int tried = 0; tried < most_tried && body != scene_.bodies.size(); ++tried) {
        for (const float push : {1.0f, -1.0f}) {  // m/s
            const BodyMotion before = engine_->motion(body);
            engine_->edit_velocity(body, {before.velocity.x, before.velocity.y + push});
            time += timed_steps(1);
            const float alone = (before.velocity.y + scene_.gravity.y * time_step) * time_step;
            moved = engine_->motion(body).position.y - before.position.y - alone;
            if (held || moved * push > 0.5f * push * push * time_step) return time;
        }
        body = topmost(true, engine_->motion(body).position.y);
    }
    throw std::runtime_error(scene_.name + " in " + name_ +
                             ": an edit of a body's velocity in mid-run had no effect: it moved " +
                             figure(static_cast<double>(moved)) + " m more than without");
}

}  // namespace fettle::bench
