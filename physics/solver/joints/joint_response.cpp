#include <partition/union_find.h>
#include <solver/accounting.h>
#include <solver/joints/joint_passes.h>
#include <solver/joints/joint_response.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fettle::physics::detail {
namespace {

/// on·M⁻¹·with for one body.
double weighted_dot(const MassScale& s, const double (&on)[3], const double (&with)[3]) {
    return s.x * s.x * on[0] * with[0] + s.y * s.y * on[1] * with[1] +
           s.turn * s.turn * on[2] * with[2];
}

}  // namespace

double JointResponse::Reaction::reduction(const Reaction& other) const {
    double sum = 0.0;
    for (size_t i = 0; i < parts.size(); ++i)
        sum += parts[i].velocities.dot(other.parts[i].impulses);
    return sum;
}

JointResponse::JointResponse(const SolverInput& input, float h)
    : input_(input), h_(h), scales_(mass_scales(input)) {
    list_joints();
}

/// Each list is in the order of the arrays.
void JointResponse::list_joints() {
    UnionFind sets;
    sets.reset(scales_.size());
    std::vector<uint32_t> ends;  // a body that moves, of each joint; or 0
    const auto& arrays = input_.joints.joint_arrays;
    for (uint32_t array = 0; array < arrays.size(); ++array) {
        for (uint32_t i = 0; i < arrays[array].joints.size(); ++i) {
            const auto [a, b] = input_.objects.joints[arrays[array].joints[i]].bodies;
            const uint32_t end_a = input_.bodies.solver_ends[a].index(),
                           end_b = input_.bodies.solver_ends[b].index();
            const bool moves_a = scales_[end_a].moves(), moves_b = scales_[end_b].moves();
            if (moves_a && moves_b) sets.unite(end_a, end_b);
            joints_.push_back({array, i, none});
            ends.push_back(moves_a ? end_a : moves_b ? end_b : 0);
        }
    }
    first_joints_.assign(scales_.size(), none);
    for (uint32_t i = uint32_t(joints_.size()); i-- > 0;)
        if (ends[i] != 0) joints_[i].next = std::exchange(first_joints_[sets.find(ends[i])], i);
    for (uint32_t body = 0; body < scales_.size(); ++body)
        first_joints_[body] = first_joints_[sets.find(body)];
    component_of_.assign(joints_.size(), none);
}

uint32_t JointResponse::component_of(uint32_t body) {
    const uint32_t first = first_joints_[body];
    if (first == none) return none;
    if (component_of_[first] == none) {
        component_of_[first] = uint32_t(components_.size());
        read(first, components_.emplace_back());
    }
    return component_of_[first];
}

void JointResponse::read(uint32_t first_joint, Component& component) {
    std::vector<DirectRow> rows;
    for (uint32_t i = first_joint; i != none; i = joints_[i].next) {
        const auto [array, index, next] = joints_[i];
        const size_t first_row = component.rows.size();
        RowWriter writer(rows, scales_, h_, DirectPass::relaxed);
        joint_kind(JointScratch::type_of(array))
            .write_rows(input_.joints.joint_arrays[array], input_.bodies.solver_bodies, writer,
                        {index, index + 1});
        for (const DirectRow& row : rows) {
            if (!row.rigid || row.low != -DirectRow::no_limit || row.high != DirectRow::no_limit ||
                row.kept == nullptr)
                continue;
            component.rows.push_back(row);
            component.rows.back().impulse = 0.0;
            for (const uint32_t body : {row.jacobian.a, row.jacobian.b}) {
                if (scales_[body].moves()) component.bodies.push_back(body);
                component.driven |= is_driven(body);
            }
        }
        component.members.push_back({array, index, first_row, component.rows.size()});
    }
    std::sort(component.bodies.begin(), component.bodies.end());
    component.bodies.erase(std::unique(component.bodies.begin(), component.bodies.end()),
                           component.bodies.end());
    factorize(component);
}

double JointResponse::between(const Jacobian& one, const Jacobian& other) const {
    double sum = 0.0;
    if (one.a == other.a) sum += weighted_dot(scales_[one.a], one.on_a, other.on_a);
    if (one.a == other.b) sum += weighted_dot(scales_[one.a], one.on_a, other.on_b);
    if (one.b == other.a) sum += weighted_dot(scales_[one.b], one.on_b, other.on_a);
    if (one.b == other.b) sum += weighted_dot(scales_[one.b], one.on_b, other.on_b);
    return sum;
}

void JointResponse::factorize(Component& component) const {
    const std::vector<DirectRow>& rows = component.rows;
    std::vector<std::pair<uint32_t, uint32_t>> ends;  // body, place of a row on it
    for (uint32_t i = 0; i < rows.size(); ++i)
        for (const uint32_t body : {rows[i].jacobian.a, rows[i].jacobian.b})
            if (scales_[body].moves()) ends.emplace_back(body, i);
    std::sort(ends.begin(), ends.end());
    std::vector<std::pair<uint32_t, uint32_t>> pairs;  // of rows with a body in common
    for (size_t first = 0, end = 0; first < ends.size(); first = end) {
        while (end < ends.size() && ends[end].first == ends[first].first) ++end;
        for (size_t i = first; i < end; ++i)
            for (size_t k = first; k <= i; ++k) pairs.emplace_back(ends[i].second, ends[k].second);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    // Redundant rows would make the matrix singular.
    constexpr double yielding = 1e-9;
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [i, k] : pairs) {
        const double value = between(rows[i].jacobian, rows[k].jacobian);
        entries.emplace_back(int(i), int(k), i == k ? value * (1.0 + yielding) : value);
    }
    const auto size = Eigen::Index(rows.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    component.factor = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(matrix);
}

JointResponse::Reaction JointResponse::reaction_to(const Jacobian& contact) {
    Reaction reaction;
    reaction.contact = contact;
    const uint32_t of_a = component_of(contact.a), of_b = component_of(contact.b);
    for (const uint32_t which : {of_a, of_b}) {
        if (which == none || (!reaction.parts.empty() && which == of_a)) continue;
        const Component& component = components_[which];
        Reaction::Part& part = reaction.parts.emplace_back();
        part.component = which;
        part.velocities.resize(Eigen::Index(component.rows.size()));
        for (size_t i = 0; i < component.rows.size(); ++i)
            part.velocities[Eigen::Index(i)] = between(component.rows[i].jacobian, contact);
        part.impulses = component.factor->solve(part.velocities);
        if (component.factor->info() != Eigen::Success || !part.impulses.allFinite())
            part.impulses.setZero(part.velocities.size());
    }
    return reaction;
}

double JointResponse::forbidden(const Reaction& reaction,
                                std::span<const SolverBody> bodies) const {
    const auto speed = [&](uint32_t body, const double(&on)[3]) {
        const SolverBody& b = bodies[body];
        return on[0] * double(b.velocity.x) + on[1] * double(b.velocity.y) +
               on[2] * double(b.angular_velocity);
    };
    double sum = 0.0;
    for (const Reaction::Part& part : reaction.parts) {
        const std::vector<DirectRow>& rows = components_[part.component].rows;
        for (size_t i = 0; i < rows.size(); ++i) {
            const Jacobian& row = rows[i].jacobian;
            sum +=
                part.impulses[Eigen::Index(i)] * (speed(row.a, row.on_a) + speed(row.b, row.on_b));
        }
    }
    return sum;
}

bool JointResponse::is_driven(uint32_t body) const {
    const SolverBody& b = input_.bodies.solver_bodies[body];
    return body != 0 && !scales_[body].moves() &&
           (length_squared(b.velocity) > 0.0f || b.angular_velocity != 0.0f);
}

bool JointResponse::are_driven(const Reaction& reaction) const {
    return is_driven(reaction.contact.a) || is_driven(reaction.contact.b) ||
           std::any_of(reaction.parts.begin(), reaction.parts.end(),
                       [&](const auto& part) { return components_[part.component].driven; });
}

bool JointResponse::are_held(const Reaction& reaction, double mobility) const {
    // Bodies that are free as a whole yield at least as their mass does. The far end of a slender
    // lever gets seven times as fast as the place at which it yields by this part of that.
    constexpr double least = 1.0 / 16;
    double mass = 0.0;
    for (const Reaction::Part& part : reaction.parts)
        for (const uint32_t body : components_[part.component].bodies)
            if (const double scale = std::max(scales_[body].x, scales_[body].y); scale > 0.0)
                mass += 1.0 / (scale * scale);
    return mobility * mass < least;
}

void JointResponse::push(DirectRow& row, double impulse, std::span<SolverBody> bodies) const {
    row.impulse += impulse;
    const auto add = [&](uint32_t body, const double(&on)[3]) {
        const MassScale& s = scales_[body];
        if (!s.moves()) return;
        SolverBody& b = bodies[body];
        b.velocity.x += float(impulse * s.x * s.x * on[0]);
        b.velocity.y += float(impulse * s.y * s.y * on[1]);
        b.angular_velocity += float(impulse * s.turn * s.turn * on[2]);
    };
    add(row.jacobian.a, row.jacobian.on_a);
    add(row.jacobian.b, row.jacobian.on_b);
}

void JointResponse::report() const {
    if (!input_.sums.empty())
        for (const Component& component : components_)
            for (const Member& member : component.members) add_to_sums(component, member);
    for (Strain& strain : input_.joints.strains) {
        for (const uint32_t body : input_.objects.joints[strain.joint].bodies) {
            const uint32_t first = first_joints_[input_.bodies.solver_ends[body].index()];
            if (first == none || component_of_[first] == none) continue;
            add_to_strain(components_[component_of_[first]], strain);
            break;
        }
    }
}

void JointResponse::add_to_sums(const Component& component, const Member& member) const {
    const uint32_t joint = input_.joints.joint_arrays[member.array].joints[member.index];
    for (size_t i = member.first_row; i < member.row_end; ++i) {
        const Jacobian& row = component.rows[i].jacobian;
        const double impulse = component.rows[i].impulse;
        if (impulse == 0.0) continue;
        add_to_joint(input_.sums, joint, row.a, row.on_a, impulse);
        add_to_joint(input_.sums, joint, row.b, row.on_b, impulse);
    }
}

/// The load of a joint is linear in its impulses, so it shows what those of the reactions add.
void JointResponse::add_to_strain(const Component& component, Strain& strain) const {
    const auto member = std::lower_bound(component.members.begin(), component.members.end(), strain,
                                         [](const Member& one, const Strain& other) {
                                             return std::pair(one.array, one.index) <
                                                    std::pair(other.array, other.index);
                                         });
    if (member == component.members.end() || member->array != strain.array ||
        member->index != strain.index)
        return;
    const JointArray& array = input_.joints.joint_arrays[member->array];
    const auto load_of = joint_kind(JointScratch::type_of(member->array)).load;
    const JointLoad before = load_of(array, member->index);
    const std::span rows(component.rows.data() + member->first_row,
                         member->row_end - member->first_row);
    std::vector<float> kept;
    for (const DirectRow& row : rows) {
        kept.push_back(*row.kept);
        *row.kept += float(row.impulse);
    }
    const JointLoad after = load_of(array, member->index);
    for (size_t i = 0; i < rows.size(); ++i) *rows[i].kept = kept[i];
    strain.force = strain.force + (after.push - before.push);
    strain.torque += after.twist - before.twist;
}

}  // namespace fettle::physics::detail
