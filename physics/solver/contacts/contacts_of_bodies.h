#pragma once

#include <state/step_scratch.h>

#include <span>
#include <vector>

namespace fettle::physics::detail {

/// The acting contacts of each awake body, one body after the other in one array. A walk from body
/// to body reads much less memory here than in the lists of the bodies, whose elements are far from
/// each other.
class ContactsOfBodies {
  public:
    struct Contact {
        uint32_t slot;
        uint32_t other;  ///< index of the other body in the solver
    };

    ContactsOfBodies(const ContactScratch& contacts, size_t solver_bodies)
        : begins_(solver_bodies + 1, 0) {
        const auto for_each_end = [&](auto&& visit) {
            for (const ActingPiece& piece : contacts.acting_pieces) {
                for (uint32_t i = piece.begin; i < piece.end(); ++i) {
                    const ActingContact& c = contacts.acting[i];
                    if (c.a() != 0) visit(c.a(), Contact{c.slot, c.b()});
                    if (c.b() != 0) visit(c.b(), Contact{c.slot, c.a()});
                }
            }
        };
        // First the end of the range of each body; entering the contacts from the last place on
        // makes it the beginning.
        for_each_end([&](uint32_t body, Contact) { ++begins_[body]; });
        uint32_t sum = 0;
        for (uint32_t& begin : begins_) begin = sum += begin;
        contacts_.resize(sum);
        for_each_end([&](uint32_t body, Contact c) { contacts_[--begins_[body]] = c; });
    }

    /// `body`: index in the solver, not 0.
    std::span<const Contact> of(uint32_t body) const {
        return {contacts_.data() + begins_[body], contacts_.data() + begins_[body + 1]};
    }

  private:
    std::vector<uint32_t> begins_;  ///< by index in the solver
    std::vector<Contact> contacts_;
};

}  // namespace fettle::physics::detail
