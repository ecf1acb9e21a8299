#include <partition/union_find.h>
#include <schedule/schedule.h>
#include <schedule/serial_criteria.h>
#include <state/limits.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

// There are two parallel stages. In the first, threads share ranges of the contact records. In the
// coloring, the color of a contact depends on the contacts before it, so threads share nodes; the
// coloring reads only the short list of acting contacts.

namespace fettle::physics::detail {
namespace {

/// The first colors are for contacts between two moving bodies. Contacts with a fixed body have the
/// other colors: they are solved last, so that they are the most exact.
constexpr int moving_colors = 48;
constexpr int color_count = 64;
constexpr int end_of_colors(bool both_move) {
    return both_move ? moving_colors : color_count;
}

/// Worlds with fewer contacts have one block: all their contacts fit into the cache.
constexpr size_t least_for_blocks = 4000;

/// Number of contacts in a task of a thread.
constexpr size_t piece_length = 256;

/// Stable sort by node. `nodes`: the nodes of the contacts, one bit each.
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

/// Several threads share a block with at least this number of contacts and joints; with fewer, they
/// would wait longer than they work. Behind the first block there are many others, and each is
/// solved by one thread unless it is large.
constexpr size_t least_shared_first = 1000, least_shared = 2 * SolverBlocks::enough_contacts;

/// This number of bodies of the solver fills half of the second-level cache of a core. Each color
/// of a section reads and writes all bodies of the section. So in a larger heap each strip is a
/// section of its own, also if one thread solves several of them.
constexpr size_t cached_bodies = (size_t{1} << 19) / sizeof(SolverBody);

struct Coloring {
    std::span<const uint32_t> awake_bodies;
    const BodyScratch& bodies;
    const Strips& strips;
    size_t joints;
    ContactScratch& contacts;
    ScheduleScratch& schedule;
    ThreadPool* threads;
    SolverBlocks& blocks = schedule.blocks;
    std::vector<ActingContact>& acting = contacts.acting;

    /// Visits the contacts in groups that belong to these nodes.
    void for_each_acting_of(const StripNodes& nodes, auto&& visit) {
        for (const ActingPiece& piece : contacts.acting_pieces) {
            const uint32_t end = piece.begin + piece.nodes.end(nodes);
            for (uint32_t i = piece.begin + piece.nodes.begin(nodes); i < end; ++i) {
                if (!acting[i].serially) visit(acting[i]);
            }
        }
    }

    /// Greedy coloring, repeated in every step: a contact gets the lowest color that neither body
    /// has yet. If no color is left, the contact is solved one at a time.
    void color_nodes(const StripNodes& nodes, std::vector<uint32_t>& left_over) {
        left_over.clear();
        if (nodes.begin < strips.first_leaf()) {
            // Nodes are not solved at the same time as the nodes below them, so all colors are free
            // again.
            for_each_acting_of(nodes, [&](const ActingContact& c) {
                if (c.moves_a()) schedule.colors_of_body[c.a()] = 0;
                if (c.moves_b()) schedule.colors_of_body[c.b()] = 0;
            });
        }
        for_each_acting_of(nodes, [&](ActingContact& c) {
            if (c.hub != 0) schedule.hubs.choose_copy(c);
            const uint32_t a = c.a(), b = c.b();
            const uint64_t taken = (c.moves_a() ? schedule.colors_of_body[a] : 0) |
                                   (c.moves_b() ? schedule.colors_of_body[b] : 0);
            const int first = c.both_move() ? 0 : moving_colors;
            const int color = first + std::countr_one(taken >> first);
            if (color >= end_of_colors(c.both_move())) {
                c.serially = true;
                if (c.hub != 0) schedule.hubs.use_hub_itself(c);
                left_over.push_back(uint32_t(&c - acting.data()));
                return;
            }
            if (c.moves_a()) schedule.colors_of_body[a] |= uint64_t{1} << color;
            if (c.moves_b()) schedule.colors_of_body[b] |= uint64_t{1} << color;
            c.entry = entry_of(c, uint32_t(color));
            c.place = schedule.color_begin[c.entry]++;
        });
    }

    /// Threads that color different nodes have separate counts, because contacts of several nodes
    /// may be in one block.
    void begin_counts() {
        schedule.color_begin.assign(
            schedule.cut_sections.owners() * color_count * schedule.first_groups.size(), 0);
    }

    void color() {
        schedule.colors_of_body.assign(bodies.solver_bodies.size(), 0);
        begin_counts();
        const Sections& plan = schedule.cut_sections;
        schedule.out_of_colors.resize(plan.size());
        SectionLoop(plan, plan.shared() ? threads : nullptr, [&](uint32_t section) {
            color_nodes(plan.nodes_of(section), schedule.out_of_colors[section]);
        }).run();
        size_t left_overs = 0;
        for (const std::vector<uint32_t>& left_over : schedule.out_of_colors) {
            left_overs += left_over.size();
            for (const uint32_t i : left_over) ++contacts.acting_pieces[i / piece_length].serially;
        }
        contacts.colored_count -= left_overs;
        if (left_overs > 0 && blocks.size() > 1) unite_blocks();
    }

    /// Contacts that are solved one at a time require a single block.
    void unite_blocks() {
        make_blocks(false);
        make_sections();
        begin_counts();
        for_each_acting_of(strips.all_nodes(), [&](ActingContact& c) {
            c.entry = entry_of(c, c.entry % color_count);
            c.place = schedule.color_begin[c.entry]++;
        });
    }

    /// The index of the count for a color and section, for the thread that counts it.
    uint32_t entry_of(const ActingContact& c, uint32_t color) const {
        const size_t section =
            schedule.cut_sections.owner_of(c.node) * schedule.first_groups.size() + section_of(c);
        return uint32_t(section * color_count) + color;
    }

    /// Decides which blocks several threads share or one solves strip by strip, and numbers the
    /// sections of all blocks.
    void make_sections() {
        const auto workers = uint32_t(threads != nullptr ? threads->at_a_time() : 1);
        const bool strip_by_strip = blocks.size() == 1 && awake_bodies.size() > cached_bodies;
        const uint32_t parts =
            strip_by_strip ? strips.count() : std::min(strips.count(), std::bit_floor(workers));
        schedule.whole_sections = Sections(strips.count(), 1);
        schedule.cut_sections = Sections(strips.count(), parts);
        size_t one_by_one = joints;
        for (const ActingPiece& piece : contacts.acting_pieces) one_by_one += piece.serially;
        uint32_t next = 0;
        for (size_t i = 0; i < blocks.size(); ++i) {
            SolverBlock& block = blocks[i];
            const size_t work = block.contacts + (i == 0 ? one_by_one : 0);
            block.cut = parts > 1 && work >= (i == 0 ? least_shared_first : least_shared);
            block.first_section = next;
            next += schedule.sections_of(block).size();
        }
        schedule.first_groups.resize(next + 1);
    }

    size_t section_of(const ActingContact& c) const {
        if (blocks.size() == 1) return schedule.sections_of(blocks[0]).of(c.node);
        const SolverBlock& block = blocks[std::max(blocks.block_of(c.a()), blocks.block_of(c.b()))];
        return block.first_section + schedule.sections_of(block).of(c.node);
    }

    /// Keeps the blocks of an earlier step while no contact links two of them.
    void update_blocks() {
        size_t count = 0, serially = 0;
        bool linked = false;
        for (const ActingPiece& piece : contacts.acting_pieces) {
            count += piece.count();
            serially += piece.serially;
            linked |= piece.links_blocks;
        }
        contacts.colored_count = count - serially;
        const bool plain = serially == 0 && bodies.locked.empty() && !bodies.driven &&
                           schedule.hubs.empty() && joints == 0;
        const bool enough = plain && contacts.colored_count >= least_for_blocks;
        const bool several = enough && blocks.may_be_several();
        if (linked || !blocks.may_stay(awake_bodies, several)) make_blocks(several);
        if (blocks.size() == 1) blocks[0].contacts = uint32_t(contacts.colored_count);
    }

    /// `several`: whole islands are distributed to several blocks.
    void make_blocks(bool several) {
        blocks.begin(uint32_t(awake_bodies.size()) + 1);
        blocks.set_bodies(awake_bodies, several);
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

    /// Gives each colored contact a lane in the groups of its color in its block.
    void place_lanes() {
        contacts.spare_lanes.clear();
        // Converts counts to the first lane of each color; every color begins a new group.
        uint32_t begin = 0, section = 0;
        const size_t owned = color_count * schedule.first_groups.size();
        for (size_t i = 0; i < blocks.size(); ++i) {
            SolverBlock& block = blocks[i];
            block.first_group = begin / group_size;
            for (const uint32_t end = section + schedule.sections_of(block).size(); section < end;
                 ++section) {
                schedule.first_groups[section] = begin / group_size;
                for (size_t color = 0; color < color_count; ++color) {
                    uint32_t last = begin;
                    for (size_t k = section * color_count + color; k < schedule.color_begin.size();
                         k += owned)
                        last += std::exchange(schedule.color_begin[k], last);
                    begin = (last + group_size - 1) / group_size * group_size;
                    for (uint32_t lane = last; lane < begin; ++lane)
                        contacts.spare_lanes.push_back(lane);
                }
            }
            block.group_end = begin / group_size;
        }
        schedule.first_groups.back() = begin / group_size;
        contacts.group_results.resize(begin / group_size);
        contacts.lane_contacts.resize(begin);
        for (const uint32_t lane : contacts.spare_lanes) contacts.lane_contacts[lane] = none;
        parallel_for(threads, uint32_t(contacts.acting_pieces.size()), [&](uint32_t piece) {
            for (uint32_t i = contacts.acting_pieces[piece].begin;
                 i < contacts.acting_pieces[piece].end(); ++i) {
                ActingContact& c = acting[i];
                if (c.serially) continue;
                c.place += schedule.color_begin[c.entry];
                contacts.lane_contacts[c.place] = i;
            }
        });
    }

    /// Lists the contacts that are computed one at a time, in the order of the nodes.
    void list_single() {
        list(contacts.serial, &ActingPiece::serially,
             [](const ActingContact& c) { return c.serially; });
        list(contacts.passing, &ActingPiece::passing,
             [](const ActingContact& c) { return c.passes_impacts(); });
        for (size_t load = 1; load < contacts.loaded.size(); ++load) list_loaded(load);
    }
    void list_loaded(size_t load) {
        LoadedContacts& into = contacts.loaded[load];
        into.nodes.clear();
        into.serial.clear();
        for (uint32_t i = 0; i < contacts.serial.acting.size(); ++i) {
            const ActingContact& c = acting[contacts.serial.acting[i]];
            if (c.load() != load) continue;
            into.nodes.count(c.node);
            into.serial.push_back(i);
        }
        into.nodes.sum_up();
    }
    void list(SingleContacts& into, uint32_t ActingPiece::*expected, auto&& belongs) {
        const auto for_each = [&](auto&& visit) {
            for (const ActingPiece& piece : contacts.acting_pieces) {
                if (piece.*expected == 0) continue;
                for (uint32_t i = piece.begin; i < piece.end(); ++i)
                    if (belongs(acting[i])) visit(i);
            }
        };
        into.nodes.clear();
        for_each([&](uint32_t i) { into.nodes.count(acting[i].node); });
        into.nodes.sum_up();
        into.acting.resize(into.nodes.size());
        auto next = into.nodes.places();
        for_each([&](uint32_t i) { into.acting[next[acting[i].node]++] = i; });
    }
};

/// True if some point of the contact approaches faster than `threshold`.
bool approaches(const ContactRecord& record, const SolverBody& a, const SolverBody& b,
                float threshold) {
    const Vec2 n = record.manifold.normal;
    for (int k = 0; k < record.manifold.count; ++k) {
        const ManifoldPoint& point = record.manifold.points[k];
        const float velocity = dot(n, b.velocity - a.velocity) +
                               cross(point.anchor_b, n) * b.angular_velocity -
                               cross(point.anchor_a, n) * a.angular_velocity;
        if (velocity < -threshold) return true;
    }
    return false;
}

/// Contacts whose shapes approach fast are solved one at a time. Their impact can reach the whole
/// heap in this step (the bodies that joints, and contacts that take impacts, connect); the other
/// contacts of the heap pass the impact on.
void choose_bouncing(const ObjectState& objects, const ActiveLists& active,
                     const BodyScratch& bodies, ContactScratch& scratch) {
    UnionFind heaps;
    heaps.reset(bodies.solver_bodies.size());
    const auto for_each = [&](auto&& visit) {
        for (ActingPiece& piece : scratch.acting_pieces)
            for (uint32_t i = piece.begin; i < piece.end(); ++i)
                if (scratch.acting[i].takes_impacts()) visit(scratch.acting[i], piece);
    };
    const auto index = [&](uint32_t body) { return bodies.solver_ends[body].index(); };
    const auto bodies_of = [&](const ActingContact& c) {
        const ContactRecord& record = objects.contacts[c.slot];
        return std::pair(index(record.body_a), index(record.body_b));
    };
    for_each([&](const ActingContact& c, const ActingPiece&) {
        const auto [a, b] = bodies_of(c);
        if (c.both_move()) heaps.unite(a, b);
    });
    for (const auto& list : active.awake_joints) {
        for (const uint32_t joint : list) {
            const auto [a, b] = objects.joints[joint].bodies;
            const SolverEnd end_a = bodies.solver_ends[a], end_b = bodies.solver_ends[b];
            if (end_a.moves() && end_b.moves()) heaps.unite(end_a.index(), end_b.index());
        }
    }
    std::vector<bool> hit(bodies.solver_bodies.size());
    const auto heap_of = [&](const ActingContact& c) {
        const auto [a, b] = bodies_of(c);
        return heaps.find(c.moves_a() ? a : b);
    };
    for_each([&](const ActingContact& c, const ActingPiece&) {
        if (c.is_fast()) hit[heap_of(c)] = true;
    });
    for_each([&](ActingContact& c, ActingPiece& piece) {
        if (c.serially || !hit[heap_of(c)]) return;
        if (c.is_fast()) {
            c.serially = true;
            ++piece.serially;
        } else {
            c.flags |= ActingContact::in_impact;
            ++piece.passing;
        }
    });
}

/// See `ContactScratch::jointed`.
std::vector<uint8_t> jointed_bodies(const ObjectState& objects, const ActiveLists& active,
                                    const BodyScratch& bodies, const JointScratch& joints) {
    std::vector<uint8_t> jointed;
    if (active.awake_contacts.empty()) return jointed;
    const auto mark = [&](const std::vector<uint32_t>& list, size_t load) {
        if (jointed.empty() && !list.empty()) jointed.resize(bodies.solver_bodies.size());
        for (const uint32_t joint : list) {
            for (const uint32_t body : objects.joints[joint].bodies)
                if (bodies.solver_ends[body].moves())
                    jointed[bodies.solver_ends[body].index()] = uint8_t(1 + load);
        }
    };
    for (const auto& list : active.awake_joints) mark(list, 0);
    for (size_t array = joint_type_count; array < JointScratch::tuned * joint_type_count; ++array)
        mark(joints.joint_arrays[array].joints, array / joint_type_count);
    return jointed;
}

/// True if the groups, which solve the usual contacts, cannot solve this one. Most contacts are not
/// special, and their surface is in a cache line that is not read.
bool needs_serial_solver(const ObjectState& objects, const BodyScratch& bodies,
                         const ContactRecord& record, float dt) {
    return record.curved ||
           (record.special &&
            (record.rolling_resistance != 0.0f || record.surface_speed != 0.0f)) ||
           on_locked_axis(objects, bodies, record) || passes_corner(objects, bodies, record, dt);
}

/// The flags that do not depend on velocities.
uint8_t flags_of(const ContactRecord& record, uint8_t joint_load) {
    return uint8_t((record.touching ? ActingContact::is_touching : 0) |
                   (record.hit_events ? ActingContact::reports_hits : 0) |
                   (joint_load > 1 ? (joint_load - 1) * ActingContact::one_load : 0));
}

}  // namespace

/// The list has gaps only between the pieces of different threads.
void find_acting(const ObjectState& objects, const ActiveLists& active, const BodyScratch& bodies,
                 const JointScratch& joints, const WorldDef& settings,
                 const ScheduleScratch& schedule, ContactScratch& scratch, float dt,
                 ThreadPool* threads) {
    const bool groups = settings.solver == Solver::soft_step;  // other solvers have no groups
    const std::vector<uint32_t>& awake = active.awake_contacts;
    const std::vector<ContactRecord>& contacts = objects.contacts;
    const SolverBlocks& blocks = schedule.blocks;
    std::vector<ActingContact>& acting = scratch.acting;
    const size_t count = awake.size();
    const bool any_hubs = !schedule.hubs.empty();
    const bool blocks_stay = blocks.may_be_linked(active.awake_bodies);
    const std::vector<uint8_t>& jointed = scratch.jointed;
    scratch.jointed =
        groups ? jointed_bodies(objects, active, bodies, joints) : std::vector<uint8_t>();
    acting.resize(count);
    scratch.acting_pieces.resize((count + piece_length - 1) / piece_length);
    parallel_for(threads, count, piece_length, [&](size_t begin, size_t end) {
        ActingPiece piece;
        piece.begin = uint32_t(begin);
        ActingContact* last = &acting[begin];
        uint32_t nodes = 0;
        for (size_t i = begin; i < end; ++i) {
            const uint32_t slot = awake[i];
            if (i + contacts_ahead < count) contacts[awake[i + contacts_ahead]].prefetch();
            const ContactRecord& record = contacts[slot];
            if (!record.acts()) continue;
            const SolverEnd a = bodies.solver_ends[record.body_a],
                            b = bodies.solver_ends[record.body_b];
            // The bodies are asleep or kinematic: the impulses stay as they were.
            if (!a.moves() && !b.moves()) continue;
            const uint8_t joint_load =
                jointed.empty() ? 0 : std::max(jointed[a.index()], jointed[b.index()]);
            const bool serially =
                !groups || joint_load > 1 || needs_serial_solver(objects, bodies, record, dt);
            uint8_t flags = flags_of(record, joint_load);
            if ((record.special && record.restitution > 0.0f) || joint_load > 0) {
                const bool fast =
                    approaches(record, bodies.solver_bodies[a.index()],
                               bodies.solver_bodies[b.index()], settings.restitution_threshold);
                flags |=
                    ActingContact::on_impact_path | (fast ? ActingContact::approaches_fast : 0);
                piece.fast |= fast;
            }
            ActingContact& c = *last++;
            c = {slot, a, b, 0, 0, node_of(a, b), 0, serially, flags};
            if (any_hubs && (a.is_hub() || b.is_hub()))
                schedule.hubs.choose_node(c, bodies.solver_bodies);
            nodes |= 1u << c.node;
            piece.serially += c.serially;
            if (blocks_stay && c.both_move())
                piece.links_blocks |= blocks.block_of(c.a()) != blocks.block_of(c.b());
        }
        order_by_node({&acting[begin], last}, nodes, piece.nodes);
        scratch.acting_pieces[begin / piece_length] = piece;
    });
    if (std::any_of(scratch.acting_pieces.begin(), scratch.acting_pieces.end(),
                    [](const ActingPiece& piece) { return piece.fast; }))
        choose_bouncing(objects, active, bodies, scratch);
}

void color_contacts(const ActiveLists& active, const BodyScratch& bodies, const Strips& strips,
                    size_t joints, ContactScratch& contacts, ScheduleScratch& schedule,
                    ThreadPool* threads) {
    Coloring coloring = {active.awake_bodies, bodies, strips, joints, contacts, schedule, threads};
    coloring.update_blocks();
    coloring.make_sections();
    coloring.color();
    coloring.list_single();
    coloring.place_lanes();
}

}  // namespace fettle::physics::detail
