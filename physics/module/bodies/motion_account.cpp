// Accounts of the motion of a body: the causes of the changes of its velocities and its pose in the
// last step.

#include <bodies/motion_account.h>

#include <cmath>

#include <fettle/physics/locked.h>
#include <fettle/property/explaining.h>

#include <bindings/bindings.h>

namespace fettle::physics_module {
namespace {

using Lines = std::vector<std::string>;

/// Changes below this share of the largest number are rounding errors and are not listed.
constexpr float only_rounding = 1e-5f;

class Motion {
  public:
    Motion(Hosting& hosting, Handle self)
        : hosting_(hosting),
          row_(hosting.tree.row(self)),
          world_(hosting.world(row_)),
          body_(hosting.body(row_)),
          path_(hosting.tree.path(self)),
          world_path_(hosting.hosted(row_).self ? hosting.tree.path(hosting.hosted(row_).self)
                                                : "world") {}

    Lines velocity() {
        if (const std::string reason = reason_of_rest(); !reason.empty()) return {reason};
        if (body_.type() == physics::BodyType::kinematic_body) return of_mover();
        const auto account = world_.account(body_.id());
        if (!account) return estimated();
        largest_ = account->before.length() + account->after.length() + account->gravity.length();
        add_line("before the last step: ", account->earlier);
        add("between the steps (writes, edits of shapes): ", account->before - account->earlier);
        forces(account->gravity, account->force, account->applied);
        add("fields of force: ", account->fields);
        for (const physics::ContactShare& share : account->contacts)
            push(named(share), share.change, share.impulse);
        for (const physics::JointShare& share : account->joints)
            push(named(share.joint), share.change, share.impulse);
        add("damping (" + path_ + ".linear_damping): ", account->damping);
        add("the rest (locked axes, limits of speed): ", account->rest);
        add("written since the step: ", body_.velocity() - account->after);
        return std::move(lines_);
    }

    Lines angular_velocity() {
        if (const std::string reason = reason_of_rest("angular velocity"); !reason.empty())
            return {reason};
        if (body_.locked_rotation())
            return {"its rotation is locked (" + path_ + ".locked_rotation)"};
        if (body_.type() == physics::BodyType::kinematic_body)
            return {"a mover keeps the angular velocity that was written"};
        const auto account = world_.account(body_.id());
        if (!account) {
            prepare();
            return {"the sums of this step were not kept; those of the next are"};
        }
        const physics::TurnAccount& turn = account->turn;
        largest_ = std::fabs(turn.before) + std::fabs(turn.after) + turn.size;
        unit_ = " rad/s";
        add_line("before the last step: ", turn.earlier);
        add("between the steps (writes, edits of shapes): ", turn.before - turn.earlier);
        add(path_ + ".torque: ", turn.torque);
        add("apply_torque, and forces beside its center of mass: ", turn.applied);
        add("fields of force: ", turn.fields);
        for (const physics::ContactShare& share : account->contacts)
            push(named(share), share.turn, share.twist);
        for (const physics::JointShare& share : account->joints)
            push(named(share.joint), share.turn, share.twist);
        add("damping (" + path_ + ".angular_damping): ", turn.damping);
        add("the rest (limits of speed, bounces of curved shapes): ", turn.rest);
        add("written since the step: ", body_.angular_velocity() - turn.after);
        return std::move(lines_);
    }

    Lines position() {
        const physics::Pose before = physics::HostAccess::previous(world_, slot_of(row_));
        const physics::Vec2 moved = body_.position() - before.position;
        const auto dt = static_cast<float>(hosting_.last_dt);
        const physics::Vec2 by_velocity = dt * body_.velocity();
        if (moved == physics::Vec2{} && by_velocity != physics::Vec2{})
            return {"it was put here after the last step"};
        // The velocity is that of the center of mass.
        const physics::Vec2 turned = offset(before.angle) - offset(body_.angle());
        largest_ = body_.position().length() + moved.length();
        unit_ = " m";
        add_line("before the last step: ", before.position);
        if (body_.type() != physics::BodyType::static_body)
            add_line(path_ + ".velocity × " + text(hosting_.last_dt) + " s: + ", by_velocity);
        add("turned about its center of mass: ", turned);
        add("within the step (other velocities before its end, overlaps): ",
            moved - by_velocity - turned);
        return std::move(lines_);
    }

    Lines angle() {
        const float before = physics::HostAccess::previous(world_, slot_of(row_)).angle;
        const float turned = body_.angle() - before;
        const float by_velocity = static_cast<float>(hosting_.last_dt) * body_.angular_velocity();
        if (turned == 0 && by_velocity != 0) return {"it was put here after the last step"};
        Lines lines{"before the last step: " + text(to_value(before)) + " rad",
                    path_ + ".angular_velocity × " + text(hosting_.last_dt) + " s: + " +
                        text(to_value(by_velocity)) + " rad"};
        if (const float rest = turned - by_velocity;
            std::fabs(rest) > only_rounding * (std::fabs(before) + std::fabs(turned)))
            lines.push_back("within the step (other velocities before its end): + " +
                            text(to_value(rest)) + " rad");
        return lines;
    }

    void prepare() {
        try {
            world_.keep_account(body_.id());
        } catch (const physics::Locked&) {
            // Inside a function that the world calls there is no account yet.
        }
    }

  private:
    /// Why nothing changes the velocity; "" if something may.
    std::string reason_of_rest(const std::string& what = "velocity") const {
        if (!hosting_.hosted(row_).self) return "it is in no world, so nothing moves it";
        if (body_.type() == physics::BodyType::static_body) return "a static body does not move";
        if (!body_.enabled())
            return "it is disabled (" + path_ + ".enabled): it keeps its " + what +
                   " and does not move";
        if (body_.type() == physics::BodyType::kinematic_body)
            return mover().slot != 0 ? ""
                                     : "a kinematic body keeps the " + what + " that was written";
        if (std::isinf(body_.mass())) return "a body of infinite mass does not move";
        if (!body_.awake()) return "it is asleep (" + path_ + ".awake)";
        return world_.solver() == physics::Solver::soft_step
                   ? ""
                   : "the changes are only added up by the solver \"soft_step\" (" + world_path_ +
                         ".solver)";
    }

    MoverRecord mover() const { return hosting_.hosted(row_).movers.get(slot_of(row_)); }

    /// A mover finds its velocity itself.
    Lines of_mover() {
        const MoverRecord record = mover();
        const auto setting = [&](const char* name, float value, const char* unit) {
            return path_ + "." + name + " = " + text(to_value(value)) + " " + unit;
        };
        const std::string walk = setting("walk", record.settings.walk, "m/s");
        if (record.settings.climbing != 0)
            return {"it climbs (" + path_ + ".climbing), with " + walk + " and " +
                    setting("climb", record.settings.climb, "m/s")};
        if (record.result.on_ground != 0) {
            lines_.push_back("it walks on ground, with " + walk + ", by at most " +
                             setting("acceleration", record.settings.acceleration, "m/s\xC2\xB2"));
            const physics::Vec2 ground(record.result.ground_x, record.result.ground_y);
            if (ground != physics::Vec2{}) add_line(path_ + ".ground_velocity: + ", ground);
        } else {
            lines_.push_back(
                "it is in the air, with " + walk + ", by at most " +
                setting("air_acceleration", record.settings.air_acceleration, "m/s\xC2\xB2"));
            const physics::Vec2 left(record.result.left_x, record.result.left_y);
            if (left != physics::Vec2{}) add_line("the ground that it left moves: + ", left);
            largest_ = 0;
            forces(static_cast<float>(hosting_.last_dt) * body_.gravity_scale() * world_.gravity(),
                   {}, {});
        }
        if (record.result.on_wall != 0) lines_.push_back("a wall stops it (" + path_ + ".on_wall)");
        if (record.result.on_ceiling != 0)
            lines_.push_back("a ceiling stops it (" + path_ + ".on_ceiling)");
        return std::move(lines_);
    }

    /// For a step without an account: contacts have the impulses of the last sub-step only.
    Lines estimated() {
        prepare();
        const float dt = static_cast<float>(hosting_.last_dt), mass = body_.mass();
        const auto substeps = static_cast<float>(world_.last_substeps());
        lines_.push_back(
            "about, since the sums of this step were not kept; those of the next are:");
        forces(dt * body_.gravity_scale() * world_.gravity(), dt / mass * body_.force(),
               physics::Vec2{});
        for (const physics::Contact& contact : body_.contacts()) {
            const bool first = contact.body_a == body_.id();
            const physics::Vec2 tangent(contact.normal.y, -contact.normal.x);
            physics::Vec2 impulse = {};
            for (int k = 0; k < contact.point_count; ++k) {
                const physics::ContactPoint& p = contact.points[static_cast<std::size_t>(k)];
                impulse +=
                    substeps * (p.normal_impulse * contact.normal + p.tangent_impulse * tangent);
            }
            if (first) impulse = -1.0f * impulse;
            push(named({.own = first ? contact.shape_a : contact.shape_b,
                        .other = first ? contact.shape_b : contact.shape_a,
                        .body = first ? contact.body_b : contact.body_a}),
                 impulse / mass, impulse);
        }
        for (const physics::Joint& joint : body_.joints()) {
            const float side = joint.body_b() == body_ ? dt : -dt;
            push(named(joint.id()), side / mass * joint.force(), side * joint.force());
        }
        return std::move(lines_);
    }

    void forces(const physics::Vec2& gravity, const physics::Vec2& force,
                const physics::Vec2& applied) {
        const std::string scale =
            body_.gravity_scale() == 1.0f ? "" : " × " + path_ + ".gravity_scale";
        add(world_path_ + ".gravity" + scale + ": ", gravity);
        add(path_ + ".force: ", force);
        add("apply_force: ", applied);
    }

    physics::Vec2 offset(float angle) const {
        const physics::Vec2 center = body_.center();
        const float c = std::cos(angle), s = std::sin(angle);
        return {c * center.x - s * center.y, s * center.x + c * center.y};
    }

    std::string text(const Value& value) const {
        return hosting_.tree.text(value, property::Precision::single_precision);
    }
    /// Without the sign of a zero.
    std::string text(const physics::Vec2& v) const {
        return text(to_value(physics::Vec2(v.x + 0.0f, v.y + 0.0f)));
    }
    void add_line(const std::string& what, const physics::Vec2& v) {
        lines_.push_back(what + text(v) + unit_);
    }
    void add_line(const std::string& what, float number) {
        lines_.push_back(what + text(to_value(number)) + unit_);
    }
    void add(const std::string& what, float change) {
        if (std::fabs(change) > only_rounding * largest_)
            add_line(what + (change < 0 ? "- " : "+ "), std::fabs(change));
    }
    /// `twist`: angular impulse, N m s.
    void push(const std::string& by, float change, float twist) {
        if (std::fabs(change) > only_rounding * largest_)
            lines_.push_back(by + (change < 0 ? ": - " : ": + ") +
                             text(to_value(std::fabs(change))) + unit_ + ", angular impulse " +
                             text(to_value(twist)) + " N m s");
    }
    /// Lists a change unless it is 0.
    void add(const std::string& what, const physics::Vec2& change) {
        if (change.length() > only_rounding * largest_) add_line(what + "+ ", change);
    }
    void push(const std::string& by, const physics::Vec2& change, const physics::Vec2& impulse) {
        if (impulse == physics::Vec2{}) return;
        lines_.push_back(by + ": + " + text(change) + unit_ + ", impulse " + text(impulse) +
                         " N s");
    }

    std::string path_of(std::uint64_t user_data, const std::string& otherwise) const {
        const Handle instance = hosting_.instance_of(user_data);
        return instance ? hosting_.tree.path(instance) : otherwise;
    }
    std::string named(const physics::ContactShare& share) const {
        if (share.body.index == 0) return "contact with the bounds of " + world_path_;
        return "contact with " + (world_.is_valid(share.other)
                                      ? path_of(world_.shape(share.other).user_data(), "a shape")
                                      : "a shape that is deleted");
    }
    std::string named(physics::JointId joint) const {
        return "joint " + (world_.is_valid(joint)
                               ? path_of(world_.joint(joint).user_data(), "without a name")
                               : "that is deleted");
    }

    Hosting& hosting_;
    Row row_;
    physics::World& world_;
    physics::Body body_;
    std::string path_, world_path_, unit_ = " m/s";
    float largest_ = 0;
    Lines lines_;
};

property::Explainer explained(Hosting& hosting, Lines (Motion::*explain)()) {
    return {
        .sources = [&hosting, explain](Handle self) { return (Motion(hosting, self).*explain)(); }};
}

}  // namespace

void explain_motion(Hosting& hosting, const property::Class& body) {
    property::Tree& tree = hosting.tree;
    property::Explainer velocity = explained(hosting, &Motion::velocity);
    velocity.prepare = [&hosting](Handle self) { Motion(hosting, self).prepare(); };
    property::Explainer turning = explained(hosting, &Motion::angular_velocity);
    turning.prepare = velocity.prepare;
    property::explain_with(tree, *body.property("velocity"), std::move(velocity));
    property::explain_with(tree, *body.property("angular_velocity"), std::move(turning));
    property::explain_with(tree, *body.property("position"), explained(hosting, &Motion::position));
    property::explain_with(tree, *body.property("angle"), explained(hosting, &Motion::angle));
}

}  // namespace fettle::physics_module
