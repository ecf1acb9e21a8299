#include <collision/collide_solids.h>
#include <contacts/flush_shapes.h>
#include <contacts/kept_manifold.h>
#include <contacts/moving_point.h>
#include <contacts/narrow_phase.h>
#include <contacts/overlaps/wedged_bodies.h>
#include <contacts/pairs.h>
#include <geometry/make_room.h>
#include <state/active_lists.h>
#include <state/limits.h>

#include <algorithm>
#include <bit>

namespace fettle::physics::detail {
namespace {

/// Number of contacts that are collided before their results are read; they must fit into the
/// cache.
constexpr size_t run_length = 64;  // one bit each
/// Numbers of contacts and moved shapes in a task of a thread.
constexpr size_t contacts_of_piece = 128, moved_at_a_time = 512;

bool is_segment(const ShapeForm& form) {
    return form.kind == FormKind::convex && form.count == 2;
}

/// A shape that touches a two-sided segment stays on its side, however deep it is.
void keep_side(const ObjectState& objects, const Columns& columns, ContactRecord& c, float margin,
               Vec2 old_normal) {
    const bool first = is_segment(objects.forms[c.shape_a]);
    const uint32_t segment = first ? c.shape_a : c.shape_b, other = first ? c.shape_b : c.shape_a;
    if (objects.forms[other].kind == FormKind::border) return;
    Manifold& m = c.manifold;
    const Vec2 side = first ? old_normal : -old_normal;
    const Vec2 now = first ? m.normal : -m.normal;
    if (m.count > 0 && dot(side, now) >= 0.0f) return;
    const Solid sheet = solid_of(objects, columns, segment);
    if (std::fabs(dot(side, sheet.form.normals[0])) < 0.7f) return;  // it touched an end
    const Vec2 offset = objects.forms[other].center - objects.forms[segment].center;
    Manifold kept = {};
    collide_on_side(sheet, solid_of(objects, columns, other), side, offset, margin, kept);
    if (kept.count == 0) return;
    if (!first) swap_shapes(kept);
    m = kept;
}

}  // namespace

void update_manifold(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
                     ContactRecord& c) {
    Manifold& m = c.manifold;
    const Vec2 old_normal = m.normal;
    const OldPoints old = OldPoints::of(m);
    m.count = 0;
    const ShapeForm &a = objects.forms[c.shape_a], &b = objects.forms[c.shape_b];
    const float margin = c.sensor ? 0.0f : speculative_margin;
    if (usual_forms(a, b))
        collide(objects.convex(c.shape_a), objects.convex(c.shape_b), b.center - a.center, margin,
                m);
    else
        collide_special_forms(objects, columns, settings, c, margin, old.count > 0, m);
    if (old.count > 0 && !c.sensor && c.skipped == Skipped::no && (is_segment(a) || is_segment(b)))
        keep_side(objects, columns, c, margin, old_normal);
    old.give_impulses(m);
}

namespace {

class Collision {
  public:
    explicit Collision(const NarrowPhaseInput& input)
        : in_(input),
          arrays_{input.objects.pool.vertices.data(), input.objects.pool.directions.data(),
                  input.objects.pool.offsets.data()},
          keeps_(input.settings.solver == Solver::soft_step),
          moment_(moment_of_geometry(input.settings.substeps)) {}

    /// Computes the manifolds of some awake contacts, and lists which contacts need more work.
    void run(std::span<const uint32_t> slots, size_t begin, size_t end, CollidedPiece& piece) {
        uint64_t over = 0, computed = 0, known = 0, flush_ones = 0;
        uint32_t features[run_length];
        for (size_t i = begin; i < end; ++i) {
            if (i + contacts_ahead < slots.size())
                in_.objects.contacts[slots[i + contacts_ahead]].prefetch();
            ContactRecord& c = in_.objects.contacts[slots[i]];
            const bool ends = is_over(c);
            over |= uint64_t{ends} << (i - begin);
            if (c.kept && c.manifold.count == 1) {
                known |= uint64_t{1} << (i - begin);
                features[i - begin] = c.manifold.points[0].feature;
            } else if (c.kept && keeps_ && !ends && follow_bodies(in_.objects, slots[i], c)) {
                continue;
            }
            c.kept = false;
            if (ends || !is_near(c)) {
                c.manifold.count = 0;
            } else {
                if (may_be_flush(in_.objects, c)) {
                    flush_ones |= uint64_t{1} << (i - begin);
                    before_[i - begin] = OldPoints::of(c.manifold);
                }
                collide_pair(c);
                computed |= uint64_t{may_keep(in_.objects, c)} << (i - begin);
            }
        }
        if (batch_.count > 0) flush();
        for (uint64_t left = flush_ones; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            const uint32_t slot = slots[begin + size_t(i)];
            const uint64_t bit = uint64_t{1} << i;
            if (in_.objects.contacts[slot].manifold.count > 0)
                piece.flush.push_back({slot, (known & bit) != 0, before_[i]}), computed &= ~bit;
            else
                flush_ones &= ~bit;
        }
        for (; computed != 0; computed &= computed - 1)
            keep_manifold(in_.objects, slots[begin + size_t(std::countr_zero(computed))]);
        for (size_t i = begin; i < end; ++i) {
            const uint32_t slot = slots[i];
            const uint64_t bit = uint64_t{1} << (i - begin);
            if ((over & bit) != 0) piece.over.push_back(slot);
            if ((flush_ones & bit) == 0)
                complete(slot, (known & bit) != 0, features[i - begin], piece);
        }
    }

    /// The rest of the work for contacts that depend on other pairs, when all pairs are known.
    void finish_flush(CollidedPiece& piece) {
        for (const FlushContact& flush : piece.flush) {
            push_with_common_outline(in_, flush.slot, flush.before);
            if (may_keep(in_.objects, in_.objects.contacts[flush.slot]))
                keep_manifold(in_.objects, flush.slot);
            complete(flush.slot, flush.known, flush.before.features[0], piece);
        }
        if (piece.flush.empty()) return;
        const std::vector<ContactRecord>& contacts = in_.objects.contacts;
        std::sort(piece.more.begin(), piece.more.end(), [&](uint32_t first, uint32_t second) {
            return contacts[first].awake_index < contacts[second].awake_index;
        });
    }

  private:
    /// `known`: the geometry of the point `feature` in the last step is stored.
    void complete(uint32_t slot, bool known, uint32_t feature, CollidedPiece& piece) {
        const ContactRecord& c = in_.objects.contacts[slot];
        if (keeps_ && has_moving_point(c))
            continue_point(in_.objects, slot, known && feature == c.manifold.points[0].feature,
                           moment_);
        if (needs_more(c)) piece.more.push_back(slot);
    }
    bool is_over(const ContactRecord& c) const {
        return (in_.scratch.relocated[c.shape_a] | in_.scratch.relocated[c.shape_b]) != 0 &&
               !overlap(in_.boxes.fat_boxes[c.shape_a], in_.boxes.fat_boxes[c.shape_b]);
    }
    bool is_near(const ContactRecord& c) const {
        const float margin = c.sensor ? 0.0f : speculative_margin;
        return overlap(grow(in_.boxes.boxes[c.shape_a], margin), in_.boxes.boxes[c.shape_b]);
    }
    void collide_pair(ContactRecord& c) {
        const ShapeForm &a = in_.objects.forms[c.shape_a], &b = in_.objects.forms[c.shape_b];
        if (!a.is_small_polygon() || !b.is_small_polygon()) {
            update_manifold(in_.objects, in_.columns, in_.settings, c);
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
        // Unused lanes repeat the first pair; their results are ignored.
        for (int lane = batch_.count; lane < CollisionBatch::size; ++lane) {
            batch_.begin_a[lane] = batch_.begin_a[0];
            batch_.begin_b[lane] = batch_.begin_b[0];
            batch_.manifolds[lane] = &unused_;
        }
        for (uint32_t again = in_.kernels.collide(arrays_, batch_); again != 0;
             again &= again - 1) {
            const int lane = std::countr_zero(again);
            if (lane < batch_.count)
                update_manifold(in_.objects, in_.columns, in_.settings, *records_[lane]);
        }
        batch_.count = 0;
    }
    bool needs_more(const ContactRecord& c) const {
        const bool active = c.manifold.count > 0;
        if (c.sensor) return active != c.touching;
        if (!active) return c.touching || c.rolling_impulse != 0.0f || c.skipped != Skipped::no;
        if (may_be_wedged(c)) return true;
        return in_.objects.island_slots.count > 0 &&
               (in_.objects.bodies[c.body_a].asleep() || in_.objects.bodies[c.body_b].asleep());
    }

    const NarrowPhaseInput in_;  ///< a copy: one indirection less in the loops
    const ConvexArrays arrays_;
    const bool keeps_;  ///< manifolds are kept: not for the other solvers, whose contacts are rigid
    const float moment_;  ///< of the geometry of moving points
    CollisionBatch batch_ = {};
    ContactRecord* records_[CollisionBatch::size] = {};
    Manifold unused_;
    OldPoints before_[run_length];  ///< of contacts that other shapes may change
};

/// The rare work after a manifold: ends a touch, or wakes a sleeping body that is about to be hit.
void process_pair(const NarrowPhaseInput& in, uint32_t slot) {
    ContactRecord& c = in.objects.contacts[slot];
    const std::vector<BodyRecord>& bodies = in.objects.bodies;
    const bool active = c.manifold.count > 0;
    if (c.sensor) {
        if (active != c.touching) set_touching(in.list.touching, slot, active);
    } else if (!active) {
        if (c.touching) set_touching(in.list.touching, slot, false);
        c.rolling_impulse = 0.0f;
        c.skipped = Skipped::no;
    } else if (bodies[c.body_a].asleep() && in_motion(in.objects, in.columns, c.body_b)) {
        // A sleeping body that is about to be hit takes part in the current step.
        wake_body(in.activity, c.body_a);
    } else if (bodies[c.body_b].asleep() && in_motion(in.objects, in.columns, c.body_a)) {
        wake_body(in.activity, c.body_b);
    }
    if (!c.sensor && active && may_be_wedged(c)) {
        part_wedged(in.list.touching, slot);
        if (is_pressed(in.objects, c)) in.scratch.pressed.push_back(slot);
    }
}

/// Marks that all pairs of the fat boxes of these shapes are known.
void mark_paired(const NarrowPhaseInput& in, std::span<const uint32_t> moved) {
    for (const uint32_t shape : moved) {
        in.objects.shapes[shape].moved = false;
        in.boxes.paired_boxes[shape] = in.boxes.fat_boxes[shape];
    }
}

/// Computes the manifolds of the contacts `slots`. Those that need more work are listed in the
/// pieces from `first` on; returns the end of these pieces. At the same time, `beside(i)` is called
/// for each i below `others`.
size_t collide_awake(const NarrowPhaseInput& in, std::span<const uint32_t> slots, size_t first,
                     uint32_t others, auto&& beside) {
    std::vector<CollidedPiece>& collided = in.scratch.collided;
    const size_t pieces = (slots.size() + contacts_of_piece - 1) / contacts_of_piece;
    if (collided.size() < first + pieces) collided.resize(first + pieces);
    parallel_for(in.threads, others + uint32_t(pieces), [&](uint32_t block) {
        if (block < others) {
            beside(block);
            return;
        }
        Collision collision(in);
        CollidedPiece& piece = collided[first + block - others];
        piece.clear();
        const size_t begin = (block - others) * contacts_of_piece;
        const size_t end = std::min(begin + contacts_of_piece, slots.size());
        for (size_t i = begin; i < end; i += run_length)
            collision.run(slots, i, std::min(i + run_length, end), piece);
    });
    return first + pieces;
}

/// Finishes the contacts that depend on other pairs, in the pieces from `first` to `last`.
void finish_flush(const NarrowPhaseInput& in, size_t first, size_t last) {
    std::vector<CollidedPiece>& collided = in.scratch.collided;
    size_t contacts = 0;
    for (size_t i = first; i < last; ++i) contacts += collided[i].flush.size();
    if (contacts == 0) return;
    const auto finish = [&](uint32_t i) {
        if (!collided[first + i].flush.empty()) Collision(in).finish_flush(collided[first + i]);
    };
    const auto pieces = uint32_t(last - first);
    if (contacts >= contacts_of_piece) {
        parallel_for(in.threads, pieces, finish);
    } else {
        for (uint32_t i = 0; i < pieces; ++i) finish(i);
    }
}

/// One thread creates the new contacts while the other threads collide the old ones.
size_t collide_and_create(const NarrowPhaseInput& in) {
    const std::vector<uint64_t>& new_pairs = in.scratch.new_pairs;
    std::vector<uint32_t>& moved_shapes = in.boxes.moved_shapes;
    std::vector<uint32_t>& awake = in.active.awake_contacts;
    std::vector<ContactRecord>& contacts = in.objects.contacts;
    make_room(awake, new_pairs.size());
    const size_t spare = contacts.size() - in.objects.contact_slots.count;
    const size_t more = new_pairs.size() - std::min(new_pairs.size(), spare);
    make_room(contacts, more);
    make_room(in.objects.manifold_poses, more);
    // Other threads read the numbers of contacts: `may_be_flush`.
    for (const uint64_t pair : new_pairs)
        count_contact(in.objects, uint32_t(pair), uint32_t(pair >> 32));
    const size_t moved = moved_shapes.size();
    const auto marks = uint32_t((moved + moved_at_a_time - 1) / moved_at_a_time);
    return collide_awake(in, awake, 0, moved == 0 ? 0 : 1 + marks, [&](uint32_t i) {
        if (i == 0) {
            create_contacts(in.list, in.settings, new_pairs);
            return;
        }
        const size_t begin = (i - 1) * moved_at_a_time;
        mark_paired(
            in, std::span(moved_shapes).subspan(begin, std::min(moved_at_a_time, moved - begin)));
    });
}

/// Calls `visit` for each new contact between bodies that both rest, while some body sleeps.
void for_each_resting(const NarrowPhaseInput& in, auto&& visit) {
    if (in.objects.island_slots.count == 0) return;
    for (const uint64_t pair : in.scratch.new_pairs) {
        ContactRecord& c =
            in.objects.contacts[in.list.pairs.find(uint32_t(pair), uint32_t(pair >> 32))];
        if (c.awake_index == none) visit(c);
    }
}

/// Wakes sleeping bodies at sensors of bodies that do not move. Otherwise the sensors would not
/// report them, since contacts of two bodies that both rest are not collided.
void wake_for_sensors(const NarrowPhaseInput& in) {
    if (in.objects.sensors == 0) return;
    for_each_resting(in, [&](const ContactRecord& c) {
        if (!c.sensor) return;
        for (const uint32_t body : {c.body_a, c.body_b})
            if (in.objects.bodies[body].asleep()) wake_body(in.activity, body);
    });
}

/// Collides new contacts of bodies that were put to sleep before the pair was known: such a body
/// lies on what is below it, and wakes when that is removed.
void collide_resting(const NarrowPhaseInput& in) {
    for_each_resting(in, [&](ContactRecord& c) {
        if (!c.sensor) update_manifold(in.objects, in.columns, in.settings, c);
    });
}

}  // namespace

void narrow_phase(const NarrowPhaseInput& in) {
    std::vector<uint32_t>& awake = in.active.awake_contacts;
    std::vector<CollidedPiece>& collided = in.scratch.collided;
    size_t collided_contacts = awake.size(), processed = 0;
    in.scratch.pressed.clear();
    size_t pieces = collide_and_create(in);
    finish_flush(in, 0, pieces);
    wake_for_sensors(in);
    collide_resting(in);
    // New contacts are collided in another round. So are contacts that wake when the listed pairs
    // are processed.
    for (;;) {
        const std::span slots = std::span(awake).subspan(collided_contacts);
        collided_contacts = awake.size();
        if (!slots.empty()) {
            const size_t first = pieces;
            pieces = collide_awake(in, slots, first, 0, [](uint32_t) {});
            finish_flush(in, first, pieces);
            for (size_t i = first; i < pieces; ++i)
                for (const FlushContact& flush : collided[i].flush)
                    drop_kept_beside(in, flush.slot);
        }
        for (; processed < pieces; ++processed)
            for (const uint32_t slot : collided[processed].more) process_pair(in, slot);
        if (collided_contacts == awake.size()) break;
    }
    collided.resize(pieces);
    // All contacts are collided, so the order of the list may change now. The rest of the work for
    // ended pairs can wait until the bodies are finished.
    for (const CollidedPiece& piece : collided)
        for (const uint32_t slot : piece.over) remove_awake_contact(in.objects, in.active, slot);
    for (const uint32_t shape : in.boxes.moved_shapes) in.scratch.relocated[shape] = 0;
    in.boxes.moved_shapes.clear();
}

void end_pairs(const ContactList& list, PairScratch& scratch) {
    for (CollidedPiece& piece : scratch.collided) {
        for (const uint32_t slot : piece.over) destroy_contact(list, slot);
        piece.over.clear();
    }
}

}  // namespace fettle::physics::detail
