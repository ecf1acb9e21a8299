#pragma once
// A world as plain data: what is made, when it is edited, and how long its steps are. It uses the
// definitions of the library. Bodies and joints are identified by their indices.

#include <fettle/physics/physics.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fettle::bench::wild {

using namespace physics;
using physics::Geometry;  // not that of the scenes

struct ShapePlan {
    Geometry geometry;
    ShapeDef def{};
};

/// Motion to and fro of a kinematic body, about its first position.
struct Swing {
    Vec2 reach = {};  // m
    float hertz = 0;
    Vec2 velocity(double time) const;
};

struct BodyPlan {
    BodyDef def{};
    std::vector<ShapePlan> shapes{};
    Swing swing{};
    int born = 0;  // the step before which it is made
};

/// A call of a setter, with a number, a flag or an enumerator in x, or a vector.
struct Setting {
    std::string setter;
    Vec2 value = {};
};

inline constexpr int the_world = -1;

struct JointPlan {
    JointType type = JointType::revolute;
    int a = the_world;  // indices of bodies
    int b = the_world;
    Vec2 anchor_a = {};  // body coordinates
    Vec2 anchor_b = {};
    bool collide = false;
    std::vector<Setting> settings{};
    int born = 0;

    /// The value that was set last; `otherwise` if there is none.
    float number(const std::string& setter, float otherwise) const;
    Vec2 vector(const std::string& setter, const Vec2& otherwise) const;
    void set(const Setting& setting);
};

enum class Target : std::uint8_t { world, body, shape, joint };

struct Edit {
    int step = 0;  // the step before which it is made
    Target target = Target::world;
    int object = 0;  // index of the body or joint
    int shape = 0;   // index in the body
    Setting setting{};
    std::optional<Geometry> geometry{};  // for `set_geometry`
};

struct WorldPlan {
    std::uint64_t seed = 0;
    WorldDef def{};
    std::vector<BodyPlan> bodies{};
    std::vector<JointPlan> joints{};
    std::vector<FieldDef> fields{};
    std::vector<Edit> edits{};
    std::vector<float> lengths = {1.0f / 60};  // of the steps in turn, s
    int steps = 240;

    float length_of(int step) const { return lengths[std::size_t(step) % lengths.size()]; }
    /// Whether something is made or edited before this step.
    bool edited_at(int step) const;
    int last_edit() const;

    void remove_body(int index);  // with its joints and edits
    void remove_joint(int index);
    void remove_shape(int body, int shape);
};

/// Where a point in body coordinates is, for a body with this origin and angle.
Vec2 placed(const Vec2& point, const Vec2& origin, float angle);
/// The inverse of `placed`.
Vec2 local(const Vec2& point, const Vec2& origin, float angle);

/// Whether the filters of two shapes let them collide, and neither is a sensor.
bool may_collide(const ShapeDef& a, const ShapeDef& b);

/// Whether no force moves the body: it is static or kinematic.
inline bool is_fixed(const BodyPlan& body) {
    return body.def.type != BodyType::dynamic_body;
}

}  // namespace fettle::bench::wild
