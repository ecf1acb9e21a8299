#include <solver/crowded_joints.h>
#include <state/active_lists.h>

#include <array>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// Bodies of a lower strength are not crowded. A node of a grid has 2.
constexpr float least_strength = 2.5f, strength_of_grid = 2.0f;

/// Calls `visit(number of its code, joint)` for each acting joint that holds rigidly.
void for_each_held(const ObjectState& objects, const ActiveLists& active,
                   const std::vector<uint8_t>& codes, auto&& visit) {
    size_t code = 0;
    for (size_t type = 0; type < joint_type_count; ++type) {
        const auto& awake = active.awake_joints[type];
        const auto holds = joint_kind(JointType(type)).holds;
        for (size_t i = 0; holds != nullptr && i < awake.size(); ++i) {
            const JointRecord& joint = objects.joints[awake[i]];
            if (codes[code + i] != 0 && holds(joint)) visit(code + i, joint);
        }
        code += awake.size();
    }
}

// --- A bound without the current levers ----------------------------------------------------------

/// The parts of a body in the directions and in the angle of its joints, if the other bodies did
/// not turn. Most bodies need no closer look.
struct Bound {
    float along = 0.0f, turn = 0.0f;
    Vec2 arms;  ///< sum, in the coordinates of the body: 0 if the joints are all around
    float lengths = 0.0f;
    uint32_t count = 0;
    bool welded = false;

    bool may_be_crowded() const {
        constexpr uint32_t least_joints = 3;
        if (count < least_joints) return false;
        if (welded) return true;
        const float aside = lengths > 0.0f ? (std::abs(arms.x) + std::abs(arms.y)) / lengths : 0.0f;
        const float half = 0.5f * (along - turn);
        const float greatest =
            0.5f * (along + turn) + std::sqrt(half * half + aside * aside * along * turn);
        return greatest > 1.05f * least_strength;  // a grid that is fixed to the world has 2.6
    }
};

std::vector<Bound> bounds_of(const JointSource& source, const ActiveLists& active,
                             const std::vector<uint8_t>& codes) {
    const std::vector<SolverBody>& bodies = source.bodies.solver_bodies;
    std::vector<Bound> bounds(bodies.size());
    for_each_held(source.objects, active, codes, [&](size_t, const JointRecord& joint) {
        uint32_t index[2];
        for (const size_t side : {0, 1})
            index[side] = source.bodies.solver_ends[joint.bodies[side]].index();
        const float inverse = bodies[index[0]].inverse_mass + bodies[index[1]].inverse_mass;
        for (const size_t side : {0, 1}) {
            const SolverBody& body = bodies[index[side]];
            if (body.inverse_mass == 0.0f) continue;
            const Vec2 arm =
                Vec2(joint.anchors[side]) - source.objects.bodies[joint.bodies[side]].local_center;
            const float by_turn = body.inverse_inertia * dot(arm, arm);
            Bound& bound = bounds[index[side]];
            bound.along += body.inverse_mass / inverse;
            bound.turn += by_turn / (inverse + by_turn);
            bound.arms = bound.arms + arm;
            bound.lengths += std::abs(arm.x) + std::abs(arm.y);
            bound.welded |= joint.type == JointType::weld;
            ++bound.count;
        }
    });
    return bounds;
}

// --- The strength of the joints of a body --------------------------------------------------------

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

}  // namespace

std::vector<float> shares_of_crowded(const JointSource& source, const ActiveLists& active,
                                     const std::vector<uint8_t>& codes) {
    if (codes.empty()) return {};
    const std::vector<Bound> bounds = bounds_of(source, active, codes);
    std::vector<uint32_t> places;  // by solver body: in `strengths`
    std::vector<Strength> strengths;
    for (size_t i = 1; i < bounds.size(); ++i) {
        if (!bounds[i].may_be_crowded()) continue;
        if (places.empty()) places.assign(bounds.size(), none);
        places[i] = uint32_t(strengths.size());
        strengths.emplace_back();
    }
    if (strengths.empty()) return {};
    const auto places_of = [&](const JointRecord& joint) {
        const auto place = [&](uint32_t body) {
            return places[source.bodies.solver_ends[body].index()];
        };
        return std::array{place(joint.bodies[0]), place(joint.bodies[1])};
    };
    for_each_held(source.objects, active, codes, [&](size_t, const JointRecord& joint) {
        const auto [at_a, at_b] = places_of(joint);
        if (at_a == none && at_b == none) return;
        const JointEnds ends = source.ends_of(joint);
        const HeldRows rows(joint, ends, source.bodies.solver_bodies[ends.a],
                            source.bodies.solver_bodies[ends.b]);
        if (at_a != none) strengths[at_a].add(rows.a, rows.count);
        if (at_b != none) strengths[at_b].add(rows.b, rows.count);
    });
    std::vector<float> greatest;
    bool any = false;
    for (const Strength& strength : strengths) {
        greatest.push_back(strength.greatest());
        any = any || greatest.back() > least_strength;
    }
    if (!any) return {};
    std::vector<float> shares(codes.size(), 1.0f);
    for_each_held(source.objects, active, codes, [&](size_t code, const JointRecord& joint) {
        float strength = 0.0f;
        for (const uint32_t at : places_of(joint))
            if (at != none) strength = max(strength, greatest[at]);
        if (strength > least_strength) shares[code] = strength_of_grid / strength;
    });
    return shares;
}

}  // namespace fettle::physics::detail
