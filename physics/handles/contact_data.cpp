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

ContactId pair_of(const ContactNote& note) {
    return {note.shape_a, note.shape_b};
}

/// The place of the note of a pair in the sorted list, or where it would be.
auto place_of(auto& notes, const ContactId& pair) {
    return std::lower_bound(
        notes.begin(), notes.end(), pair,
        [](const ContactNote& note, const ContactId& id) { return pair_of(note) < id; });
}

}  // namespace

namespace detail {

/// At the beginning of a step. Until then the numbers of ended contacts can be read.
void WorldData::clear_ended_contacts() {
    std::erase_if(contact_notes, [](const ContactNote& note) { return note.ended; });
}

void WorldData::note_ended_contacts() {
    for (ContactNote& note : contact_notes)
        note.ended = !is_valid(note.shape_a) || !is_valid(note.shape_b) ||
                     !touch(*this, note.shape_a.index, note.shape_b.index);
}

}  // namespace detail

uint64_t World::contact_data(const ContactId& id) const {
    const ContactId pair = ContactId::of(id.shape_a, id.shape_b);
    const auto place = place_of(data_->contact_notes, pair);
    const bool found = place != data_->contact_notes.end() && pair_of(*place) == pair;
    return found ? place->user_data : 0;
}

void World::set_contact_data(const ContactId& id, uint64_t user_data) {
    WorldData& data = edit(__func__);
    const ContactId pair = ContactId::of(id.shape_a, id.shape_b);
    const auto place = place_of(data.contact_notes, pair);
    const bool found = place != data.contact_notes.end() && pair_of(*place) == pair;
    if (user_data == 0) {
        if (found) data.contact_notes.erase(place);
    } else if (!is_touching(pair)) {
        throw std::invalid_argument("World::set_contact_data: the two shapes do not touch");
    } else if (found) {
        *place = {pair.shape_a, pair.shape_b, user_data};
    } else {
        data.contact_notes.insert(place, {pair.shape_a, pair.shape_b, user_data});
    }
}

}  // namespace fettle::physics
