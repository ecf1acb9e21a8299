#pragma once
// Physics in the property tree: worlds, bodies, shapes and joints are instances. Their properties
// are read from and written to the memory of the physics library. docs/design/hosting-physics.md
// describes how.

#include <functional>
#include <memory>
#include <string>

#include <fettle/module/module.h>
#include <fettle/physics/world.h>
#include <fettle/physics_module/export.h>

namespace fettle::physics_module {
class Hosting;  // not exported
}

FETTLE_PHYSICS_MODULE_BEGIN

namespace fettle::physics_module {

/// Registers the classes World, Body, Shape, Joint and Field and all classes that derive from them,
/// creates `game.world`, and steps every world below the root. Before `attach`, and after the tree
/// is destroyed, methods that need a tree throw std::logic_error. The destructor of a module that
/// ends before the tree deletes all instances of its classes, with everything below them, and ends
/// these classes. Where instances cannot be deleted (in a formula or a lifecycle function, for
/// example), and in a function that a step or a query of a world calls, it cannot refuse, so the
/// program ends (std::terminate).
class PhysicsModule : public module::Module {
  public:
    PhysicsModule();  ///< without a tree: `attach`
    ~PhysicsModule() override;
    PhysicsModule(const PhysicsModule&) = delete;
    PhysicsModule& operator=(const PhysicsModule&) = delete;

    std::string_view name() const override { return "physics"; }  ///< of the module
    /// Throws std::logic_error if the module was attached before, and Error(bad_name) if the tree
    /// already has a class, a child `world` of the root or a part of snapshots with a name that the
    /// module needs. Then nothing has changed, and the module is not attached. A tree takes physics
    /// once only: the classes of a module that has ended stay in the tree, without instances.
    void attach(property::Tree& tree) override;
    /// Throws std::invalid_argument unless `dt` (s) is at least 0 and in the range of a float.
    void step(double dt) override;
    /// Throws std::invalid_argument for another tree than the one it was attached to.
    void report(property::Tree& tree) override;
    /// Hash of the only world below the root. If there are several, their hashes are combined in
    /// the order of their numbers; the number of a deleted world is used again.
    std::uint64_t hash() const override;
    /// Makes an update of physics that a recording contains: `World::refresh`.
    void refresh(std::uint64_t what) override;

    /// `listener` is called with a message about objects that have no effect, once for each kind:
    /// bodies, fields and joints below no world, shapes on no body, joints that connect nothing.
    /// Also about joints with a lower limit above the upper one, when they are placed and when a
    /// limit is set.
    void on_problem(std::function<void(const std::string&)> listener);

    /// Saves every world, bit for bit.
    property::Memory save(property::ByteWriter& to) const override;
    /// Reads the bytes that `save` wrote, and returns the function that applies them.
    std::function<void()> restore(property::ByteReader& from,
                                  const property::Memory& memory) override;

    // Objects of the library that instances represent, for C++ code that works without the tree. A
    // result is valid until the instance is deleted or moved to another world, or a snapshot is
    // restored. Throws property::Error for a deleted instance or one of another class.
    //
    // Only the tree creates and destroys objects in these worlds. So creating and destroying
    // bodies, shapes, joints and fields, attaching a shape to another body, giving a shape another
    // type of geometry or a field another type of force (the class of the instance says which it
    // is), `clear`, `restore`, `take`, assigning a world and `set_user_data` throw physics::Locked
    // (physics/owner.h). All other methods may be called except `World::set_owner`, which the
    // module uses, and, while a handler listens, the setters of the world's callbacks. Handlers
    // run on the thread that steps, also after `World::set_parallel_callbacks(true)`. An instance
    // that is deleted inside a function that its world calls is removed from the tree at once, and
    // from the world at the end of that step or query.

    /// The world of a World instance. For any other instance, the nearest world above it; if there
    /// is none, the world that contains all objects without a world.
    physics::World& world(property::Handle instance);
    physics::Body body(property::Handle instance);    ///< of an instance of Body
    physics::Shape shape(property::Handle instance);  ///< of an instance of Shape

    /// The instance of an object; the null handle if it has none (a world's border).
    property::Handle handle(const physics::Body& body) const;
    property::Handle handle(const physics::Shape& shape) const;

  private:
    Hosting& hosting() const;

    std::unique_ptr<Hosting> hosting_;
};

}  // namespace fettle::physics_module

FETTLE_PHYSICS_MODULE_END
