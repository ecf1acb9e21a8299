#include <hosting/written_poses.h>

#include <fettle/physics/host_access.h>

namespace fettle::physics_module {

namespace {

property::Placement placement_of(const physics::World& world, std::uint32_t body) {
    const physics::BodyState& state = physics::HostAccess::state(world, body);
    return {
        .position = {static_cast<double>(state.position.x), static_cast<double>(state.position.y)},
        .angle = static_cast<double>(state.angle)};
}

}  // namespace

void WrittenPoses::add(const physics::World& world, std::uint32_t body) {
    if (!steps_.running) {
        written_.erase(body);
        return;
    }
    forget_earlier();
    Written& written = written_[body];
    if (written.step == steps_.begun) return;  // its pose before the step is known
    if (written.step + 1 != steps_.begun) written.track = {};
    written.track.step_begins(placement_of(world, body));
    written.step = steps_.begun;
}

void WrittenPoses::note_new(std::uint32_t body) {
    if (steps_.running) {
        forget_earlier();
        written_[body] = {.track = {}, .step = steps_.begun};
    } else {
        written_.erase(body);
    }
}

/// The step before is kept: a track needs the motion in it, to tell jumps.
void WrittenPoses::forget_earlier() {
    if (newest_ == steps_.begun) return;
    newest_ = steps_.begun;
    std::erase_if(written_, [&](const auto& each) { return each.second.step + 1 < newest_; });
}

std::optional<property::Placement> WrittenPoses::drawn_between(const physics::World& world,
                                                               std::uint32_t body,
                                                               double alpha) const {
    const auto found = written_.find(body);
    if (found == written_.end() || found->second.step != steps_.begun) return {};
    const property::Placement now = placement_of(world, body);
    property::Track track = found->second.track;
    track.step_ended(now);
    return track.drawn(now, alpha, steps_.far.world);
}

}  // namespace fettle::physics_module
