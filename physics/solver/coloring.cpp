#include <world/world_data.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

// Which contacts act, in which block and with which color. What has to look at every record is
// shared out; the coloring itself, where each contact depends on those before, by the nodes, and
// goes over the little that is left of the records.

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
constexpr size_t piece_length = 256;

/// Stable. `nodes`: those that there are, a bit each.
void order_by_node(std::span<ActingContact> contacts, uint32_t nodes, NodeRanges& ranges) {
    if (std::has_single_bit(nodes)) {
        ranges.count(uint32_t(std::countr_zero(nodes)), uint32_t(contacts.size()));
        ranges.sum_up();
        return;
    }
    for (const ActingContact& c : contacts) ranges.count(c.node);
    ranges.sum_up();
    std::array<ActingContact, piece_length> sorted;
    auto next = ranges.places();
    for (const ActingContact& c : contacts) sorted[next[c.node]++] = c;
    std::copy_n(sorted.begin(), contacts.size(), contacts.begin());
}

/// Contacts and joints of a block that several threads share out. Below that, waiting for each
/// other takes longer. Blocks after the first are many: each is shared out only if it is large.
constexpr size_t least_shared_first = 1000, least_shared = 2 * SolverBlocks::enough_contacts;

}  // namespace

/// The contacts of this step, without gaps but for those between two pieces.
void WorldData::find_acting(float dt) {
    const size_t count = awake_contacts.size();
    const bool serially = settings.solver != Solver::soft_step;  // the others know no groups
    const bool any_hubs = !hubs.empty();
    const bool blocks_stay = blocks.may_be_linked(awake_bodies);
    acting.resize(count);
    acting_pieces.resize((count + piece_length - 1) / piece_length);
    share_out_range(threads, count, piece_length, [&](size_t begin, size_t end) {
        ActingPiece piece;
        piece.begin = uint32_t(begin);
        ActingContact* last = &acting[begin];
        uint32_t nodes = 0;
        for (size_t i = begin; i < end; ++i) {
            const uint32_t slot = awake_contacts[i];
            if (i + contacts_ahead < count) contacts[awake_contacts[i + contacts_ahead]].prefetch();
            const ContactRecord& record = contacts[slot];
            if (record.manifold.count == 0 || record.sensor || record.disabled) continue;
            const SolverEnd a = solver_ends[record.body_a], b = solver_ends[record.body_b];
            const bool one_at_a_time = serially || record.special || record.curved ||
                                       on_locked_axis(record) || passes_corner(record, dt);
            const auto tells = uint8_t((record.touching ? ActingContact::is_touching : 0) |
                                       (record.hit_events ? ActingContact::of_hits : 0));
            ActingContact& c = *last++;
            c = {slot, a, b, 0, 0, node_of(a, b), 0, one_at_a_time, tells};
            if (any_hubs && (a.is_hub() || b.is_hub())) hubs.settle(c, solver_bodies);
            nodes |= 1u << c.node;
            piece.serially += c.serially;
            if (blocks_stay && c.both_move())
                piece.links_blocks |= blocks.block_of(c.a()) != blocks.block_of(c.b());
        }
        order_by_node({&acting[begin], last}, nodes, piece.nodes);
        acting_pieces[begin / piece_length] = piece;
    });
}

/// Those in groups that belong to some nodes.
template <typename Visit>
void WorldData::for_each_acting_of(const StripNodes& nodes, Visit&& visit) {
    for (const ActingPiece& piece : acting_pieces) {
        const uint32_t end = piece.begin + piece.nodes.end(nodes);
        for (uint32_t i = piece.begin + piece.nodes.begin(nodes); i < end; ++i) {
            if (!acting[i].serially) visit(acting[i]);
        }
    }
}

/// Greedy coloring, anew in every step: the lowest color that neither body has yet. What finds none
/// is solved one at a time.
void WorldData::color_nodes(const StripNodes& nodes, std::vector<uint32_t>& left_over) {
    left_over.clear();
    if (nodes.begin < strips.first_leaf()) {
        // Solved at another time than what is below: the colors are free again.
        for_each_acting_of(nodes, [&](const ActingContact& c) {
            if (c.moves_a()) colors_of_body[c.a()] = 0;
            if (c.moves_b()) colors_of_body[c.b()] = 0;
        });
    }
    for_each_acting_of(nodes, [&](ActingContact& c) {
        if (c.hub != 0) hubs.choose_copy(c);
        const uint32_t a = c.a(), b = c.b();
        const uint64_t taken =
            (c.moves_a() ? colors_of_body[a] : 0) | (c.moves_b() ? colors_of_body[b] : 0);
        const int first = c.both_move() ? 0 : moving_colors;
        const int color = first + std::countr_one(taken >> first);
        if (color >= end_of_colors(c.both_move())) {
            c.serially = true;
            if (c.hub != 0) hubs.give_up_copy(c);
            left_over.push_back(uint32_t(&c - acting.data()));
            return;
        }
        if (c.moves_a()) colors_of_body[a] |= uint64_t{1} << color;
        if (c.moves_b()) colors_of_body[b] |= uint64_t{1} << color;
        c.entry = entry_of(c, uint32_t(color));
        c.place = color_begin[c.entry]++;
    });
}

void WorldData::color_contacts() {
    update_blocks();
    make_sections();
    colors_of_body.assign(solver_bodies.size(), 0);
    // Whoever colors some nodes counts for itself: contacts of several of them may be in a block.
    const Sections& plan = cut_sections;
    color_begin.assign(plan.owners() * color_count * first_groups.size(), 0);
    out_of_colors.resize(plan.size());
    SectionLoop(plan, plan.shared() ? threads : nullptr, [&](uint32_t section) {
        color_nodes(plan.nodes_of(section), out_of_colors[section]);
    }).run();
    size_t left_overs = 0;
    for (const std::vector<uint32_t>& left_over : out_of_colors) {
        left_overs += left_over.size();
        for (const uint32_t i : left_over) ++acting_pieces[i / piece_length].serially;
    }
    colored_count -= left_overs;
    if (left_overs > 0 && blocks.size() > 1) {
        make_blocks(false);
        make_sections();
        color_begin.assign(plan.owners() * color_count * first_groups.size(), 0);
        for_each_acting_of(strips.all_nodes(), [&](ActingContact& c) {
            c.entry = entry_of(c, c.entry % color_count);
            c.place = color_begin[c.entry]++;
        });
    }
    list_serial();
    place_lanes();
}

/// Contacts of the same color and section that are counted by the same thread have one entry.
uint32_t WorldData::entry_of(const ActingContact& c, uint32_t color) const {
    const size_t section = cut_sections.owner_of(c.node) * first_groups.size() + section_of(c);
    return uint32_t(section * color_count) + color;
}

/// Which blocks several threads share out, and what each consists of.
void WorldData::make_sections() {
    const auto hands = uint32_t(threads != nullptr ? threads->at_a_time() : 1);
    const uint32_t parts = std::min(strips.count(), std::bit_floor(hands));
    whole_sections = Sections(strips.count(), 1);
    cut_sections = Sections(strips.count(), parts);
    size_t one_by_one = acting_joints();
    for (const ActingPiece& piece : acting_pieces) one_by_one += piece.serially;
    uint32_t next = 0;
    for (size_t i = 0; i < blocks.size(); ++i) {
        SolverBlock& block = blocks[i];
        const size_t work = block.contacts + (i == 0 ? one_by_one : 0);
        block.cut = parts > 1 && work >= (i == 0 ? least_shared_first : least_shared);
        block.first_section = next;
        next += sections_of(block).size();
    }
    first_groups.resize(next + 1);
}

size_t WorldData::section_of(const ActingContact& c) const {
    if (blocks.size() == 1) return sections_of(blocks[0]).of(c.node);
    const SolverBlock& block = blocks[std::max(blocks.block_of(c.a()), blocks.block_of(c.b()))];
    return block.first_section + sections_of(block).of(c.node);
}

/// The blocks of an earlier step will do as long as nothing links two of them.
void WorldData::update_blocks() {
    size_t count = 0, serially = 0;
    bool linked = false;
    for (const ActingPiece& piece : acting_pieces) {
        count += piece.count();
        serially += piece.serially;
        linked |= piece.links_blocks;
    }
    colored_count = count - serially;
    const bool plain =
        serially == 0 && locked.empty() && !driven && hubs.empty() && acting_joints() == 0;
    const bool enough = plain && colored_count >= least_for_blocks;
    const bool several = enough && blocks.may_be_several();
    if (linked || !blocks.may_stay(awake_bodies, several)) make_blocks(several);
    if (blocks.size() == 1) blocks[0].contacts = uint32_t(colored_count);
}

/// Each island in one block, where there is enough for several.
void WorldData::make_blocks(bool several) {
    blocks.begin(uint32_t(awake_bodies.size()) + 1);
    blocks.remember(awake_bodies, several);
    if (!several) {
        blocks.finish_as_one();
        return;
    }
    for_each_acting_of(strips.all_nodes(), [&](const ActingContact& c) {
        if (c.both_move()) blocks.link(c.a(), c.b());
    });
    blocks.find_islands();
    for_each_acting_of(strips.all_nodes(),
                       [&](const ActingContact& c) { blocks.count_contact(c.mover()); });
    blocks.finish();
    if (blocks.are_mostly_one()) make_blocks(false);
}

/// Each colored contact gets a lane of its color in its block.
void WorldData::place_lanes() {
    spare_lanes.clear();
    // From counts to the first lane of each color; every color begins a group of its own.
    uint32_t begin = 0, section = 0;
    const size_t owned = color_count * first_groups.size();
    for (size_t i = 0; i < blocks.size(); ++i) {
        SolverBlock& block = blocks[i];
        block.first_group = begin / lanes;
        for (const uint32_t end = section + sections_of(block).size(); section < end; ++section) {
            first_groups[section] = begin / lanes;
            for (size_t color = 0; color < color_count; ++color) {
                uint32_t last = begin;
                for (size_t k = section * color_count + color; k < color_begin.size(); k += owned)
                    last += std::exchange(color_begin[k], last);
                begin = (last + lanes - 1) / lanes * lanes;
                for (uint32_t lane = last; lane < begin; ++lane) spare_lanes.push_back(lane);
            }
        }
        block.group_end = begin / lanes;
    }
    first_groups.back() = begin / lanes;
    news.resize(begin / lanes);
    lane_contacts.resize(begin);
    for (const uint32_t lane : spare_lanes) lane_contacts[lane] = none;
    share_out(threads, uint32_t(acting_pieces.size()), [&](uint32_t piece) {
        for (uint32_t i = acting_pieces[piece].begin; i < acting_pieces[piece].end(); ++i) {
            ActingContact& c = acting[i];
            if (c.serially) continue;
            c.place += color_begin[c.entry];
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
        wide.friction[lane] = contacts[c.slot].friction;
        from.manifolds[lane] = &contacts[c.slot].manifold;
        from.touching |= uint32_t{c.touching()} << lane;
        from.tells_always |= uint32_t{c.hit_events()} << lane;
    }
}

/// After a group is stored: whose touch begins or ends, and who tells of hits.
void WorldData::note_news(size_t group, const ContactLanes& of) {
    const uint32_t touches = (of.near & ~of.touching) | (of.within_twice & of.touching);
    news[group] = {uint16_t((touches ^ of.touching) | of.tells_always), uint16_t(touches)};
}

}  // namespace fettle::physics::detail
