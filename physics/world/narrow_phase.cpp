#include <geometry/growth.h>
#include <world/world_data.h>

#include <algorithm>
#include <bit>

// Every awake contact gets its manifold of this step. Pairs of triangles and quadrilaterals are
// collected and collided sixteen at a time, the others one by one; both write nothing but the
// manifold and a note of what the pair needs besides. Then, in the order of the list, what few
// need: touches that end, pairs that are none any more, sleepers that are about to be hit.

namespace fettle::physics::detail {
namespace {

/// Contacts between two looks at what came out: few enough that they are still in the cache.
constexpr size_t run_length = 64;  // a bit each
/// Contacts that a thread takes at a time, and shapes.
constexpr size_t piece_length = 128, moved_at_a_time = 512;

}  // namespace

/// One pair by itself.
void WorldData::update_manifold(ContactRecord& c) {
    const Manifold old = c.manifold;
    Manifold& m = c.manifold;
    m.count = 0;
    const ShapeForm &a = forms[c.shape_a], &b = forms[c.shape_b];
    const float margin = c.sensor ? 0.0f : speculative_margin;
    if (usual_forms(a, b))
        collide(convex(c.shape_a), convex(c.shape_b), b.center - a.center, margin, m);
    else
        collide_unusual(c, margin, old.count > 0, m);
    // Points that are still the same vertex on the same edge go on with their impulses: the warm
    // start.
    for (int i = 0; i < m.count; ++i) {
        for (int k = 0; k < old.count; ++k) {
            if (old.points[k].feature != m.points[i].feature) continue;
            m.points[i].normal_impulse = old.points[k].normal_impulse;
            m.points[i].tangent_impulse = old.points[k].tangent_impulse;
            break;
        }
    }
}

class NarrowPhase {
  public:
    explicit NarrowPhase(WorldData& world)
        : world_(world),
          arrays_{world.pool.vertices.data(), world.pool.directions.data(),
                  world.pool.offsets.data()},
          kernels_(wide_kernels(world.most_lanes)) {}

    /// Manifolds of some of the awake contacts, and what they ask for.
    void run(std::span<const uint32_t> slots, size_t begin, size_t end, CollidedPiece& piece) {
        uint64_t over = 0;
        for (size_t i = begin; i < end; ++i) {
            if (i + contacts_ahead < slots.size())
                world_.contacts[slots[i + contacts_ahead]].prefetch();
            ContactRecord& c = world_.contacts[slots[i]];
            const bool ends = is_over(c);
            over |= uint64_t{ends} << (i - begin);
            if (ends || !is_near(c))
                c.manifold.count = 0;
            else
                collide_pair(c);
        }
        if (batch_.count > 0) flush();
        for (size_t i = begin; i < end; ++i) {
            const uint32_t slot = slots[i];
            if ((over >> (i - begin) & 1) != 0) piece.over.push_back(slot);
            if (needs_more(world_.contacts[slot])) piece.more.push_back(slot);
        }
    }

  private:
    bool is_over(const ContactRecord& c) const {
        return (world_.relocated[c.shape_a] | world_.relocated[c.shape_b]) != 0 &&
               !overlap(world_.fat_boxes[c.shape_a], world_.fat_boxes[c.shape_b]);
    }
    bool is_near(const ContactRecord& c) const {
        const float margin = c.sensor ? 0.0f : speculative_margin;
        return overlap(grow(world_.boxes[c.shape_a], margin), world_.boxes[c.shape_b]);
    }
    void collide_pair(ContactRecord& c) {
        const ShapeForm &a = world_.forms[c.shape_a], &b = world_.forms[c.shape_b];
        if (!a.is_small_polygon() || !b.is_small_polygon()) {
            world_.update_manifold(c);
            return;
        }
        const int lane = batch_.count++;
        records_[lane] = &c;
        batch_.manifolds[lane] = &c.manifold;
        batch_.begin_a[lane] = a.begin;
        batch_.begin_b[lane] = b.begin;
        batch_.count_a[lane] = int32_t(a.count);
        batch_.count_b[lane] = int32_t(b.count);
        batch_.radius_a[lane] = a.radius;
        batch_.radius_b[lane] = b.radius;
        batch_.offset_x[lane] = b.center.x - a.center.x;
        batch_.offset_y[lane] = b.center.y - a.center.y;
        batch_.margin[lane] = c.sensor ? 0.0f : speculative_margin;
        if (batch_.is_full()) flush();
    }
    void flush() {
        // Lanes that are left over do the first pair again, for nobody.
        for (int lane = batch_.count; lane < CollisionBatch::size; ++lane) {
            batch_.begin_a[lane] = batch_.begin_a[0];
            batch_.begin_b[lane] = batch_.begin_b[0];
            batch_.manifolds[lane] = &unused_;
        }
        for (uint32_t again = kernels_.collide(arrays_, batch_); again != 0; again &= again - 1) {
            const int lane = std::countr_zero(again);
            if (lane < batch_.count) world_.update_manifold(*records_[lane]);
        }
        batch_.count = 0;
    }
    bool needs_more(const ContactRecord& c) const {
        const bool active = c.manifold.count > 0;
        if (c.sensor) return active != c.touching;
        if (!active) return c.touching || c.rolling_impulse != 0.0f;
        return world_.island_slots.count > 0 &&
               (world_.bodies[c.body_a].asleep() || world_.bodies[c.body_b].asleep());
    }

    WorldData& world_;
    const ConvexArrays arrays_;
    const WideKernels& kernels_;
    CollisionBatch batch_ = {};
    ContactRecord* records_[CollisionBatch::size] = {};
    Manifold unused_;
};

/// What a manifold asks for besides.
void WorldData::follow_note(ContactRecord& c, uint32_t slot) {
    const bool active = c.manifold.count > 0;
    if (c.sensor) {
        if (active != c.touching) set_touching(touching(), slot, active);
    } else if (!active) {
        if (c.touching) set_touching(touching(), slot, false);
        c.rolling_impulse = 0.0f;
    } else if (bodies[c.body_a].asleep() && in_motion(*this, *this, c.body_b)) {
        // Whoever is asleep and about to be hit takes part in this very step.
        wake_body(activity(), c.body_a);
    } else if (bodies[c.body_b].asleep() && in_motion(*this, *this, c.body_a)) {
        wake_body(activity(), c.body_b);
    }
}

/// Manifolds of those contacts, and what they ask for, in pieces from `first` on; returns the end
/// of those. `beside(i)` for each i below `others`: meanwhile.
template <typename Work>
size_t WorldData::collide_awake(std::span<const uint32_t> slots, size_t first, uint32_t others,
                                Work&& beside) {
    const size_t pieces = (slots.size() + piece_length - 1) / piece_length;
    if (collided.size() < first + pieces) collided.resize(first + pieces);
    share_out(threads, others + uint32_t(pieces), [&](uint32_t block) {
        if (block < others) {
            beside(block);
            return;
        }
        NarrowPhase phase(*this);
        CollidedPiece& piece = collided[first + block - others];
        piece.clear();
        const size_t begin = (block - others) * piece_length;
        const size_t end = std::min(begin + piece_length, slots.size());
        for (size_t i = begin; i < end; i += run_length)
            phase.run(slots, i, std::min(i + run_length, end), piece);
    });
    return first + pieces;
}

/// Contacts are made one after the other. Whoever is free meanwhile collides those there are.
size_t WorldData::collide_and_create() {
    make_room(awake_contacts, new_pairs.size());
    const size_t spare = contacts.size() - contact_slots.count;
    make_room(contacts, new_pairs.size() - std::min(new_pairs.size(), spare));
    const size_t moved = moved_shapes.size();
    const auto marks = uint32_t((moved + moved_at_a_time - 1) / moved_at_a_time);
    return collide_awake(awake_contacts, 0, moved == 0 ? 0 : 1 + marks, [&](uint32_t i) {
        if (i == 0) {
            create_contacts();
            return;
        }
        const size_t begin = (i - 1) * moved_at_a_time;
        mark_paired(
            std::span(moved_shapes).subspan(begin, std::min(moved_at_a_time, moved - begin)));
    });
}

void WorldData::narrow_phase() {
    size_t collided_contacts = awake_contacts.size(), noted = 0;
    size_t pieces = collide_and_create();
    // What is new is collided in a round of its own, and so is what the notes wake.
    for (;;) {
        const std::span slots = std::span(awake_contacts).subspan(collided_contacts);
        collided_contacts = awake_contacts.size();
        if (!slots.empty()) pieces = collide_awake(slots, pieces, 0, [](uint32_t) {});
        for (; noted < pieces; ++noted)
            for (const uint32_t slot : collided[noted].more) follow_note(contacts[slot], slot);
        if (collided_contacts == awake_contacts.size()) break;
    }
    collided.resize(pieces);
    // Now that all are collided the last can take the place of one that goes. What else is to do
    // for it can wait until the bodies are finished.
    for (const CollidedPiece& piece : collided)
        for (const uint32_t slot : piece.over) remove_awake_contact(*this, *this, slot);
    if (!moved_shapes.empty()) std::ranges::fill(relocated, uint8_t{0});
    moved_shapes.clear();
}

/// Of pairs that are none any more. They have no manifold, and nobody asks for them until they go.
void WorldData::end_pairs() {
    for (CollidedPiece& piece : collided) {
        for (const uint32_t slot : piece.over) destroy_contact(slot);
        piece.over.clear();
    }
}

}  // namespace fettle::physics::detail
