#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/world.h>

#include <span>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Settings of a mover. Its form is an upright capsule. The position of a mover is the lowest point
/// of this capsule: its feet.
struct MoverDef {
    float radius = 0.4f;       ///< m, 0.01 … 1000
    float height = 1.8f;       ///< m, at least twice the radius, at most 1000
    Vec2 up = {0.0f, 1.0f};    ///< direction from its feet to its head; of any length but 0
    float max_slope = 0.87f;   ///< rad, 0 … 1.5: steeper ground is a wall
    float step_height = 0.3f;  ///< m: it climbs steps up to this height, to 1 mm
    float snap = 0.25f;        ///< m: walking, it follows ground that is lower by at most this
    float skin = 0.01f;        ///< m, 0.001 … 0.1: distance that it keeps from obstacles
    /// kg: its weight and its inertia on dynamic bodies; a light body gets a part of the weight.
    /// 0: neither.
    float mass = 80.0f;
    /// N: the greatest force with which it pushes a dynamic body; a dynamic body on which it stands
    /// gets the opposite force.
    float push_force = 600.0f;
    uint64_t category = 1;         ///< categories of the mover: as `ShapeDef::category`
    uint64_t mask = ~uint64_t{0};  ///< categories of the shapes that are obstacles
    int32_t group = 0;             ///< as `ShapeDef::group`
    /// Categories of ledges: shapes that are solid only from above, and through which `drop` lets
    /// it fall. Chains are solid on one side without this.
    uint64_t ledges = 0;
    /// A kinematic body whose shapes are not obstacles: the mover's own. It has no contact with the
    /// dynamic bodies that the mover stands on or pushes, nor with dynamic ledges near it.
    BodyId body = {};
};

/// A plane that bounds the motion of a mover, from the surface of a shape near it.
struct MoverPlane {
    Vec2 normal = {};         ///< from the shape to the mover; its length is 1
    Position point = {};      ///< on the surface, world, m
    float separation = 0.0f;  ///< m; negative when they overlap
    Shape shape;              ///< the shape with this surface
};

/// The state of a mover from one move to the next.
struct MoverState {
    Position position = {};   ///< of its feet, m
    Vec2 ground_normal = {};  ///< zero in the air
    /// With which its ground carries it, m/s; zero in the air. After `drop`, and if the ground was
    /// destroyed, the next move adds it to the velocity of the mover.
    Vec2 ground_velocity = {};
    ShapeId ground = {};       ///< the shape on which it stands
    uint32_t ground_part = 0;  ///< segment or piece of `ground`, as in `Contact`
    ShapeId dropped = {};      ///< the shape through which it falls until it no longer overlaps it
    bool on_ground = false;    ///< after the move: it stands
    bool climbing = false;     ///< as `Mover::climbing`
};

/// The results of a move.
struct Moved {
    Vec2 motion = {};  ///< m, with the motion of the ground
    /// The velocity for the next move, m/s, without the parts that obstacles stopped. On the
    /// ground it is relative to the ground, and has no part along `up`. In the air it is relative
    /// to the world: a mover that leaves its ground keeps the velocity of that ground,
    /// and one that lands is not faster relative to the ground than it was before.
    Vec2 velocity = {};
    bool on_ground = false;   ///< after the move: it stands
    Vec2 ground_normal = {};  ///< zero in the air
    /// Of the ground at its feet, without the part that walls keep from it, m/s.
    Vec2 ground_velocity = {};
    Shape ground;              ///< the shape below its feet; empty in the air
    bool hit_wall = false;     ///< it was stopped by a wall
    bool hit_ceiling = false;  ///< it was stopped by a ceiling
    Vec2 wall_normal = {};     ///< of the last wall or ceiling that it hit
    Shape wall;                ///< the last wall or ceiling that it hit
    bool stepped = false;      ///< it climbed a step
    /// True if it has no room between obstacles: it overlaps one.
    bool crushed = false;
};

/// Moves a character through a world: it slides along walls, climbs slopes and steps, rides on
/// moving platforms, passes through ledges from below and pushes crates. It is not a body: bodies
/// do not see it. A host may give it a kinematic body, `MoverDef::body`, and set the velocity of
/// this body to `Moved::motion` divided by dt before the step.
///
/// A mover is a plain value: a copy is a snapshot. Functions throw std::invalid_argument for values
/// out of range.
///
///     Mover hero({}, {0, 2});
///     Vec2 velocity = {3, 0};
///     for (int i = 0; i < 120; ++i) {
///         if (!hero.on_ground()) velocity.y -= 10.0f / 60;
///         velocity = hero.move(world, velocity, 1.0f / 60).velocity;
///         world.step(1.0f / 60);
///     }
class Mover {
  public:
    Mover() = default;  ///< with the default settings, at the origin
    /// A mover with its feet at `position` (m).
    explicit Mover(const MoverDef& def, const Position& position = {0.0f, 0.0f});

    const MoverDef& definition() const { return def_; }  ///< its settings
    /// The position stays. A mover that grows may overlap obstacles, which the next moves correct;
    /// `fits` returns whether it has room.
    void set_definition(const MoverDef& def);
    const MoverState& state() const { return state_; }  ///< what it keeps from one move to the next
    /// For hosts that save movers. Ids of shapes that do not exist count as empty.
    void set_state(const MoverState& state);
    const Position& position() const { return state_.position; }  ///< of its feet, m
    /// It leaves the ground, and the shape through which it falls.
    void set_position(const Position& position);
    bool on_ground() const { return state_.on_ground; }                 ///< after the last move
    const Vec2& ground_normal() const { return state_.ground_normal; }  ///< zero in the air
    ShapeId ground() const {
        return state_.ground;
    }  ///< the shape on which it stands; empty in the air
    /// True: `move` moves it freely; it climbs no steps, has no ground and is not carried by one.
    bool climbing() const { return state_.climbing; }
    void set_climbing(bool climbing) { state_.climbing = climbing; }

    /// Moves it by `velocity` · `dt` and by the motion of the ground. To be called before
    /// `World::step(dt)`: it goes to where kinematic bodies will be after the step, and applies its
    /// weight and its pushes to dynamic bodies. `velocity` is relative to the ground if it stands,
    /// otherwise to the world, m/s; a part along `up` lifts it off. It does nothing unless dt > 0;
    /// then the results are those of the last move, with the given velocity and without hits.
    /// Throws `Locked` inside a function that the world is calling.
    Moved move(World& world, const Vec2& velocity, float dt);
    /// It falls through the ledge or the chain on which it stands. False if it stands on none.
    bool drop(const World& world);
    /// True if a mover of this height (m) has room at its position.
    [[nodiscard]] bool fits(const World& world, float height) const;
    /// Changes the height if there is room for it; otherwise returns false and changes nothing.
    bool set_height(const World& world, float height);
    /// The planes of all obstacles within `distance` (m), nearest first.
    [[nodiscard]] std::vector<MoverPlane> planes(const World& world, float distance) const;

  private:
    bool overlaps_dropped(const World& world) const;

    MoverDef def_;
    MoverState state_;
};

/// The motion nearest to `motion` after which all planes are at least `distance` (m) away; if there
/// is none, one that divides the overlap among them.
[[nodiscard]] Vec2 solve_planes(const Vec2& motion, std::span<const MoverPlane> planes,
                                float distance = 0.0f);
/// The velocity without the parts that go into the planes.
[[nodiscard]] Vec2 clip_velocity(const Vec2& velocity, std::span<const MoverPlane> planes);

/// Throws std::invalid_argument for a value out of its range.
void check(const MoverDef& def);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
