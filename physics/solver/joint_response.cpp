#include <partition/union_find.h>
#include <solver/joint_passes.h>
#include <solver/joint_response.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fettle::physics::detail {
namespace {

/// on·M⁻¹·with for one body.
double weigh(const MassScale& s, const double (&on)[3], const double (&with)[3]) {
    return s.x * s.x * on[0] * with[0] + s.y * s.y * on[1] * with[1] +
           s.turn * s.turn * on[2] * with[2];
}

bool moves(const MassScale& s) {
    return s.x > 0.0 || s.y > 0.0 || s.turn > 0.0;
}

}  // namespace

double JointResponse::Answer::less(const Answer& other) const {
    double sum = 0.0;
    for (size_t i = 0; i < parts.size(); ++i)
        sum += parts[i].velocities.dot(other.parts[i].impulses);
    return sum;
}

void JointResponse::read(const SolverInput& input, float h) {
    const std::vector<SolverBody>& bodies = input.bodies.solver_bodies;
    scales_.assign(bodies.size(), {});
    for (size_t i = 1; i < bodies.size() && i <= input.active.awake_bodies.size(); ++i) {
        const BodyRecord& record = input.objects.bodies[input.active.awake_bodies[i - 1]];
        const double linear = std::sqrt(double(bodies[i].inverse_mass));
        scales_[i] = {record.flags.locked_x ? 0.0 : linear, record.flags.locked_y ? 0.0 : linear,
                      std::sqrt(double(bodies[i].inverse_inertia))};
    }
    std::vector<DirectRow> rows;
    for (size_t i = 0; i < input.joints.joint_arrays.size(); ++i) {
        RowWriter writer(rows, scales_, h, DirectPass::relaxed);
        joint_kind(JointScratch::type_of(i))
            .write_rows(input.joints.joint_arrays[i], input.bodies.solver_bodies, writer);
        for (const DirectRow& row : rows)
            if (row.rigid && row.low == -DirectRow::no_limit && row.high == DirectRow::no_limit)
                rows_.push_back(row);
    }
    find_components();
}

void JointResponse::find_components() {
    UnionFind sets;
    sets.reset(scales_.size());
    for (const DirectRow& row : rows_)
        if (moves(scales_[row.jacobian.a]) && moves(scales_[row.jacobian.b]))
            sets.unite(row.jacobian.a, row.jacobian.b);
    component_of_.assign(scales_.size(), none);
    std::vector<uint32_t> of_root(scales_.size(), none);
    for (uint32_t i = 0; i < rows_.size(); ++i) {
        for (const uint32_t body : {rows_[i].jacobian.a, rows_[i].jacobian.b}) {
            if (!moves(scales_[body]) || component_of_[body] != none) continue;
            uint32_t& component = of_root[sets.find(body)];
            if (component == none) {
                component = uint32_t(components_.size());
                components_.emplace_back();
            }
            component_of_[body] = component;
            components_[component].bodies.push_back(body);
        }
        const Jacobian& j = rows_[i].jacobian;
        const uint32_t component = component_of_[moves(scales_[j.a]) ? j.a : j.b];
        if (component != none) components_[component].rows.push_back(i);
    }
}

double JointResponse::between(const Jacobian& one, const Jacobian& other) const {
    double sum = 0.0;
    if (one.a == other.a) sum += weigh(scales_[one.a], one.on_a, other.on_a);
    if (one.a == other.b) sum += weigh(scales_[one.a], one.on_a, other.on_b);
    if (one.b == other.a) sum += weigh(scales_[one.b], one.on_b, other.on_a);
    if (one.b == other.b) sum += weigh(scales_[one.b], one.on_b, other.on_b);
    return sum;
}

void JointResponse::factorize(Component& component) const {
    const std::vector<uint32_t>& rows = component.rows;
    std::vector<std::pair<uint32_t, uint32_t>> ends;  // body, place of a row on it
    for (uint32_t i = 0; i < rows.size(); ++i)
        for (const uint32_t body : {rows_[rows[i]].jacobian.a, rows_[rows[i]].jacobian.b})
            if (moves(scales_[body])) ends.emplace_back(body, i);
    std::sort(ends.begin(), ends.end());
    std::vector<std::pair<uint32_t, uint32_t>> pairs;  // of rows with a body in common
    for (size_t first = 0, end = 0; first < ends.size(); first = end) {
        while (end < ends.size() && ends[end].first == ends[first].first) ++end;
        for (size_t i = first; i < end; ++i)
            for (size_t k = first; k <= i; ++k) pairs.emplace_back(ends[i].second, ends[k].second);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    // Rows that say the same thing twice would make the matrix singular.
    constexpr double yielding = 1e-9;
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [i, k] : pairs) {
        const double value = between(rows_[rows[i]].jacobian, rows_[rows[k]].jacobian);
        entries.emplace_back(int(i), int(k), i == k ? value * (1.0 + yielding) : value);
    }
    const auto size = Eigen::Index(rows.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    component.factor = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(matrix);
}

JointResponse::Answer JointResponse::answer(const Jacobian& contact) {
    Answer answer;
    answer.contact = contact;
    const uint32_t of_a = component_of_[contact.a], of_b = component_of_[contact.b];
    for (const uint32_t which : {of_a, of_b}) {
        if (which == none || (!answer.parts.empty() && which == of_a)) continue;
        Component& component = components_[which];
        if (component.factor == nullptr) factorize(component);
        Answer::Part& part = answer.parts.emplace_back();
        part.component = which;
        part.velocities.resize(Eigen::Index(component.rows.size()));
        for (size_t i = 0; i < component.rows.size(); ++i)
            part.velocities[Eigen::Index(i)] = between(rows_[component.rows[i]].jacobian, contact);
        part.impulses = component.factor->solve(part.velocities);
        if (component.factor->info() != Eigen::Success || !part.impulses.allFinite())
            part.impulses.setZero(part.velocities.size());
    }
    return answer;
}

void JointResponse::push(const Jacobian& row, double impulse, std::span<SolverBody> bodies) const {
    const auto add = [&](uint32_t body, const double(&on)[3]) {
        const MassScale& s = scales_[body];
        if (!moves(s)) return;
        SolverBody& b = bodies[body];
        b.velocity.x += float(impulse * s.x * s.x * on[0]);
        b.velocity.y += float(impulse * s.y * s.y * on[1]);
        b.angular_velocity += float(impulse * s.turn * s.turn * on[2]);
    };
    add(row.a, row.on_a);
    add(row.b, row.on_b);
}

}  // namespace fettle::physics::detail
