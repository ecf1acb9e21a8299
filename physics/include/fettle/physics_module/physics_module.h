#pragma once
// Physics in the property tree: worlds, bodies, shapes and joints are instances whose properties
// are read from and written to the memory the physics library computes with.
// docs/design/hosting-physics.md tells how.

#include <memory>

#include <fettle/module/module.h>
#include <fettle/physics/world.h>
#include <fettle/physics_module/export.h>

FETTLE_PHYSICS_MODULE_BEGIN

namespace fettle::physics_module {

class FETTLE_PHYSICS_MODULE_PRIVATE Hosting;

/// Registers the classes World, Body, Shape, Joint and Field with all that derive from them,
/// creates `game.world`, and steps every world that hangs below the root. Before `attach` whatever
/// needs a tree throws std::logic_error; when that tree is gone, nothing but the destructor is
/// left.
class PhysicsModule : public module::Module {
  public:
    PhysicsModule();
    ~PhysicsModule() override;
    PhysicsModule(const PhysicsModule&) = delete;
    PhysicsModule& operator=(const PhysicsModule&) = delete;

    std::string_view name() const override { return "physics"; }
    /// Throws std::logic_error when it was attached before, and Error(bad_name) where the tree has
    /// a class, a child `world` of the root or a part of snapshots of a name that it needs: nothing
    /// has changed then, and it is attached to nothing.
    void attach(property::Tree& tree) override;
    /// Throws std::invalid_argument unless `dt` is a time, at least 0.
    void step(double dt) override;
    /// Throws std::invalid_argument for another tree than the one it was attached to.
    void report(property::Tree& tree) override;
    /// Of the worlds below the root: that of the only one, else all combined in the order of their
    /// numbers, which are given again when a world is deleted.
    std::uint64_t hash() const override;
    void refresh(std::uint64_t what) override;

    /// Every world, bit for bit.
    property::Memory save(property::ByteWriter& to) const override;
    std::function<void()> restore(property::ByteReader& from,
                                  const property::Memory& memory) override;

    // From an instance to what it stands for, for C++ that wants to go on without the tree. What is
    // returned is good until the instance is deleted or moved to another world, or a snapshot is
    // restored. Throws property::Error for a deleted instance or one of another class.
    //
    // What is in these worlds comes and goes by the tree alone: creating and destroying bodies,
    // shapes, joints and fields, tying a shape to another body, `clear`, `restore`, `take`,
    // assigning a world and `set_user_data` throw physics::Locked (physics/owner.h). Everything
    // else may be called but `World::set_owner`, which is the module's; so are the worlds'
    // callbacks while a handler listens. An instance that is deleted inside a function that its
    // world calls is gone from the tree at once, and from the world when that step or query is
    // over.

    /// The world of a World instance; for any other the nearest above it, and where there is none
    /// the one of all that is in no world.
    physics::World& world(property::Handle instance);
    physics::Body body(property::Handle instance);
    physics::Shape shape(property::Handle instance);

    /// And back; the null handle for what no instance stands for (a world's border).
    property::Handle handle(const physics::Body& body) const;
    property::Handle handle(const physics::Shape& shape) const;

  private:
    Hosting& hosting() const;

    std::unique_ptr<Hosting> hosting_;
};

}  // namespace fettle::physics_module

FETTLE_PHYSICS_MODULE_END
