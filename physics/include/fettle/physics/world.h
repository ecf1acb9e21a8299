#pragma once

#include <fettle/physics/body.h>
#include <fettle/physics/callbacks.h>
#include <fettle/physics/coupling_joints.h>
#include <fettle/physics/events.h>
#include <fettle/physics/export.h>
#include <fettle/physics/field.h>
#include <fettle/physics/locked.h>
#include <fettle/physics/owner.h>
#include <fettle/physics/query.h>
#include <fettle/physics/shape.h>
#include <fettle/physics/sliding_joints.h>
#include <fettle/physics/statistics.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

namespace detail {
struct FETTLE_PHYSICS_PRIVATE WorldData;
struct FETTLE_PHYSICS_PRIVATE WorldLink;
struct WorldInside;  ///< of the library's own tests

/// The part of a world that is read too often for a call: arrays addressed by `BodyId::index`.
struct Columns {
    std::vector<BodyState> states;
    std::vector<Pose> previous;
    std::vector<uint32_t> body_generations;   ///< 0 where a slot is free
    std::vector<uint32_t> shape_generations;  ///< by `ShapeId::index`
    std::vector<uint32_t> joint_generations;  ///< by `JointId::index`

    bool is_valid(BodyId id) const { return lives(body_generations, id.index, id.generation); }
    bool is_valid(ShapeId id) const { return lives(shape_generations, id.index, id.generation); }
    bool is_valid(JointId id) const { return lives(joint_generations, id.index, id.generation); }

  private:
    static bool lives(const std::vector<uint32_t>& generations, uint32_t index,
                      uint32_t generation) {
        return generation != 0 && index < generations.size() && generations[index] == generation;
    }
};
}  // namespace detail

/// What became of a number or a velocity written by slot: it was there already; it is there now; or
/// it is for the setter of `Body`, and nothing was done: the body sleeps, does not move by itself,
/// its mass or shapes were edited since the last step, or the world is locked (callbacks.h).
/// Writing calls no callback and allocates nothing.
enum class Written : uint8_t { same, done, refused };

/// Numbers of a body that hosts write by slot, as the setters of `Body` of the same names do; those
/// tell what is in range, and here nobody looks.
enum class BodyNumber : uint8_t {
    angular_velocity,
    torque,
    gravity_scale,
    linear_damping,
    angular_damping
};

/// A world of rigid bodies. It owns everything; `Body`, `Shape`, `Joint` and `Field` are handles
/// into it, and say so when they outlive it. It does not move: `World b = std::move(a)` copies.
///
/// Different worlds are independent, in several threads too. One world belongs to one thread at a
/// time; but several threads may call what is `const` at once while no other method of the world or
/// of its bodies runs, if nothing was edited since the last step or since `refresh({})`.
///
/// Methods that are not `const` throw `Locked` inside a function that the world is calling, and so
/// do copying, saving and `validate` inside a step: callbacks.h says what such a function may do.
///
///     World world;
///     Body ground = world.create_body({.type = BodyType::static_body});
///     ground.add(Box{.width = 20, .height = 1});
///     Body crate = world.create_body({.position = {0, 5}});
///     crate.add(Box{});
///     for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
///     std::cout << crate.position().y();
class World {
  public:
    explicit World(const WorldDef& def = {});
    /// Inside a function that the world is calling: the step or the query goes on to its end and
    /// throws `Locked` then, and handles say that their world was destroyed.
    ~World();
    /// A copy is a snapshot: same ids, same future, bit for bit; what either makes from then on has
    /// ids of its own. Handles keep pointing into the world they came from. Assigning one restores:
    /// handles that were valid then are valid again, and what was made since stays invalid for
    /// ever.
    World(const World& other);
    World& operator=(const World& other);

    /// Appends everything the world is to `out`, in the byte order and layout of this build, with a
    /// checksum.
    void save(std::vector<std::byte>& out) const;
    /// The state `save` wrote, in place: as an assignment. Throws std::invalid_argument when a byte
    /// was changed, cut off or added, or when another version wrote them, and changes nothing then.
    void restore(std::span<const std::byte> bytes);
    /// The state of `other`, in place, as `restore`; `other` is an empty world afterwards.
    void take(World&& other);

    /// Advances by `dt` seconds (0 < dt, else nothing happens). Throws on no state, and nothing but
    /// what a callback throws: when the step is over, see callbacks.h.
    void step(float dt);

    Vec2 gravity() const;
    void set_gravity(const Vec2& gravity);  ///< wakes all
    int substeps() const;
    void set_substeps(int substeps);  ///< 1 … 64
    const std::optional<Aabb>& bounds() const;
    void set_bounds(const std::optional<Aabb>& bounds);  ///< wakes all
    float bounds_friction() const;
    void set_bounds_friction(float friction);
    float bounds_restitution() const;
    void set_bounds_restitution(float restitution);
    bool sleeping() const;
    void set_sleeping(bool enabled);  ///< false wakes all
    bool continuous() const;
    void set_continuous(bool enabled);
    float restitution_threshold() const;
    void set_restitution_threshold(float speed);
    float hit_threshold() const;
    void set_hit_threshold(float speed);
    float sleep_speed() const;
    void set_sleep_speed(float speed);
    float sleep_delay() const;
    void set_sleep_delay(float seconds);
    float contact_hertz() const;
    void set_contact_hertz(float hertz);
    float contact_damping() const;
    void set_contact_damping(float ratio);
    float push_speed() const;
    void set_push_speed(float speed);
    Solver solver() const;
    void set_solver(Solver solver);  ///< wakes all
    MixRule friction_mix() const;
    void set_friction_mix(MixRule rule);  ///< wakes all
    MixRule restitution_mix() const;
    void set_restitution_mix(MixRule rule);  ///< wakes all
    bool persist_events() const;
    void set_persist_events(bool enabled);
    void wake_all();
    /// Numbers that are computed at a time, at most: 4, 8 or 16, and no more than `simd_width`.
    /// Fewer are slower and give the same bits: for comparisons. Throws for any other number.
    void limit_simd_width(int most);

    /// How many threads a step is shared out to, the caller's included: 1 … 64. It belongs to the
    /// world and not to its state, and changes no result. Throws std::runtime_error where the
    /// system gives fewer, and leaves as many as there were. Of more than there are processors,
    /// only as many work as there are. Callbacks run on the caller's thread.
    int threads() const;
    void set_threads(int threads);

    // Callbacks; empty: none, which costs nothing. They are no part of a snapshot: copying, saving
    // and restoring leave those of the world as they are, a new copy has none. What they may do is
    // told in callbacks.h.

    /// Asked of every pair of shapes that comes near, in a step or when an edit of a shape's filter
    /// asks anew; setting it asks of all pairs again. What sleeps hears of the next two when it
    /// wakes.
    void set_filter(PairFilter filter);
    /// Mixes the surfaces of every contact in every step, after the rules have. May write friction,
    /// restitution and surface speed. Asked for each part of an outline that touches.
    void set_mixing(ContactCallback mix);
    /// Sees every contact before it is solved, once for two shapes, and may also disable it for the
    /// step.
    void set_before_solve(ContactCallback callback);

    /// Called before a read brings up to date what edits have left behind. When that happens is
    /// part of what comes later, to the last bit: who wants to do edits again exactly does this
    /// again between them, by `refresh`. Reads within a step or within the callback are no news.
    void on_refresh(RefreshCallback callback);
    /// As a read would do; nothing where nothing is out of date, or nobody is in the slot.
    void refresh(const Refresh& wanted);

    /// Who alone makes and ends what is in the world from now on; null: anybody. As callbacks, it
    /// is no part of the state: copying, saving and restoring leave it as it is, a copy has none.
    void set_owner(const Owner* owner);

    Body create_body(const BodyDef& def = {});
    Shape create_shape(const Geometry& geometry, const ShapeDef& def = {});  ///< detached
    MouseJoint create_mouse_joint(const MouseJointDef& def);
    DistanceJoint create_distance_joint(const JointDef& def);    ///< a rod as long as it is now
    RevoluteJoint create_revolute_joint(const JointDef& def);    ///< the angle now counts as 0
    PrismaticJoint create_prismatic_joint(const JointDef& def);  ///< holds the angle it has now
    WheelJoint create_wheel_joint(const JointDef& def);
    WeldJoint create_weld_joint(const JointDef& def);      ///< holds the angle it has now
    MotorJoint create_motor_joint(const JointDef& def);    ///< the angle now is its offset
    PulleyJoint create_pulley_joint(const JointDef& def);  ///< set its wheels, then its length
    GearJoint create_gear_joint(const JointDef& def);      ///< set its ratio, then its phase
    GrooveJoint create_groove_joint(const JointDef& def);
    PinSlotJoint create_pin_slot_joint(const JointDef& def);
    RatchetJoint create_ratchet_joint(const JointDef& def);  ///< the angle now counts as 0
    Field create_field(const FieldDef& def);
    bool is_valid(FieldId id) const;
    Field field(FieldId id) const { return {self(), id}; }
    std::vector<Field> fields() const;  ///< in slot order
    void clear();                       ///< destroys every body, shape, joint and field

    bool is_valid(BodyId id) const { return columns_->is_valid(id); }
    bool is_valid(ShapeId id) const { return columns_->is_valid(id); }
    bool is_valid(JointId id) const { return columns_->is_valid(id); }
    Body body(BodyId id) const { return {self(), id}; }
    Shape shape(ShapeId id) const { return {self(), id}; }
    /// As the type it is, or as any joint: `joint<WheelJoint>(id)`.
    template <class Any = Joint>
    Any joint(JointId id) const {
        return {self(), id};
    }

    // Unchecked, for hosts that keep slots: `index` must be that of a live body. A reference holds
    // until the next creation of a body.
    const BodyState& state(uint32_t index) const { return columns_->states[index]; }
    float mass(uint32_t index) const;
    Vec2 velocity(uint32_t index) const;
    /// False, and nothing is done, when the body does not move by itself.
    bool set_velocity(uint32_t index, const Vec2& velocity);
    template <BodyNumber number>
    Written write(uint32_t index, float value);
    Written write_velocity(uint32_t index, const Vec2& velocity);
    const Pose& previous(uint32_t index) const { return columns_->previous[index]; }
    std::span<const BodyState> states() const { return columns_->states; }
    /// Generation of what lives in a slot, 0 where nothing does. Slots 0 … `body_slots()`-1; slot 0
    /// is the world's own.
    uint32_t body_generation(uint32_t index) const { return columns_->body_generations[index]; }
    uint32_t shape_generation(uint32_t index) const { return columns_->shape_generations[index]; }
    uint32_t body_slots() const { return uint32_t(columns_->body_generations.size()); }
    uint32_t shape_slots() const { return uint32_t(columns_->shape_generations.size()); }

    // Everything alive, in slot order. The border of the world is not listed.
    std::vector<Body> bodies() const;
    std::vector<Shape> shapes() const;
    std::vector<Joint> joints() const;
    std::vector<Contact> contacts() const;  ///< touching ones, sleeping ones too
    uint32_t body_count() const;
    /// Whether it is in the middle of a step, a query or an edit that calls a function of yours:
    /// what would edit it throws Locked.
    bool locked() const;
    uint32_t shape_count() const;
    uint32_t joint_count() const;

    const Events& events() const;  ///< of the last step
    const StepStatistics& statistics() const;
    /// What the world has on the heap, by purpose, but for callbacks and threads. What a step needs
    /// and can make anew is given back when most of what was awake sleeps.
    std::vector<MemoryShare> memory() const;
    /// Of position, angle and velocities of all bodies, in slot order: equal for equal histories.
    uint64_t hash() const;

    // Queries see every edit made before them. Shapes come in a repeatable order. What
    // `QueryFilter::accept` throws leaves the query at once; the world is as it was.
    std::vector<Shape> query_point(const Vec2& point, const QueryFilter& filter = {}) const;
    std::vector<Shape> query_aabb(
        const Aabb& box, const QueryFilter& filter = {}) const;  ///< shapes that overlap the box
    std::optional<RayHit> cast_ray(const Vec2& from, const Vec2& to,
                                   const QueryFilter& filter = {}) const;
    std::vector<RayHit> cast_ray_all(const Vec2& from, const Vec2& to,
                                     const QueryFilter& filter = {}) const;  ///< nearest first
    /// Shapes that overlap one, which may be of another world; those of its own body do not count.
    std::vector<Shape> query_overlap(const Shape& shape, const QueryFilter& filter = {}) const;
    std::vector<Shape> query_overlap(const Geometry& geometry, const Pose& pose = {},
                                     const QueryFilter& filter = {}) const;
    /// The first shape that one meets on its way; at fraction 0 where they overlap already.
    std::optional<RayHit> cast_shape(const Shape& shape, const Vec2& motion,
                                     const QueryFilter& filter = {}) const;
    std::optional<RayHit> cast_shape(const Geometry& geometry, const Pose& pose, const Vec2& motion,
                                     const QueryFilter& filter = {}) const;
    /// The shape nearest to a point, no farther than `reach` (m). The border does not count.
    std::optional<PointHit> closest(const Vec2& point, float reach = infinity,
                                    const QueryFilter& filter = {}) const;
    /// Pushes dynamic bodies away from a point: by `impulse` (N s) at it, falling linearly to
    /// nothing at `radius` (m), at the point of the body that is nearest.
    void explode(const Vec2& point, float radius, float impulse, const QueryFilter& filter = {});

    /// Checks that the broad phase, contacts, islands and lists agree with each other; the first
    /// disagreement in words, or nothing. For tests and for hunting bugs: slow.
    std::optional<std::string> validate() const;

  private:
    friend class Body;
    friend class Shape;
    friend class Joint;
    friend class Field;
    friend struct detail::WorldInside;
    void begin();
    World* self() const { return const_cast<World*>(this); }  ///< handles are not const
    /// For what edits: throws Locked where nothing may be edited.
    detail::WorldData& edit(const char* function) const;
    /// For what makes or ends objects: throws Locked where the world has an owner, too.
    detail::WorldData& populate(const char* function) const;

    std::unique_ptr<detail::WorldData> data_;
    detail::Columns* columns_ = nullptr;  ///< base of `*data_`
    detail::WorldLink* link_ = nullptr;   ///< what handles hold
};

inline Body::Body(World* world, BodyId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}
inline Shape::Shape(World* world, ShapeId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}
inline Joint::Joint(World* world, JointId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}
inline Field::Field(World* world, FieldId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}

template <>
Written World::write<BodyNumber::angular_velocity>(uint32_t index, float value);
template <>
Written World::write<BodyNumber::torque>(uint32_t index, float value);
template <>
Written World::write<BodyNumber::gravity_scale>(uint32_t index, float value);
template <>
Written World::write<BodyNumber::linear_damping>(uint32_t index, float value);
template <>
Written World::write<BodyNumber::angular_damping>(uint32_t index, float value);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
