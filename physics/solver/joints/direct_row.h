#pragma once

#include <constraints/joint_rows.h>
#include <solver/contacts/contact_solver.h>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

// Joints and contacts for the direct solver. A row is a direction in which two bodies act on each
// other.

namespace fettle::physics::detail {

/// Square roots of the inverse masses along x and y and of the inverse inertia; 0 if the body does
/// not move.
struct MassScale {
    double x = 0.0, y = 0.0, turn = 0.0;

    bool moves() const { return x > 0.0 || y > 0.0 || turn > 0.0; }
};

struct SolverInput;
/// By solver body.
std::vector<MassScale> mass_scales(const SolverInput& input);

/// v = on_a·(velocity, angular velocity of a) + on_b·(velocity, angular velocity of b).
struct Jacobian {
    uint32_t a = 0, b = 0;  ///< solver bodies
    double on_a[3] = {}, on_b[3] = {};

    /// Acts with `direction` on b and its opposite on a, with the lever arms r×direction.
    static Jacobian along(const JointEnds& ends, Vec2 direction, float lever_a, float lever_b) {
        return along(ends.a, ends.b, direction, lever_a, lever_b);
    }
    static Jacobian along(uint32_t a, uint32_t b, Vec2 direction, float lever_a, float lever_b) {
        const double x = double(direction.x), y = double(direction.y);
        return {a, b, {-x, -y, -double(lever_a)}, {x, y, double(lever_b)}};
    }
    /// Jacobian at the anchors of a joint.
    static Jacobian at_anchors(const JointEnds& ends, Vec2 direction) {
        return along(ends, direction, cross(ends.lever_a, direction),
                     cross(ends.lever_b, direction));
    }
    static Jacobian turning(const JointEnds& ends, float of_a = 1.0f) {
        return {ends.a, ends.b, {0.0, 0.0, -double(of_a)}, {0.0, 0.0, 1.0}};
    }
    Jacobian opposite() const {
        return {a, b, {-on_a[0], -on_a[1], -on_a[2]}, {-on_b[0], -on_b[1], -on_b[2]}};
    }
};

/// λ = clamp(-(stiffness·v + push), low, high). A stiff row holds v = -push/stiffness with any
/// necessary impulse, a spring has a low stiffness, a force has stiffness 0.
struct DirectRow {
    static constexpr double no_limit = std::numeric_limits<double>::infinity();

    Jacobian jacobian;
    double stiffness = 0.0;
    double push = 0.0;
    double correction = 0.0;  ///< the part of `push` that removes an error of position
    double low = -no_limit, high = no_limit;
    bool rigid = false;    ///< infinite stiffness: v must become -push/stiffness
    double impulse = 0.0;  ///< total impulse: of the pass before, then of this one

    /// For friction: the bound is `friction` times the impulses of `bearers` rows, beginning with
    /// `bearer`.
    uint32_t bearer = 0, bearers = 0;
    double friction = 0.0;
    /// Two consecutive rows whose impulses are a vector with a maximum length: the other row is the
    /// next one, or the previous one.
    int circle = 0;  ///< 1: the first of the two rows, -1: the second
    double greatest = no_limit;

    float* kept = nullptr;       ///< place of the impulse in the constraint
    Vec2* kept_along = nullptr;  ///< or the vector that the impulse is a part of, along `axis`
    Vec2 axis;

    /// Writes the impulse back to the constraint. The first part of a vector resets the vector.
    void keep() const {
        const float value = bounded(float(impulse), 1e30f);
        if (kept != nullptr) *kept = value;
        if (kept_along == nullptr) return;
        *kept_along = value * axis + (circle == 1 ? Vec2{} : *kept_along);
    }
};

/// The pass of a sub-step for which rows are written. Biased: positions are corrected. Relaxed,
/// after the bodies moved: without correction and without springs. Bounced, at the end of the step:
/// like relaxed, but with the bounces of hits.
enum class DirectPass { biased, relaxed, bounced };

/// Share of an error that one sub-step corrects.
inline constexpr float direct_correction = 0.2f;

class RowWriter {
  public:
    RowWriter(std::vector<DirectRow>& rows, std::span<const MassScale> scales, float h,
              DirectPass pass)
        : rows_(rows), scales_(scales), h_(double(h)), pass_(pass) {
        rows_.clear();
    }

    bool biased() const { return pass_ == DirectPass::biased; }
    DirectPass pass() const { return pass_; }
    double h() const { return h_; }

    /// Keeps an error at 0.
    DirectRow& hold(const Jacobian& jacobian, float error, float& impulse) {
        const double bias = biased() ? double(direct_correction) * double(error) / h_ : 0.0;
        DirectRow& row = rigid(jacobian, bias, impulse);
        row.correction = row.push;
        return row;
    }
    /// Keeps the gap between the anchors at 0.
    void hold_point(const JointEnds& ends, Vec2 gap, Vec2& impulse) {
        hold(Jacobian::at_anchors(ends, {1.0f, 0.0f}), gap.x, impulse.x);
        hold(Jacobian::at_anchors(ends, {0.0f, 1.0f}), gap.y, impulse.y);
    }
    /// Prevents `room` from becoming negative.
    DirectRow& limit(const Jacobian& jacobian, float room, float& impulse) {
        double bias = double(room) / h_;  // the room may close completely, but not more
        if (room < 0.0f) bias = biased() ? double(direct_correction) * bias : 0.0;
        DirectRow& row = rigid(jacobian, bias, impulse);
        row.low = 0.0;
        if (room < 0.0f) row.correction = row.push;
        return row;
    }
    /// Drives a velocity with a limited impulse.
    DirectRow& motor(const Jacobian& jacobian, float speed, float greatest, float& impulse) {
        DirectRow& row = rigid(jacobian, -double(speed), impulse);
        row.low = -double(greatest);
        row.high = double(greatest);
        return row;
    }
    DirectRow& spring(const Jacobian& jacobian, const Spring& spring, float error, float& impulse) {
        DirectRow& row = elastic(jacobian, spring, error);
        row.kept = &impulse;
        row.impulse = double(impulse);
        freeze_unless_biased(row);
        return row;
    }
    /// Two springs that are the components of a vector with a maximum length.
    void springs(const JointEnds& ends, const PointSpring& spring, Vec2 error, float greatest,
                 Vec2& impulse);
    /// Two rows that drive the velocity of the anchors.
    void motors(const JointEnds& ends, Vec2 speed, float greatest, Vec2& impulse);

    /// A row with the greatest rigidity that the arithmetic allows: it yields by 10⁻⁷ of the effect
    /// of the impulse on the two bodies alone.
    DirectRow& rigid(const Jacobian& jacobian, double bias, float& impulse) {
        DirectRow& row = rows_.emplace_back();
        row.jacobian = jacobian;
        const double inverse = inverse_mass(jacobian);
        row.stiffness = inverse > 0.0 ? rigidity / inverse : 0.0;
        row.push = row.stiffness * bias;
        row.rigid = true;
        row.kept = &impulse;
        row.impulse = double(impulse);
        if (!(inverse > 0.0)) row.low = row.high = row.impulse = 0.0;
        return row;
    }
    size_t size() const { return rows_.size(); }

  private:
    static constexpr double rigidity = 1e7;

    /// J·M⁻¹·Jᵀ.
    double inverse_mass(const Jacobian& j) const {
        double sum = 0.0;
        const auto add = [&](const MassScale& s, const double(&on)[3]) {
            sum += s.x * s.x * on[0] * on[0] + s.y * s.y * on[1] * on[1] +
                   s.turn * s.turn * on[2] * on[2];
        };
        add(scales_[j.a], j.on_a);
        add(scales_[j.b], j.on_b);
        return sum;
    }
    /// `Spring::impulse` as a row: the impulse that the spring itself would not change any more.
    DirectRow& elastic(const Jacobian& jacobian, const Spring& spring, float error) {
        DirectRow& row = rows_.emplace_back();
        row.jacobian = jacobian;
        const double inverse = inverse_mass(jacobian);
        const double most = inverse > 0.0 ? rigidity / inverse : 0.0;
        row.stiffness = double(spring.resistance);
        row.push = double(spring.push) * double(error);
        if (row.stiffness <= most) return row;
        // Stiffer than a rigid row. At the limit of single precision it holds the position at once.
        const double rate = double(spring.push) / double(spring.resistance);
        row.stiffness = most;
        row.push = most * double(error) * (rate * h_ <= 1.0 ? rate : 1.0 / h_);
        return row;
    }
    /// Impulses of the biased pass are not part of the relaxed pass.
    void freeze_unless_biased(DirectRow& row) const {
        if (biased()) return;
        row.low = row.high = row.impulse;
        row.greatest = DirectRow::no_limit;
    }
    void pair_up(DirectRow& row, int circle, Vec2 axis, float greatest, Vec2& vector) {
        row.kept_along = &vector;
        row.axis = axis;
        row.circle = circle;
        row.greatest = double(greatest);
        row.impulse = double(dot(axis, vector));
        row.low = -row.greatest;
        row.high = row.greatest;
    }

    std::vector<DirectRow>& rows_;
    std::span<const MassScale> scales_;
    double h_;
    DirectPass pass_;
};

/// The axes along which a spring at a point is damped independently: eigenvectors of its
/// resistance.
struct PointAxes {
    Vec2 first = {1.0f, 0.0f}, second = {0.0f, 1.0f};
    float of_first = 0.0f, of_second = 0.0f;

    static PointAxes of(const PointInverse& m) {
        const float half = 0.5f * (m.xx - m.yy), radius = std::sqrt(half * half + m.xy * m.xy);
        const float middle = 0.5f * (m.xx + m.yy);
        PointAxes axes;
        axes.of_first = middle + radius;
        axes.of_second = middle - radius;
        if (radius > 1e-6f * middle) {
            axes.first =
                half > 0.0f ? normalized({half + radius, m.xy}) : normalized({m.xy, radius - half});
            axes.second = {-axes.first.y, axes.first.x};
        } else {
            axes.of_first = axes.of_second = middle;
        }
        return axes;
    }
};

inline void RowWriter::springs(const JointEnds& ends, const PointSpring& spring, Vec2 error,
                               float greatest, Vec2& impulse) {
    const PointAxes axes = PointAxes::of(spring.resistance);
    const auto add = [&](Vec2 axis, float resistance, int circle) {
        DirectRow& row =
            elastic(Jacobian::at_anchors(ends, axis), {spring.push, resistance}, dot(axis, error));
        pair_up(row, circle, axis, greatest, impulse);
        freeze_unless_biased(row);
    };
    add(axes.first, axes.of_first, 1);
    add(axes.second, axes.of_second, -1);
}

inline void RowWriter::motors(const JointEnds& ends, Vec2 speed, float greatest, Vec2& impulse) {
    const auto add = [&](Vec2 axis, int circle) {
        float unused = 0.0f;
        DirectRow& row = rigid(Jacobian::at_anchors(ends, axis), -double(dot(axis, speed)), unused);
        row.kept = nullptr;
        const bool moves = row.stiffness > 0.0;
        pair_up(row, circle, axis, greatest, impulse);
        if (!moves) row.low = row.high = row.impulse = 0.0;
    };
    add({1.0f, 0.0f}, 1);
    add({0.0f, 1.0f}, -1);
}

/// Normals, rolling and friction of a contact; `extra` may be null.
void write_rows(RowWriter& rows, ContactConstraint& c, ContactExtra* extra, const SolverBody& a,
                const SolverBody& b, float push_speed, float restitution_threshold);

}  // namespace fettle::physics::detail
