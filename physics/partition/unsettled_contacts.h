#pragma once

#include <constraints/solver_body.h>
#include <partition/union_find.h>

#include <span>
#include <utility>
#include <vector>

// A relax pass takes the velocities of impacts and corrections away from one contact after the
// other, and each gives a part of it to the next one. What is left would throw a stack of crates
// that lands up again. So contacts that a pass leaves unsettled are relaxed again, with all
// contacts of the same bodies.
//
// Unsettled contacts that share a moving body are a row. These rows get no more passes:
// - long ones, and those in the middle of a heap, where most contacts of their bodies are settled:
//   they would take a quarter of the step of a heap that is stirred, where nobody sees the impacts
//   one by one;
// - those with a jointed body, because its joints are not solved with the contacts;
// - those with a kinematic body in motion, because what it presses may have no solution.
// The rows do not depend on the order of the contacts, nor on what is elsewhere in the world.

namespace fettle::physics::detail {

class UnsettledContacts {
  public:
    /// The greatest numbers of further passes over a row, of its contacts, and of all contacts of
    /// its bodies for each of them.
    static constexpr int most_passes = 12;
    static constexpr uint32_t longest_row = 128, most_around = 2;

    /// `bodies`: the number of solver bodies.
    void begin(std::size_t bodies);
    /// Called for each contact that the first pass left unsettled: its bodies. `jointed`: one of
    /// them has a joint.
    void add(std::span<const SolverBody> bodies, uint32_t a, uint32_t b, bool jointed);
    bool empty() const { return contacts_.empty(); }
    /// Called after the last `add`: finds the rows. False if all of them are too long.
    bool find_rows();

    /// True if a contact of these bodies belongs to a row that is relaxed again.
    bool are_in_row(uint32_t a, uint32_t b) const { return (row_of_[a] | row_of_[b]) != 0; }
    /// Called for each contact of the world that is in a row: its bodies.
    void count(std::span<const SolverBody> bodies, uint32_t a, uint32_t b);
    /// Called after the last `count`: leaves out rows in the middle of a heap, and those that a
    /// kinematic body presses. False if no row is left.
    bool leave_out_heaps();

    /// True if the present pass relaxes a contact of these bodies.
    bool are_relaxed(uint32_t a, uint32_t b) const {
        return relaxed_[row_of_[a]] || relaxed_[row_of_[b]];
    }
    /// The present pass leaves a contact of these bodies unsettled: the next one relaxes its rows.
    void leave(uint32_t a, uint32_t b) { left_[row_of_[a]] = left_[row_of_[b]] = 1; }
    /// Begins the next pass. False if all rows are settled.
    bool next_pass();

    /// Scratch: nothing is kept from step to step.
    static void scratch(auto& io, auto& self) {
        io(self.contacts_), io(self.bodies_), io(self.row_of_), io(self.groups_.parent);
        io(self.sizes_), io(self.unsettled_), io(self.around_), io(self.relaxed_), io(self.left_);
    }

  private:
    void list(uint32_t body);

    std::vector<std::pair<uint32_t, uint32_t>> contacts_;  // the bodies; 0: one that does not move
    std::vector<uint32_t> bodies_;                         // of these contacts
    std::vector<uint32_t> row_of_;                         // by body; 0: none
    UnionFind groups_;
    std::vector<uint32_t> sizes_;               // by body: contacts of the group whose root it is
    std::vector<uint32_t> unsettled_, around_;  // by row: contacts
    std::vector<uint8_t> relaxed_, left_;       // by row
};

}  // namespace fettle::physics::detail
