#pragma once
// A scene in the property tree, run by the same loop as `fettle run`.

#include <fettle/app/loop.h>
#include <fettle/app/services.h>
#include <fettle/physics_module/physics_module.h>
#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

#include <cstdint>
#include <vector>

#include "engines/engine.h"

namespace fettle::bench {

/// All components of a headless `fettle run`, created in the same order. Its game is empty.
struct HeadlessGame {
    HeadlessGame();

    physics_module::PhysicsModule physics;
    property::Tree tree;
    app::Services services;
    script::Runtime runtime;
    app::Loop loop;

  private:
    property::Tree& with_physics();
};

class HostedEngine : public Engine {
  public:
    /// `keeps_past`: stores the past for rewinding, as games do by default.
    explicit HostedEngine(const Scene& scene, bool keeps_past = true);

    /// Barrier, update, barrier, timers, step, barrier, modules, barrier.
    void step() override;
    BodyMotion motion(std::size_t body) const override;
    void set_velocity(std::size_t body, Point velocity) override;
    /// By path, as typed into a console.
    void edit_velocity(std::size_t body, Point velocity) override;
    void set_threads(int threads) override;
    void mix_groups(std::uint64_t& hash) const override;
    void replace_group(std::size_t group, const SceneGroup& description) override;
    std::size_t contacts() const override;
    std::size_t bodies() const override;

    /// Watches the positions of that share of the bodies, 0 to 1, with a handler that counts.
    void watch_positions(double share);
    std::uint64_t changes_seen() const { return changes_seen_; }

    HeadlessGame& game() { return game_; }
    property::Handle handle(std::size_t body) const { return bodies_[body]; }

  private:
    BodyMotion motion_of(property::Handle body) const;
    property::Handle make(const SceneBody& description);
    void add_joint(const std::vector<property::Handle>& bodies,
                   const std::vector<SceneBody>& described, const SceneJoint& joint);

    mutable HeadlessGame game_;
    property::Handle world_;
    std::vector<property::Handle> bodies_;
    struct Group {
        property::Handle node;
        std::vector<property::Handle> bodies;
    };
    std::vector<Group> groups_;
    const property::Property* position_;
    const property::Property* angle_;
    const property::Property* velocity_;
    const property::Property* angular_velocity_;
    std::uint64_t changes_seen_ = 0;
};

}  // namespace fettle::bench
