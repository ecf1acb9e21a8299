#pragma once

#include <fettle/physics/account.h>
#include <fettle/physics/body.h>
#include <fettle/physics/callbacks.h>
#include <fettle/physics/columns.h>
#include <fettle/physics/coupling_joints.h>
#include <fettle/physics/damaged.h>
#include <fettle/physics/debug_draw.h>
#include <fettle/physics/events.h>
#include <fettle/physics/export.h>
#include <fettle/physics/field.h>
#include <fettle/physics/function.h>
#include <fettle/physics/geometry.h>
#include <fettle/physics/joint_definitions.h>
#include <fettle/physics/locked.h>
#include <fettle/physics/owned.h>
#include <fettle/physics/owner.h>
#include <fettle/physics/query.h>
#include <fettle/physics/scheduler.h>
#include <fettle/physics/shape.h>
#include <fettle/physics/sliding_joints.h>
#include <fettle/physics/statistics.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

namespace detail {
struct FETTLE_PHYSICS_PRIVATE WorldData;
struct FETTLE_PHYSICS_PRIVATE WorldLink;
class FETTLE_PHYSICS_PRIVATE WorldLock;
struct WorldInside;  ///< defined in the tests of the library
struct FETTLE_PHYSICS_PRIVATE MoverWorld;
}  // namespace detail

/// Numbers of objects for which `World::reserve` reserves memory.
struct Capacity {
    uint32_t bodies = 0;    ///< of all types
    uint32_t shapes = 0;    ///< each segment of a chain and each convex part counts as a shape, too
    uint32_t contacts = 0;  ///< pairs of shapes near each other
    uint32_t joints = 0;    ///< dormant ones, too
};

/// A world of rigid bodies. It owns all its objects; `Body`, `Shape`, `Joint` and `Field` are
/// handles to them, which throw if they outlive the world. A world is copied by `clone` only;
/// moving it moves all that it has, and its handles refer to it at its new place.
///
/// Different worlds are independent, also in several threads. Only one thread at a time may use a
/// world; but several threads may call `const` methods at once, except `after_step` and `validate`,
/// while no other method of the world or of its objects runs, if nothing was edited since the last
/// step or since `refresh`.
///
/// Methods that are not `const` throw `Locked` inside a function that the world is calling. So do
/// copying, saving and `validate` inside a step: callbacks.h describes what such a function may do.
///
/// Without enough memory, methods throw std::bad_alloc. If creating a body or a shape (but not a
/// chain or a concave polygon), a query, copying or restoring fails so, nothing has changed. Any
/// other edit, or a step, may have been made in part: then the world is damaged, and its methods
/// throw `Damaged` (damaged.h) until it gets another state.
///
///     World world;
///     Body ground = world.create_body({.type = BodyType::static_body});
///     ground.add(Box{.width = 20, .height = 1});
///     Body crate = world.create_body({.position = {0, 5}});
///     crate.add(Box{});
///     for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
///     std::cout << crate.position().y;
class World {
  public:
    /// An empty world. Throws std::invalid_argument for a value out of its range.
    explicit World(const WorldDef& def = {});
    /// Inside a callback: the step or the query continues to its end and then throws `Locked`, and
    /// handles report that their world was destroyed.
    ~World();
    /// Moves everything: objects, callbacks, owner and threads. Handles to objects of `other` are
    /// handles of this world then, and `other` is an empty world with the default settings.
    World(World&& other);  // NOLINT: makes an empty world, and so allocates
    /// The same. The world that was here before is destroyed with its objects.
    World& operator=(World&& other);          // NOLINT: the same
    World& operator=(const World&) = delete;  ///< use `clone` or `restore`

    /// A copy: a snapshot with the same ids, whose future steps have the same results, bit for bit.
    /// It has no callbacks, owner and threads. Objects that either world creates from then on have
    /// different ids. Handles keep referring to their original world.
    [[nodiscard]] World clone() const;
    /// Takes the state of a copy, in place: handles that were valid at the time of the copy are
    /// valid again, and handles to later objects stay invalid forever.
    void restore(const World& other);

    /// Appends the complete state of the world to `out`, with a checksum. The bytes are the same on
    /// every machine and for every compiler, but for the precision of positions.
    void save(std::vector<std::byte>& out) const;
    /// Restores the state that `save` wrote, in place, like that of a copy. Throws
    /// std::invalid_argument and changes nothing if a byte was changed, removed or added, or if
    /// another version, or one with the other precision of positions, wrote the state.
    void restore(std::span<const std::byte> bytes);
    /// Takes the state of `other`, in place, like `restore`: handles to objects of `other` become
    /// invalid. `other` is an empty world afterwards.
    void take(World&& other);

    /// Advances by `dt` seconds; does nothing unless dt > 0. Throws only the exceptions of
    /// callbacks and of functions given to `after_step`, after the step: see callbacks.h; and
    /// std::bad_alloc.
    void step(float dt);
    /// Calls `act` once, when the running step has ended; outside of a step: after the next one. It
    /// may edit the world, so a callback can order an edit by it. Functions are called in the order
    /// in which they were given; all are called even if one throws. One may also destroy the world;
    /// the functions after it are not called then. They belong to the world, and not to its state.
    /// An empty function is ignored.
    void after_step(Function<void()> act) const;

    Vec2 gravity() const;                   ///< m/s²
    void set_gravity(const Vec2& gravity);  ///< wakes all
    int substeps() const;                   ///< solver sub-steps per step of up to 1/60 s
    void set_substeps(int substeps);        ///< 1 … 64
    /// The number of sub-steps of the last step: more than `substeps` if it was longer than 1/60 s,
    /// or much longer than the one before it; 0 before the first step.
    int last_substeps() const;
    const std::optional<Aabb>& bounds()
        const;  ///< walls that keep dynamic bodies inside; none: open
    void set_bounds(const std::optional<Aabb>& bounds);  ///< wakes all
    float bounds_friction() const;                       ///< of these walls, at least 0
    void set_bounds_friction(float friction);
    float bounds_restitution() const;  ///< of these walls, 0 … 1
    void set_bounds_restitution(float restitution);
    bool sleeping() const;            ///< whether resting islands fall asleep
    void set_sleeping(bool enabled);  ///< false wakes all
    bool continuous() const;          ///< whether fast bodies do not pass through static ones
    void set_continuous(bool enabled);
    float restitution_threshold() const;  ///< m/s, at least 0: slower impacts do not bounce
    void set_restitution_threshold(float speed);
    float hit_threshold() const;  ///< m/s, at least 0: slower impacts make no hit event
    void set_hit_threshold(float speed);
    float sleep_speed() const;  ///< m/s, at least 0: slower islands fall asleep after `sleep_delay`
    void set_sleep_speed(float speed);
    float sleep_delay() const;  ///< s, at least 0
    void set_sleep_delay(float seconds);
    float contact_hertz() const;  ///< Hz, at least 0: `WorldDef::contact_hertz`
    void set_contact_hertz(float hertz);
    float contact_damping() const;  ///< damping ratio of contacts, at least 0
    void set_contact_damping(float ratio);
    float push_speed() const;  ///< m/s, at least 0: limit for pushing overlapping shapes apart
    void set_push_speed(float speed);
    /// m/s, above 0, at most 1e4 (the default): no body, not even a kinematic one, is faster at the
    /// end of a step. Contacts may exceed it within the step; `Body::set_max_speed`, which limits
    /// a single body, also excludes that.
    float max_speed() const;
    void set_max_speed(float speed);
    Solver solver() const;                   ///< how contacts and joints are solved
    void set_solver(Solver solver);          ///< wakes all
    MixRule friction_mix() const;            ///< how a contact computes its friction
    void set_friction_mix(MixRule rule);     ///< wakes all
    MixRule restitution_mix() const;         ///< how a contact computes its restitution
    void set_restitution_mix(MixRule rule);  ///< wakes all
    bool persist_events() const;  ///< whether every continuing touch is reported in every step
    void set_persist_events(bool enabled);
    void wake_all();  ///< wakes all bodies
    /// The largest number of values that are computed at a time: 4, 8 or 16, limited by
    /// `simd_width`. Smaller widths are slower and give equal bits; they are for comparisons.
    /// Throws for any other number.
    void limit_simd_width(int most);
    /// Reserves memory for this number of objects at least, so that creating them allocates
    /// nothing. It changes no result. Throws std::invalid_argument for more than 2^24 of a kind.
    void reserve(const Capacity& capacity);

    /// Number of threads that share the work of a step, including the calling thread: 1 … 64. It is
    /// not part of the state and changes no result. The setter throws std::runtime_error if the
    /// system provides fewer, and leaves the number unchanged. If it is higher than the number of
    /// processors, only as many threads work as there are processors. Callbacks run on the thread
    /// of the caller, unless `set_parallel_callbacks` says otherwise.
    int threads() const;
    void set_threads(int threads);
    /// Uses threads of the host instead: `threads` tasks (1 … 64) share the work of a step, and the
    /// calling thread does one of them. `scheduler` must outlive the world, or its replacement by
    /// another one, by null (one thread) or by `set_threads`. It changes no result and is not part
    /// of the state.
    void set_scheduler(TaskScheduler* scheduler, int threads);

    /// Records the changes of the world, for a bug report: `sink` gets its state now, and then in
    /// every step the edits since the last one, the results of callbacks, and the hash. `Replay`
    /// (recording.h) repeats the recording. Bytes come in order and are to be appended to a file or
    /// to memory; if the program ends unexpectedly, what was recorded can be replayed up to there.
    /// A recorded step takes as long as saving the world twice. Throws std::invalid_argument if the
    /// world is recorded already. The recording belongs to the world, and not to its state. `sink`
    /// is called as callbacks are (callbacks.h): if it throws, the recording ends, and the step
    /// throws the exception when it is complete.
    void start_recording(RecordingSink sink);
    void stop_recording();     ///< does nothing if there is no recording
    bool is_recorded() const;  ///< between a start and the end of a recording

    // Callbacks; an empty one is not called and costs nothing. They are not part of a snapshot:
    // copying, saving and restoring do not change the callbacks of the world, and a new copy has
    // none. callbacks.h describes what they may do.

    /// Called for every pair of shapes that come near to each other, in a step, and again after an
    /// edit of a shape's filter. Setting it calls it again for all pairs. For sleeping pairs it is
    /// called when they wake, as are the next two callbacks. A copy, which has no filter, makes the
    /// contacts that the filter has refused. Set it again after restoring a state that was saved
    /// with another filter.
    void set_filter(PairFilter filter);
    /// Mixes the surfaces of every contact in every step, after the mix rules. May set friction,
    /// restitution and surface speed. Called for each touching part of an outline.
    void set_mixing(ContactCallback mix);
    /// Called for every contact before it is solved, once for two shapes; may also disable the
    /// contact for the step.
    void set_before_solve(ContactCallback callback);
    /// True: the last two callbacks are called on all threads that work on a step, for several
    /// contacts at a time and in no order. They must be safe to run so; they may read the world,
    /// but must not destroy it, and `after_step` throws Locked in them. The values that they set
    /// are used in the order of the contacts: if the values depend only on the arguments, so do the
    /// results. False (the default): on the thread of the caller, one after the other.
    void set_parallel_callbacks(bool parallel);
    bool parallel_callbacks() const;  ///< whether they may run so

    /// Updates what edits have left out of date, as the next read of it would; does nothing if
    /// nothing is.
    void refresh();

    /// Sets the owner, which alone may create and destroy objects in the world; null: every caller
    /// may. Like callbacks, it is not part of the state: copying, saving and restoring do not
    /// change it, and a copy has none.
    void set_owner(const Owner* owner);

    /// Like all functions that create, it throws std::invalid_argument for a value out of its
    /// range.
    Body create_body(const BodyDef& def = {});
    Shape create_shape(const Geometry& geometry, const ShapeDef& def = {});  ///< detached
    /// A dormant joint, to be set and then connected. It measures nothing: settings that other
    /// functions derive from the current poses have fixed defaults.
    Joint create_joint(JointType type, uint64_t user_data = 0);
    /// A dormant joint with the settings and user data of another one, of any world.
    Joint create_joint(const Joint& like);
    /// A soft pull of a point of a body towards a target, for dragging.
    MouseJoint create_mouse_joint(const MouseJointDef& def);
    // A joint of each type; joint_definitions.h has the definitions.
    /// A rod, a rope or a spring between two points.
    DistanceJoint create_distance_joint(const DistanceJointDef& def);
    /// A hinge: holds two points together.
    RevoluteJoint create_revolute_joint(const RevoluteJointDef& def);
    /// A slide along an axis, without rotation.
    PrismaticJoint create_prismatic_joint(const PrismaticJointDef& def);
    /// A wheel with suspension and motor.
    WheelJoint create_wheel_joint(const WheelJointDef& def);
    /// Holds two bodies together at a point and at an angle.
    WeldJoint create_weld_joint(const WeldJointDef& def);
    /// Drives b relative to a, with a limited force.
    MotorJoint create_motor_joint(const MotorJointDef& def);
    /// A rope over two wheels of the world.
    PulleyJoint create_pulley_joint(const PulleyJointDef& def);
    /// Rotates b with a.
    GearJoint create_gear_joint(const GearJointDef& def);
    /// A pin in a groove with two ends.
    GrooveJoint create_groove_joint(const GrooveJointDef& def);
    /// A pin in a straight slot.
    PinSlotJoint create_pin_slot_joint(const PinSlotJointDef& def);
    /// Lets b rotate in one direction only.
    RatchetJoint create_ratchet_joint(const RatchetJointDef& def);
    /// The two bodies do not collide with each other.
    FilterJoint create_filter_joint(const FilterJointDef& def);
    /// Keeps the angle of b relative to a between two angles.
    RotaryLimitJoint create_rotary_limit_joint(const RotaryLimitJointDef& def);
    /// A field of force.
    Field create_field(const FieldDef& def);
    /// Whether the object exists in this world.
    bool is_valid(FieldId id) const;
    /// The field with this id; its functions throw if there is none.
    Field field(FieldId id) const { return {self(), id}; }
    std::vector<Field> fields() const;  ///< in slot order
    void clear();                       ///< destroys every body, shape, joint and field

    /// Whether the object exists in this world.
    bool is_valid(BodyId id) const noexcept { return columns_->is_valid(id); }
    bool is_valid(ShapeId id) const noexcept { return columns_->is_valid(id); }
    bool is_valid(JointId id) const noexcept { return columns_->is_valid(id); }
    /// The body with this id; its functions throw if there is none.
    Body body(BodyId id) const { return {self(), id}; }
    /// The shape with this id; its functions throw if there is none.
    Shape shape(ShapeId id) const { return {self(), id}; }
    /// The joint as its own type, or as a general joint: `joint<WheelJoint>(id)`.
    template <class Any = Joint>
    Any joint(JointId id) const {
        return {self(), id};
    }

    // All live objects, in slot order, without the border of the world.
    std::vector<Body> bodies() const;       ///< in slot order, without the border of the world
    std::vector<Shape> shapes() const;      ///< in slot order, detached ones included
    std::vector<Joint> joints() const;      ///< in slot order, dormant ones included
    std::vector<Contact> contacts() const;  ///< touching contacts, sleeping ones, too
    /// Whether two shapes touch; false if one of them does not exist.
    bool is_touching(const ContactId& id) const;
    std::vector<Contact> contacts_of(const ContactId& id) const;  ///< one for each touching part
    /// Two shapes that touch have no contact until they have separated, as if a before-solve
    /// callback disabled it in each step; that callback is not called. Both must be shapes of this
    /// world. It has no effect on shapes that are apart. It belongs to the state.
    void ignore_until_separated(const Shape& a, const Shape& b);
    /// A number of the host for two shapes that touch, without effect; 0 if there is none. It is
    /// kept while their touch lasts, and can still be read after the step that reports
    /// `contact_end`. A touch that a callback or `ignore_until_separated` ends has ended, although
    /// the shapes overlap. If a touch begins in the step in which another of the same shapes ends,
    /// it takes over the number. It belongs to the state.
    uint64_t contact_data(const ContactId& id) const;
    /// Throws std::invalid_argument if the shapes do not touch; 0 removes the number and is always
    /// allowed.
    void set_contact_data(const ContactId& id, uint64_t user_data);
    /// Bodies that have another pose than before the last step, in slot order: those that a host
    /// has to draw elsewhere. Bodies that were teleported since are not among them.
    std::vector<Body> moved_bodies() const;
    uint32_t body_count() const;  ///< without the border of the world
    /// True in the middle of a step, a query or an edit that calls a user function: editing methods
    /// throw Locked then.
    bool locked() const;
    uint32_t shape_count() const;  ///< detached ones included
    uint32_t joint_count() const;  ///< dormant ones included

    const Events& events() const;              ///< of the last step
    const StepStatistics& statistics() const;  ///< of the last step
    /// From the next step on, adds up what changes the velocity of this body; other results do not
    /// depend on that. Beyond `most_accounts` bodies, the account that began first is dropped.
    /// Accounts are for the solver `soft_step`. They are not part of the state: a copy has none.
    /// Throws std::invalid_argument if the body does not exist.
    void keep_account(BodyId body);
    /// The number of bodies of which accounts can be kept at a time.
    static constexpr size_t most_accounts = 8;
    /// The changes of the velocity of a body in the last step; none if they were not added up, or
    /// if the body was asleep or does not move by forces.
    std::optional<VelocityAccount> account(BodyId body) const;
    /// Heap memory of the world, by purpose, without callbacks, threads and accounts. Memory that a
    /// step can rebuild is freed when most bodies have fallen asleep.
    std::vector<MemoryShare> memory() const;
    /// Hash of position, angle and velocities of all bodies, in slot order. Equal histories have
    /// equal hashes.
    [[nodiscard]] uint64_t hash() const;

    // Queries include every edit made before them. The order of the found shapes is repeatable. An
    // exception of `QueryFilter::accept` ends the query at once; the world does not change.
    /// Shapes that contain a point (m).
    [[nodiscard]] std::vector<Shape> query_point(const Position& point,
                                                 const QueryFilter& filter = {}) const;
    /// Shapes that overlap the box, whose corners may be any two opposite ones.
    [[nodiscard]] std::vector<Shape> query_aabb(const Aabb& box,
                                                const QueryFilter& filter = {}) const;
    /// The first shape that a ray from one point to another (m) meets from outside.
    [[nodiscard]] std::optional<RayHit> cast_ray(const Position& from, const Position& to,
                                                 const QueryFilter& filter = {}) const;
    /// All shapes that a ray meets from outside.
    [[nodiscard]] std::vector<RayHit> cast_ray_all(
        const Position& from, const Position& to,
        const QueryFilter& filter = {}) const;  ///< nearest first
    /// Shapes that overlap `shape`, which may be of another world; shapes of its own body are
    /// ignored.
    [[nodiscard]] std::vector<Shape> query_overlap(const Shape& shape,
                                                   const QueryFilter& filter = {}) const;
    /// The same for a geometry that is in no world; a `Form` that is used again saves work.
    [[nodiscard]] std::vector<Shape> query_overlap(const Form& form, const Pose& pose = {},
                                                   const QueryFilter& filter = {}) const;
    /// The first shape that `shape` meets along `motion`; at fraction 0 if they overlap at the
    /// start.
    [[nodiscard]] std::optional<RayHit> cast_shape(const Shape& shape, const Vec2& motion,
                                                   const QueryFilter& filter = {}) const;
    [[nodiscard]] std::optional<RayHit> cast_shape(const Form& form, const Pose& pose,
                                                   const Vec2& motion,
                                                   const QueryFilter& filter = {}) const;
    /// The shape nearest to a point, at most `reach` (m) away. The border is ignored.
    [[nodiscard]] std::optional<PointHit> closest(const Position& point, float reach = infinity,
                                                  const QueryFilter& filter = {}) const;
    // The same for a visitor, which is called with each result at once, in no particular order, and
    // ends the query by false. Like `cast_ray`, `cast_shape` and `closest`, they allocate nothing,
    // once the thread has made such a query. A geometry that is not a `Form`, or has more than a
    // thousand parts or some thousand vertices, costs allocations in each query.
    /// As `query_point`.
    void visit_point(const Position& point, Visitor<Shape> visitor,
                     const QueryFilter& filter = {}) const;
    /// As `query_aabb`.
    void visit_aabb(const Aabb& box, Visitor<Shape> visitor, const QueryFilter& filter = {}) const;
    /// As `cast_ray_all`.
    void visit_ray(const Position& from, const Position& to, Visitor<RayHit> visitor,
                   const QueryFilter& filter = {}) const;
    /// As `query_overlap`.
    void visit_overlap(const Shape& shape, Visitor<Shape> visitor,
                       const QueryFilter& filter = {}) const;
    /// As `query_overlap`.
    void visit_overlap(const Form& form, const Pose& pose, Visitor<Shape> visitor,
                       const QueryFilter& filter = {}) const;
    /// Pushes dynamic bodies away from a point: with `impulse` (N s) at distance 0, falling
    /// linearly to 0 at `radius` (m), applied at the nearest point of the body.
    void explode(const Position& point, float radius, float impulse,
                 const QueryFilter& filter = {});
    /// An explosion that acts on the surfaces which face it: each part of the outline of a dynamic
    /// body gets an impulse for its length, so that large bodies get more than small ones. It is
    /// applied at the nearest point of each shape.
    void explode(const ExplosionDef& def, const QueryFilter& filter = {});

    /// Draws the world with the functions of a host. `target` may read the world and must not edit
    /// it. An exception of `target` ends the drawing.
    void draw(DebugDraw& target, const DebugDrawOptions& options = {}) const;

    /// Checks that the broad phase, contacts, islands and lists are consistent. Returns a
    /// description of the first error, or nullopt. For tests and debugging: slow.
    [[nodiscard]] std::optional<std::string> validate() const;

  private:
    friend class Body;
    friend class Shape;
    friend class Joint;
    friend class Field;
    friend class Replay;
    friend class HostAccess;  // host_access.h
    friend struct detail::WorldInside;
    friend struct detail::MoverWorld;
    World(const World& other);
    void begin();
    void call_after_step(std::vector<Function<void()>> calls, detail::WorldLock& lock) const;
    World* self() const { return const_cast<World*>(this); }  ///< handles are not const
    /// For edits: throws Locked while the world must not be edited.
    detail::WorldData& edit(const char* function) const;
    /// For creating and destroying objects: also throws Locked if the world has an owner.
    detail::WorldData& populate(const char* function) const;

    detail::Owned<detail::WorldData> data_;
    detail::Columns* columns_ = nullptr;  ///< base of `*data_`
    detail::WorldLink* link_ = nullptr;   ///< the link in handles
};

inline Body::Body(World* world, BodyId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}
inline Shape::Shape(World* world, ShapeId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}
inline Joint::Joint(World* world, JointId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}
inline Field::Field(World* world, FieldId id)
    : link_(world != nullptr ? world->link_ : nullptr), id_(id) {}

}  // namespace fettle::physics

FETTLE_PHYSICS_END
