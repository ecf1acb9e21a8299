#include <world/world_data.h>

#include <algorithm>
#include <bit>
#include <tuple>

// Which contacts act, in which block and with which color. What has to look at every record is
// shared out; the coloring itself, where each contact depends on those before, goes over the little
// that is left of them.

namespace fettle::physics::detail {
namespace {

/// Colors of contacts between two that move, then those with something fixed: solved last, they
/// have the last word.
constexpr int moving_colors = 48;
constexpr int end_of_colors(bool both_move) {
    return both_move ? moving_colors : color_count;
}

/// Worlds with fewer contacts have one block: they are in the cache anyway.
constexpr size_t least_for_blocks = 4000;

/// Contacts that a thread takes at a time.
constexpr size_t piece_length = 512;

}  // namespace

/// The contacts of this step, without gaps but for those between two pieces.
void WorldData::find_acting(float dt) {
    const size_t count = awake_contacts.size();
    const bool serially = settings.solver != Solver::soft_step;  // the others know no groups
    const bool blocks_stay = blocks.may_be_linked(awake_bodies);
    acting.resize(count);
    acting_pieces.resize((count + piece_length - 1) / piece_length);
    share_out_range(threads, count, piece_length, [&](size_t begin, size_t end) {
        ActingPiece piece = {uint32_t(begin), uint32_t(begin)};
        for (size_t i = begin; i < end; ++i) {
            const uint32_t slot = awake_contacts[i];
            if (i + contacts_ahead < count) contacts[awake_contacts[i + contacts_ahead]].prefetch();
            const ContactRecord& record = contacts[slot];
            if (record.manifold.count == 0 || record.sensor || record.disabled) continue;
            ActingContact& c = acting[piece.end++];
            c = {slot, solver_ends[record.body_a], solver_ends[record.body_b], record.friction};
            c.serially = serially || record.special || record.curved || on_locked_axis(record) ||
                         passes_corner(record, dt);
            c.touching = record.touching;
            c.hit_events = record.hit_events;
            piece.serially += c.serially;
            if (blocks_stay && c.both_move())
                piece.links_blocks |= blocks.block_of(c.a()) != blocks.block_of(c.b());
        }
        acting_pieces[begin / piece_length] = piece;
    });
}

/// Greedy coloring, anew in every step: the lowest color that neither body has yet. What finds
/// none, and what needs more than a plain contact, is solved one at a time.
void WorldData::color_contacts() {
    update_blocks();
    colors_of_body.assign(solver_bodies.size(), 0);
    color_begin.assign(blocks.size() * color_count, 0);
    serial_contacts.clear();
    size_t out_of_colors = 0;
    bool not_first = false;
    for (const ActingPiece& piece : acting_pieces) {
        for (uint32_t i = piece.begin; i < piece.end; ++i) {
            ActingContact& c = acting[i];
            const uint32_t a = c.a(), b = c.b();
            const uint64_t taken =
                (c.moves_a() ? colors_of_body[a] : 0) | (c.moves_b() ? colors_of_body[b] : 0);
            const int first = c.both_move() ? 0 : moving_colors;
            const int color = first + std::countr_one(taken >> first);
            if (!c.serially && color >= end_of_colors(c.both_move())) {
                c.serially = true;
                ++out_of_colors;
                not_first |= blocks.block_of(a) != 0 || blocks.block_of(b) != 0;
            }
            if (c.serially) {
                serial_contacts.push_back(c.slot);
                continue;
            }
            if (c.moves_a()) colors_of_body[a] |= uint64_t{1} << color;
            if (c.moves_b()) colors_of_body[b] |= uint64_t{1} << color;
            c.color = uint8_t(color);
            c.place = color_begin[entry_of(c)]++;
        }
    }
    colored_count -= out_of_colors;
    if (not_first) {
        make_blocks(false);
        count_places();
    }
    place_lanes();
}

/// Among what is said of colors and blocks.
size_t WorldData::entry_of(const ActingContact& c) const {
    return size_t(std::max(blocks.block_of(c.a()), blocks.block_of(c.b()))) * color_count + c.color;
}

template <typename Visit>
void WorldData::for_each_colored(Visit&& visit) {
    for (const ActingPiece& piece : acting_pieces) {
        for (uint32_t i = piece.begin; i < piece.end; ++i) {
            if (!acting[i].serially) visit(acting[i]);
        }
    }
}

void WorldData::count_places() {
    color_begin.assign(blocks.size() * color_count, 0);
    for_each_colored([&](ActingContact& c) { c.place = color_begin[entry_of(c)]++; });
}

/// The blocks of an earlier step will do as long as nothing links two of them and nothing must be
/// in the first: which block an island is in changes nothing of its result.
void WorldData::update_blocks() {
    size_t count = 0, serially = 0;
    bool linked = false;
    for (const ActingPiece& piece : acting_pieces) {
        count += piece.end - piece.begin;
        serially += piece.serially;
        linked |= piece.links_blocks;
    }
    const bool plain =
        serially == 0 && locked.empty() && !driven &&
        std::apply([](const auto&... list) { return (list.empty() && ...); }, joint_constraints);
    colored_count = count - serially;
    const bool several = colored_count >= least_for_blocks;
    if (!linked && blocks.may_stay(awake_bodies, plain, several)) return;
    make_blocks(plain);
}

/// Each island in one block, where there is enough for several.
void WorldData::make_blocks(bool plain) {
    const bool several = colored_count >= least_for_blocks;
    blocks.begin(uint32_t(solver_bodies.size()));
    blocks.remember(awake_bodies, plain, several);
    if (!several) {
        blocks.finish_as_one();
        return;
    }
    for (const ActingPiece& piece : acting_pieces) {
        for (uint32_t i = piece.begin; i < piece.end; ++i) {
            const ActingContact& c = acting[i];
            if (c.serially)
                blocks.keep_first(c.a()), blocks.keep_first(c.b());
            else if (c.both_move())
                blocks.link(c.a(), c.b());
            else if (c.a() != 0 && c.b() != 0)
                blocks.keep_first(c.mover());  // touches what moves on its own
        }
    }
    const auto keep_first = [&](const auto& list) {
        for (const auto& c : list) blocks.keep_first(c.ends.a), blocks.keep_first(c.ends.b);
    };
    std::apply([&](const auto&... list) { (keep_first(list), ...); }, joint_constraints);
    for (const uint32_t i : locked) blocks.keep_first(i);
    for (uint32_t i = 1; driven && i < solver_bodies.size(); ++i) {
        if ((solver_ends[awake_bodies[i - 1]] & 1) == 0) blocks.keep_first(i);
    }
    blocks.find_islands();
    for_each_colored([&](const ActingContact& c) { blocks.count_contact(c.mover()); });
    blocks.finish();
}

/// Each colored contact gets a lane of its color in its block.
void WorldData::place_lanes() {
    first_groups.resize(blocks.size() * color_count + 1);
    spare_lanes.clear();
    // From counts to the first lane of each color; every color begins a group of its own.
    uint32_t begin = 0;
    for (size_t entry = 0; entry < color_begin.size(); ++entry) {
        if (entry % color_count == 0) blocks[entry / color_count].first_group = begin / lanes;
        const uint32_t end = begin + color_begin[entry];
        color_begin[entry] = begin;
        first_groups[entry] = begin / lanes;
        begin = (end + lanes - 1) / lanes * lanes;
        for (uint32_t lane = end; lane < begin; ++lane) spare_lanes.push_back(lane);
        if (entry % color_count == color_count - 1)
            blocks[entry / color_count].group_end = begin / lanes;
    }
    first_groups.back() = begin / lanes;
    news.resize(begin / lanes);
    lane_contacts.resize(begin);
    for (const uint32_t lane : spare_lanes) lane_contacts[lane] = none;
    share_out(threads, uint32_t(acting_pieces.size()), [&](uint32_t piece) {
        for (uint32_t i = acting_pieces[piece].begin; i < acting_pieces[piece].end; ++i) {
            ActingContact& c = acting[i];
            if (c.serially) continue;
            c.place += color_begin[entry_of(c)];
            lane_contacts[c.place] = i;
        }
    });
}

/// Before a group is prepared: who is in it.
void WorldData::fill_group(size_t group, WideContact& wide, ContactLanes& from) {
    from.touching = from.tells_always = 0;
    for (uint32_t lane = 0; lane < uint32_t(lanes); ++lane) {
        const uint32_t i = lane_contacts[group * lanes + lane];
        if (i == none) {  // body 0 against itself, without mass
            wide.a[lane] = wide.b[lane] = 0;
            wide.friction[lane] = 0.0f;
            from.spare = {};
            from.manifolds[lane] = &from.spare;
            continue;
        }
        const ActingContact& c = acting[i];
        wide.a[lane] = c.a();
        wide.b[lane] = c.b();
        wide.friction[lane] = c.friction;
        from.manifolds[lane] = &contacts[c.slot].manifold;
        from.touching |= uint32_t{c.touching} << lane;
        from.tells_always |= uint32_t{c.hit_events} << lane;
    }
}

/// After a group is stored: whose touch begins or ends, and who tells of hits.
void WorldData::note_news(size_t group, const ContactLanes& of) {
    const uint32_t touches = (of.near & ~of.touching) | (of.within_twice & of.touching);
    news[group] = {uint16_t((touches ^ of.touching) | of.tells_always), uint16_t(touches)};
}

}  // namespace fettle::physics::detail
