#pragma once
// Poses of bodies that scripts, tweens and formulas write in a step. Such a body is drawn between
// its poses before and after the step, as other instances are (property/between_steps.h). For the
// physics library, each write of a pose is a jump.

#include <cstdint>
#include <optional>
#include <unordered_map>

#include <fettle/physics/world.h>
#include <fettle/property/between_steps.h>

namespace fettle::physics_module {

class WrittenPoses {
  public:
    explicit WrittenPoses(const property::NotedSteps& steps) : steps_(steps) {}

    /// To be called before the pose of a body of the world is written. A write outside of steps is
    /// drawn at once.
    void note(const physics::World& world, std::uint32_t body) {
        if (steps_.running || !written_.empty()) [[unlikely]]
            add(world, body);
    }
    /// To be called for a new body: it is not drawn on its way to its first place.
    void note_new(std::uint32_t body);
    void clear() { written_.clear(); }
    /// Where a body is drawn whose pose was written in the last step.
    std::optional<property::Placement> drawn(const physics::World& world, std::uint32_t body,
                                             double alpha) const {
        if (written_.empty()) [[likely]]
            return {};
        return drawn_between(world, body, alpha);
    }

  private:
    struct Written {
        property::Track track;
        std::uint64_t step = 0;  // the last one in which the pose was written
    };
    void add(const physics::World& world, std::uint32_t body);
    std::optional<property::Placement> drawn_between(const physics::World& world,
                                                     std::uint32_t body, double alpha) const;
    void forget_earlier();

    const property::NotedSteps& steps_;
    std::unordered_map<std::uint32_t, Written> written_;  // by slot of the body
    std::uint64_t newest_ = 0;                            // the last step with a write
};

}  // namespace fettle::physics_module
