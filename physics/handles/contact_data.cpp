#include <contacts/reports.h>
#include <world/world_data.h>

#include <algorithm>
#include <stdexcept>

// Numbers of the host for contacts. A contact of two shapes may consist of many records, one for
// each touching part, so a number belongs to the pair. Few contacts have one, so they are a list of
// their own: a step without them pays nothing.

namespace fettle::physics {

using namespace detail;

namespace {

ContactId pair_of(const ContactUserData& entry) {
    return {entry.shape_a, entry.shape_b};
}

/// The place of the entry of a pair in the sorted list, or the place where it would be inserted.
auto place_of(auto& entries, const ContactId& pair) {
    return std::lower_bound(
        entries.begin(), entries.end(), pair,
        [](const ContactUserData& entry, const ContactId& id) { return pair_of(entry) < id; });
}

}  // namespace

namespace detail {

/// At the beginning of a step. Until then the numbers of ended contacts can be read.
void WorldData::clear_ended_contacts() {
    std::erase_if(contact_user_data, [](const ContactUserData& entry) { return entry.ended; });
}

void WorldData::mark_ended_contacts() {
    for (ContactUserData& entry : contact_user_data)
        entry.ended = !is_valid(entry.shape_a) || !is_valid(entry.shape_b) ||
                      !touch(*this, entry.shape_a.index, entry.shape_b.index);
}

}  // namespace detail

uint64_t World::contact_data(const ContactId& id) const {
    const ContactId pair = ContactId::of(id.shape_a, id.shape_b);
    const auto place = place_of(data_->contact_user_data, pair);
    const bool found = place != data_->contact_user_data.end() && pair_of(*place) == pair;
    return found ? place->user_data : 0;
}

void World::set_contact_data(const ContactId& id, uint64_t user_data) {
    WorldData& data = edit(__func__);
    const ContactId pair = ContactId::of(id.shape_a, id.shape_b);
    const auto place = place_of(data.contact_user_data, pair);
    const bool found = place != data.contact_user_data.end() && pair_of(*place) == pair;
    if (user_data == 0) {
        if (found) data.contact_user_data.erase(place);
    } else if (!is_touching(pair)) {
        throw std::invalid_argument("World::set_contact_data: the two shapes do not touch");
    } else if (found) {
        *place = {pair.shape_a, pair.shape_b, user_data};
    } else {
        data.contact_user_data.insert(place, {pair.shape_a, pair.shape_b, user_data});
    }
}

}  // namespace fettle::physics
