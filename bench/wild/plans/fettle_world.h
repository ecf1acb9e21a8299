#pragma once
// A plan in the library.

#include <cstddef>
#include <span>

#include "wild/plans/running_world.h"

namespace fettle::bench::wild {

class FettleWorld : public RunningWorld {
  public:
    explicit FettleWorld(const WorldPlan& plan);
    /// The same moment of `other`, in a world that is a copy.
    FettleWorld(const FettleWorld& other);

    void prepare(int step) override;
    void advance(float dt) override { world_.step(dt); }
    void read(std::vector<BodyNow>& bodies) const override;
    World* fettle() override { return &world_; }
    const World& world() const { return world_; }
    /// From now on the world is read after each edit, which must not change what happens.
    void read_after_edits() { reads_ = true; }

    /// A world that is restored from the bytes of this one.
    std::unique_ptr<FettleWorld> restored() const;

  private:
    FettleWorld(const FettleWorld& other, std::span<const std::byte> bytes);
    void make_body(std::size_t index);
    void make_joint(std::size_t index);
    void edit(const Edit& edit);
    Body body(int index) { return world_.body(ids_of_bodies_[std::size_t(index)]); }

    const WorldPlan& plan_;
    World world_;
    std::vector<BodyId> ids_of_bodies_;
    std::vector<std::vector<ShapeId>> ids_of_shapes_;
    std::vector<JointId> ids_of_joints_;
    double time_ = 0;
    bool reads_ = false;
};

}  // namespace fettle::bench::wild
