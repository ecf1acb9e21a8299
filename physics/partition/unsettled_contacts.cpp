#include <partition/unsettled_contacts.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// True for a kinematic body in motion.
bool is_driven(const SolverBody& body) {
    return !moves(body) &&
           (body.velocity.x != 0.0f || body.velocity.y != 0.0f || body.angular_velocity != 0.0f);
}

constexpr uint32_t listed = ~uint32_t{0};  // in `row_of_`, until the rows are known

}  // namespace

void UnsettledContacts::begin(size_t bodies) {
    for (const uint32_t body : bodies_) row_of_[body] = 0;
    contacts_.clear();
    bodies_.clear();
    row_of_.resize(bodies);
    groups_.parent.resize(bodies);
    sizes_.resize(bodies);
}

void UnsettledContacts::list(uint32_t body) {
    if (body == 0 || row_of_[body] == listed) return;
    row_of_[body] = listed;
    groups_.parent[body] = body;
    sizes_[body] = 0;
    bodies_.push_back(body);
}

void UnsettledContacts::add(std::span<const SolverBody> bodies, uint32_t a, uint32_t b,
                            bool jointed) {
    if (!moves(bodies[a])) a = 0;
    if (!moves(bodies[b])) b = 0;
    contacts_.emplace_back(a, b);
    list(a);
    list(b);
    // With a contact more, the row is too long.
    if (jointed) sizes_[a != 0 ? a : b] = longest_row;
}

bool UnsettledContacts::find_rows() {
    for (const auto& [a, b] : contacts_)
        if (a != 0 && b != 0) groups_.unite(a, b);
    for (const uint32_t body : bodies_)
        if (groups_.parent[body] != body) sizes_[groups_.find(body)] += sizes_[body];
    for (const auto& [a, b] : contacts_)
        if ((a | b) != 0) ++sizes_[groups_.find(a != 0 ? a : b)];
    unsettled_.assign(1, 0);  // row 0: none
    for (const uint32_t body : bodies_) {
        if (groups_.parent[body] != body) continue;
        const bool is_short = sizes_[body] <= longest_row;
        row_of_[body] = is_short ? uint32_t(unsettled_.size()) : 0;
        if (is_short) unsettled_.push_back(sizes_[body]);
    }
    for (const uint32_t body : bodies_) row_of_[body] = row_of_[groups_.find(body)];
    around_.assign(unsettled_.size(), 0);
    return unsettled_.size() > 1;
}

void UnsettledContacts::count(std::span<const SolverBody> bodies, uint32_t a, uint32_t b) {
    // With more contacts around it than any row may have, the row is left out.
    constexpr uint32_t many = most_around * longest_row + 1;
    const uint32_t contacts = is_driven(bodies[a]) || is_driven(bodies[b]) ? many : 1;
    around_[row_of_[a]] += contacts;
    if (row_of_[b] != row_of_[a]) around_[row_of_[b]] += contacts;
}

bool UnsettledContacts::leave_out_heaps() {
    const auto is_in_heap = [&](uint32_t row) {
        return around_[row] > most_around * unsettled_[row];
    };
    for (const uint32_t body : bodies_)
        if (is_in_heap(row_of_[body])) row_of_[body] = 0;
    relaxed_.assign(unsettled_.size(), 0);
    left_.assign(unsettled_.size(), 0);
    for (uint32_t row = 1; row < unsettled_.size(); ++row) relaxed_[row] = !is_in_heap(row);
    return std::find(relaxed_.begin(), relaxed_.end(), 1) != relaxed_.end();
}

bool UnsettledContacts::next_pass() {
    relaxed_.swap(left_);
    relaxed_[0] = 0;
    std::fill(left_.begin(), left_.end(), uint8_t{0});
    return std::find(relaxed_.begin(), relaxed_.end(), 1) != relaxed_.end();
}

}  // namespace fettle::physics::detail
