#include <solver/joints/crowded_joints.h>
#include <state/active_lists.h>
#include <state/crowding.h>

#include <array>
#include <cmath>

namespace fettle::physics::detail {
namespace {

using Rows = std::array<std::array<float, 3>, 3>;

/// The rows of a joint for both bodies, J·M^-½: along x and y, and the angle.
struct HeldRows {
    size_t count = 0;
    Rows a = {}, b = {};

    HeldRows(const JointRecord& joint, const JointEnds& ends, const SolverBody& body_a,
             const SolverBody& body_b) {
        const Vec2 ra = ends.lever_a, rb = ends.lever_b;
        if (joint.type == JointType::distance) {
            const Vec2 gap = ends.apart + (rb - ra);
            const float distance = length(gap);
            const Vec2 d = distance > 1e-9f ? (1.0f / distance) * gap : Vec2{0.0f, 1.0f};
            add(d, cross(ra, d), cross(rb, d));
        } else {
            add({1.0f, 0.0f}, -ra.y, -rb.y);
            add({0.0f, 1.0f}, ra.x, rb.x);
            if (joint.type == JointType::weld) add({0.0f, 0.0f}, 1.0f, 1.0f);
        }
        weigh(a, ends.inverse_a, body_a.inverse_inertia);
        weigh(b, ends.inverse_b, body_b.inverse_inertia);
        make_orthonormal();
    }

  private:
    void add(Vec2 along, float turn_a, float turn_b) {
        a[count] = {along.x, along.y, turn_a};
        b[count] = {along.x, along.y, turn_b};
        ++count;
    }
    void weigh(Rows& rows, Vec2 inverse_mass, float inverse_inertia) const {
        const float roots[3] = {std::sqrt(inverse_mass.x), std::sqrt(inverse_mass.y),
                                std::sqrt(inverse_inertia)};
        for (size_t i = 0; i < count; ++i)
            for (size_t axis = 0; axis < 3; ++axis) rows[i][axis] *= roots[axis];
    }
    /// Over both bodies together, by Gram and Schmidt: then GᵀK⁻¹G is the product of the rows of
    /// one body. Rows that move nothing become 0.
    void make_orthonormal() {
        for (size_t i = 0; i < count; ++i) {
            for (size_t k = 0; k < i; ++k) subtract(i, k, product(i, k));
            const float square = product(i, i);
            const float scale = square > 1e-20f ? 1.0f / std::sqrt(square) : 0.0f;
            for (size_t axis = 0; axis < 3; ++axis) a[i][axis] *= scale, b[i][axis] *= scale;
        }
    }
    float product(size_t i, size_t k) const {
        float sum = 0.0f;
        for (size_t axis = 0; axis < 3; ++axis)
            sum += a[i][axis] * a[k][axis] + b[i][axis] * b[k][axis];
        return sum;
    }
    void subtract(size_t i, size_t k, float part) {
        for (size_t axis = 0; axis < 3; ++axis) {
            a[i][axis] -= part * a[k][axis];
            b[i][axis] -= part * b[k][axis];
        }
    }
};

/// The sum over the joints of a body.
struct Strength {
    Rows sum = {};

    void add(const Rows& rows, size_t count) {
        for (size_t row = 0; row < count; ++row)
            for (size_t i = 0; i < 3; ++i)
                for (size_t k = 0; k < 3; ++k) sum[i][k] += rows[row][i] * rows[row][k];
    }
    /// The greatest eigenvalue, or up to 7 % more: the 16th root of the trace of the 16th power. It
    /// uses only operations that have the same result on all machines.
    float greatest() const {
        const float trace = sum[0][0] + sum[1][1] + sum[2][2];
        if (!(trace > 0.0f)) return 0.0f;
        Rows power = sum;
        for (auto& row : power)
            for (float& each : row) each /= trace;
        for (int doubling = 0; doubling < 4; ++doubling) {
            Rows square = {};
            for (size_t i = 0; i < 3; ++i)
                for (size_t k = 0; k < 3; ++k)
                    for (size_t m = 0; m < 3; ++m) square[i][k] += power[i][m] * power[m][k];
            power = square;
        }
        float root = power[0][0] + power[1][1] + power[2][2];
        for (int halving = 0; halving < 4; ++halving) root = std::sqrt(root);
        return trace * root;
    }
};

/// Calls `visit(joint, side of the body, number of its code)` for each acting joint of a body that
/// holds rigidly.
class HeldJoints {
  public:
    HeldJoints(const ObjectState& objects, const ActiveLists& active,
               const std::vector<uint8_t>& codes)
        : objects_(objects), codes_(codes) {
        size_t sum = 0;
        for (size_t type = 0; type < joint_type_count; ++type) {
            first_codes_[type] = sum;
            sum += active.awake_joints[type].size();
        }
    }
    void for_each(uint32_t body, auto&& visit) const {
        objects_.for_each_joint(body, [&](uint32_t slot, uint32_t side) {
            const JointRecord& joint = objects_.joints[slot];
            const auto holds = joint_kind(joint.type).holds;
            if (joint.awake_index == none || holds == nullptr || !holds(joint)) return;
            const size_t code = first_codes_[size_t(joint.type)] + joint.awake_index;
            if (codes_[code] != 0) visit(joint, side, code);
        });
    }

  private:
    const ObjectState& objects_;
    const std::vector<uint8_t>& codes_;
    std::array<size_t, joint_type_count> first_codes_;
};

}  // namespace

std::vector<float> shares_of_crowded(const JointSource& source, const ActiveLists& active,
                                     const std::vector<uint8_t>& codes) {
    std::vector<float> shares;
    const HeldJoints held(source.objects, active, codes);
    for (const uint32_t body : source.bodies.maybe_crowded) {
        Strength strength;
        held.for_each(body, [&](const JointRecord& joint, uint32_t side, size_t) {
            const JointEnds ends = source.ends_of(joint);
            const HeldRows rows(joint, ends, source.bodies.solver_bodies[ends.a],
                                source.bodies.solver_bodies[ends.b]);
            strength.add(side == 0 ? rows.a : rows.b, rows.count);
        });
        const float greatest = strength.greatest();
        if (!(greatest > least_strength)) continue;
        shares.resize(codes.size(), 1.0f);
        held.for_each(body, [&](const JointRecord&, uint32_t, size_t code) {
            shares[code] = min(shares[code], strength_of_grid / greatest);
        });
    }
    return shares;
}

}  // namespace fettle::physics::detail
