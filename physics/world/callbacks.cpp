#include <checks/arguments.h>
#include <checks/hooks.h>
#include <contacts/mixing.h>
#include <contacts/reports.h>
#include <world/ignored_numbers.h>
#include <world/world_data.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

// The callbacks of the user.

namespace fettle::physics {

using namespace detail;

namespace detail {

/// The answer of the filter; also true if the filter throws.
bool WorldData::callback_agrees(uint32_t a, uint32_t b) const {
    if (!self.filter) return true;
    bool agrees = true;
    const bool answered = self.call_user(in_filter, [&] {
        World* const world = self.link->world;
        agrees = self.filter({world, shape_id(std::min(a, b))}, {world, shape_id(std::max(a, b))});
    });
    if (stepping)
        self.record_answer([&] {
            return Answer{key_of(shape_id(std::min(a, b))), key_of(shape_id(std::max(a, b))),
                          Answer::To::filter, answered, agrees};
        });
    return agrees || !answered;
}

void WorldData::read_edited(const Refresh& wanted) {
    if (self.refresh && !self.locked()) {
        WorldLock lock(self, WorldLock::During::query, in_refresh);
        self.refresh(wanted);
        lock.finish();
    }
    refresh(wanted);
}

void WorldData::refresh(const Refresh& wanted) {
    switch (wanted.of) {
        case Refresh::Of::everything:
            return change<detail::refresh>();
        case Refresh::Of::body:
            if (wanted.slot < bodies.size() && body_generations[wanted.slot] != 0)
                change<refresh_mass>(wanted.slot);
            return;
        case Refresh::Of::shape:
            if (wanted.slot < shapes.size() && shape_generations[wanted.slot] != 0)
                change<refresh_shape>(wanted.slot);
            return;
    }
}

UserFilter WorldData::user_filter() const {
    if (!self.filter) return {};
    return {this, [](const void* world, uint32_t a, uint32_t b) {
                return static_cast<const WorldData*>(world)->callback_agrees(a, b);
            }};
}

UserDecision WorldData::user_decision() {
    if (!self.has_contact_callbacks() && mover_pairs.empty()) return {};
    return {this, [](void* world, uint32_t contact) {
                return static_cast<WorldData*>(world)->callbacks_let_act(contact);
            }};
}

namespace {

/// A callback disables a contact for one step only.
void enable(ContactRecord& c) {
    if (c.skipped == Skipped::by_callback) c.skipped = Skipped::no;
}

/// Visits the contacts of the pairs of bodies that movers push by themselves.
void for_each_mover_contact(const WorldData& world, auto&& visit) {
    for (const MoverPair& pair : world.mover_pairs) {
        if (!world.is_valid(pair.mover) || !world.is_valid(pair.other)) continue;
        world.for_each_contact(pair.mover.index, [&](uint32_t contact) {
            if (world.other_body(contact, pair.mover.index) == pair.other.index &&
                !world.contacts[contact].sensor)
                visit(contact);
        });
    }
}

/// Calls the callbacks for the contacts of a step in their order, so that equal inputs give equal
/// results.
class ContactCallbacks {
  public:
    explicit ContactCallbacks(WorldData& world) : world_(world) {}

    void mix_all() {
        if (!world_.self.has_contact_callbacks()) return;
        std::vector<uint32_t> called;
        for (const uint32_t slot : world_.awake_contacts) {
            ContactRecord& c = world_.contacts[slot];
            enable(c);
            if (!has_points(c)) continue;
            remix(world_, world_.settings, c);  // changes by a callback are valid for one step only
            if (world_.self.mix) called.push_back(slot);
        }
        call_all(
            uint32_t(called.size()), in_mixing, world_.self.mix,
            [&](uint32_t i) { return edit_of(world_.contacts[called[i]]); },
            [&](uint32_t i, const ContactEdit&, const ContactEdit& edit, bool answered) {
                record_answer(edit, Answer::To::mixing, answered);
                if (answered) accept(world_.contacts[called[i]], edit, nullptr, in_mixing);
            });
        ignored_.report();
    }

    /// For the callback two shapes are one contact, however many of their parts touch. It is called
    /// at the position of the first part in the order, and its changes apply to all parts.
    void before_solve_all() {
        if (!world_.self.before_solve) return;
        list_parts();
        std::vector<Part> parts;     // of all pairs that the callback is called for
        std::vector<uint32_t> ends;  // of the parts of each pair
        for (uint32_t i = 0; i < world_.awake_contacts.size(); ++i) {
            const ContactRecord& c = world_.contacts[world_.awake_contacts[i]];
            if (!c.acts() || !may_call(c)) continue;
            const Part part = {pair_of(c), i};
            if (!is_of_outline(world_, c)) {
                parts.push_back(part);
                ends.push_back(uint32_t(parts.size()));
                continue;
            }
            const auto [first, last] =
                std::equal_range(parts_.begin(), parts_.end(), part,
                                 [](const Part& a, const Part& b) { return a.pair < b.pair; });
            if (first->at != i) continue;
            parts.insert(parts.end(), first, last);
            ends.push_back(uint32_t(parts.size()));
        }
        const auto parts_of = [&](uint32_t i) {
            const uint32_t begin = i > 0 ? ends[i - 1] : 0;
            return std::span<const Part>(parts).subspan(begin, ends[i] - begin);
        };
        call_all(
            uint32_t(ends.size()), in_before_solve, world_.self.before_solve,
            [&](uint32_t i) { return edit_of(parts_of(i)); },
            [&](uint32_t i, const ContactEdit& before, const ContactEdit& edit, bool answered) {
                record_answer(edit, Answer::To::before_solve, answered);
                if (answered) accept(parts_of(i), before, edit);
            });
        ignored_.report();
    }

    /// Asks about one contact, which began within the step. False if it does not act.
    bool let_act(uint32_t slot) {
        const auto ask = [&](const char* name, const ContactCallback& function, Answer::To to,
                             auto&& accept_answer) {
            call_all(
                1, name, function, [&](uint32_t) { return edit_of(world_.contacts[slot]); },
                [&](uint32_t, const ContactEdit&, const ContactEdit& edit, bool answered) {
                    record_answer(edit, to, answered);
                    if (!answered) return;
                    accept(world_.contacts[slot], edit, nullptr, name);
                    accept_answer(edit);
                });
        };
        if (world_.self.mix)
            ask(in_mixing, world_.self.mix, Answer::To::mixing, [](const ContactEdit&) {});
        if (world_.self.before_solve && may_call(world_.contacts[slot]))
            ask(in_before_solve, world_.self.before_solve, Answer::To::before_solve,
                [&](const ContactEdit& edit) {
                    if (edit.ignored)
                        world_.ignored_pairs.push_back({edit.shape_a.id(), edit.shape_b.id()});
                    if (!edit.enabled || edit.ignored)
                        skip_contact(world_.touching(), slot, Skipped::by_callback);
                });
        ignored_.report();
        return world_.contacts[slot].acts();
    }

    /// Disables the contacts of the ignored pairs, and removes the pairs that have separated.
    void skip_ignored() {
        std::vector<IgnoredPair>& pairs = world_.ignored_pairs;
        if (pairs.empty()) return;
        std::vector<bool> near(pairs.size());
        for (const uint32_t slot : world_.awake_contacts) {
            ContactRecord& c = world_.contacts[slot];
            const size_t i = ignored_pair_of(c);
            if (i == pairs.size() || c.sensor) continue;
            if (has_points(c)) {
                near[i] = true;
                skip_contact(world_.touching(), slot, Skipped::by_callback);
            } else {
                enable(c);
            }
        }
        size_t kept = 0;
        for (size_t i = 0; i < pairs.size(); ++i)
            if (near[i] || rests_near(pairs[i])) pairs[kept++] = pairs[i];
        pairs.resize(kept);
    }

    /// Disables the contacts of what movers push by themselves.
    void skip_those_of_movers() {
        for_each_mover_contact(world_, [this](uint32_t slot) {
            if (world_.contacts[slot].awake_index != none)
                skip_contact(world_.touching(), slot, Skipped::by_callback);
        });
    }

  private:
    /// Number of the ignored pair of a contact; the number of all pairs if it is not ignored.
    size_t ignored_pair_of(const ContactRecord& c) const {
        const ShapeId a = world_.shape_id(c.shape_a), b = world_.shape_id(c.shape_b);
        size_t i = 0;
        for (const IgnoredPair& pair : world_.ignored_pairs) {
            if ((pair.shape_a == a && pair.shape_b == b) ||
                (pair.shape_a == b && pair.shape_b == a))
                return i;
            ++i;
        }
        return i;
    }

    /// True if the shapes of a pair are near each other and both asleep.
    bool rests_near(const IgnoredPair& pair) const {
        if (!world_.is_valid(pair.shape_a) || !world_.is_valid(pair.shape_b)) return false;
        const uint32_t body = world_.forms[pair.shape_a.index].body;
        if (body == none) return false;
        return world_.any_contact(
            world_.bodies[body].lists.first_contact, none, [&](uint32_t slot) {
                const ContactRecord& c = world_.contacts[slot];
                const uint32_t a = world_.named_shape(c.shape_a), b = world_.named_shape(c.shape_b);
                return c.awake_index == none && has_points(c) &&
                       ((a == pair.shape_a.index && b == pair.shape_b.index) ||
                        (b == pair.shape_a.index && a == pair.shape_b.index));
            });
    }

    /// An awake contact and the pair of shapes it belongs to.
    struct Part {
        uint64_t pair;
        uint32_t at;
    };

    /// Both shapes must agree; the parts of an outline have the same answer.
    bool may_call(const ContactRecord& c) const {
        return world_.shapes[c.shape_a].surface.before_solve &&
               world_.shapes[c.shape_b].surface.before_solve;
    }

    /// It touches, also if a callback has skipped it.
    static bool has_points(const ContactRecord& c) { return !c.sensor && c.manifold.count > 0; }

    uint64_t pair_of(const ContactRecord& c) const {
        const uint32_t a = world_.named_shape(c.shape_a), b = world_.named_shape(c.shape_b);
        return uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    }
    void list_parts() {
        for (uint32_t i = 0; i < world_.awake_contacts.size(); ++i) {
            const ContactRecord& c = world_.contacts[world_.awake_contacts[i]];
            if (c.acts() && is_of_outline(world_, c)) parts_.push_back({pair_of(c), i});
        }
        std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) {
            return a.pair != b.pair ? a.pair < b.pair : a.at < b.at;
        });
    }
    ContactRecord& record(const Part& part) const {
        return world_.contacts[world_.awake_contacts[part.at]];
    }

    ContactEdit edit_of(const ContactRecord& c) const {
        const Position point = middle_of(world_, c);
        ContactEdit edit;
        edit.shape_a = {world_.self.link->world, world_.shape_id(c.shape_a)};
        edit.shape_b = {world_.self.link->world, world_.shape_id(c.shape_b)};
        edit.point = point;
        edit.normal = c.manifold.normal;
        edit.speed = approach_speed(world_, world_, c, point);
        edit.separation = infinity;
        for (int k = 0; k < c.manifold.count; ++k) {
            edit.impulse += c.manifold.points[k].normal_impulse * float(world_.last_substeps);
            edit.separation = min(edit.separation, c.manifold.points[k].separation);
        }
        edit.friction = c.friction;
        edit.restitution = c.restitution;
        edit.surface_speed = c.surface_speed;
        edit.part_a = world_.part_number(c.shape_a);
        edit.part_b = world_.part_number(c.shape_b);
        edit.material_a = world_.shapes[c.shape_a].surface.material;
        edit.material_b = world_.shapes[c.shape_b].surface.material;
        return edit;
    }

    static std::string describe(const char* callback, const ContactEdit& edit) {
        return std::string(callback) + ", for shapes " + std::to_string(edit.shape_a.id().index) +
               " and " + std::to_string(edit.shape_b.id().index) + ",";
    }

    /// If there are several parts, only values that the callback changed are stored, because each
    /// part has its own mixed values. A value out of range becomes the nearest valid one, and NaN
    /// means no change: a step must not throw.
    void accept(ContactRecord& c, const ContactEdit& edit, const ContactEdit* before,
                const char* callback) {
        const auto given = [&](float ContactEdit::*field, const char* name) {
            const float now = edit.*field;
            return ignored_.accepts(now, name, [&] { return describe(callback, edit); }) &&
                   (!before || now != before->*field);
        };
        if (given(&ContactEdit::friction, "friction"))
            c.friction = max(bounded(edit.friction, greatest_grip), 0.0f);
        if (given(&ContactEdit::restitution, "restitution"))
            c.restitution = clamp(bounded(edit.restitution, 1.0f), 0.0f, 1.0f);
        if (given(&ContactEdit::surface_speed, "surface_speed"))
            c.surface_speed = bounded(edit.surface_speed, greatest_speed);
        c.special = c.restitution > 0.0f || c.rolling_resistance > 0.0f || c.surface_speed != 0.0f;
    }

    /// Calls `function` for the contacts 0 … `count` - 1, which `make` describes, and passes the
    /// contact before and after the call to `use`, in this order. A function that may run on
    /// several threads is called for many contacts at a time.
    void call_all(uint32_t count, const char* name, const ContactCallback& function, auto&& make,
                  auto&& use) {
        WorldSelf& self = world_.self;
        const bool parallel = self.parallel_callbacks && !self.serial_callbacks;
        const uint32_t most = std::min(count, parallel ? 4096u : 1u);
        std::vector<ContactEdit> before(most), edits(most);
        std::vector<char> answered(most);
        for (uint32_t begin = 0; begin < count; begin += most) {
            const uint32_t size = std::min(most, count - begin);
            for (uint32_t i = 0; i < size; ++i) edits[i] = before[i] = make(begin + i);
            self.calling_in_parallel = parallel;
            self.call_user_for_all(
                name, parallel ? world_.threads : nullptr, size,
                [&](uint32_t i) { function(edits[i]); }, answered);
            self.calling_in_parallel = false;
            for (uint32_t i = 0; i < size; ++i)
                use(begin + i, before[i], edits[i], answered[i] != 0);
        }
    }

    /// The deepest of the parts, with the impulse of all parts.
    ContactEdit edit_of(std::span<const Part> parts) const {
        ContactEdit edit = edit_of(record(parts.front()));
        float impulse = edit.impulse;
        for (const Part& part : parts.subspan(1)) {
            const ContactEdit other = edit_of(record(part));
            impulse += other.impulse;
            if (other.separation < edit.separation) edit = other;
        }
        edit.impulse = impulse;
        return edit;
    }

    void accept(std::span<const Part> parts, const ContactEdit& before, const ContactEdit& edit) {
        if (edit.ignored) world_.ignored_pairs.push_back({edit.shape_a.id(), edit.shape_b.id()});
        for (const Part& part : parts) {
            ContactRecord& c = record(part);
            accept(c, edit, &before, in_before_solve);
            if (!edit.enabled || edit.ignored)
                skip_contact(world_.touching(), world_.awake_contacts[part.at],
                             Skipped::by_callback);
        }
    }

    void record_answer(const ContactEdit& edit, Answer::To to, bool answered) const {
        world_.self.record_answer([&] {
            Answer answer = answer_of(edit, to);
            answer.given = answered;
            return answer;
        });
    }

    WorldData& world_;
    std::vector<Part> parts_;  ///< sorted by pair, then in the order of the contacts
    IgnoredNumbers ignored_;
};

}  // namespace

void WorldData::call_contact_callbacks() {
    if (!self.has_contact_callbacks() && ignored_pairs.empty() && mover_pairs.empty()) return;
    ContactCallbacks contact_callbacks(*this);
    contact_callbacks.mix_all();
    contact_callbacks.skip_ignored();
    contact_callbacks.skip_those_of_movers();
    contact_callbacks.before_solve_all();
}

void WorldData::end_moves() {
    for_each_mover_contact(*this, [&](uint32_t contact) { enable(contacts[contact]); });
    mover_pairs.clear();
    std::erase_if(mover_bodies, [](const MoverBody& mover) { return mover.old; });
    for (MoverBody& mover : mover_bodies) mover.old = true;
}

void WorldData::search_all_pairs() {
    for (uint32_t shape = border_sides; shape < shapes.size(); ++shape)
        if (shape_generations[shape] != 0 && forms[shape].body != none) change<mark_moved>(shape);
}

bool WorldData::callbacks_let_act(uint32_t contact) {
    bool of_mover = false;
    for_each_mover_contact(*this, [&](uint32_t each) { of_mover = of_mover || each == contact; });
    if (of_mover) {
        contacts[contact].skipped = Skipped::by_callback;
        return false;
    }
    return ContactCallbacks(*this).let_act(contact);
}

void remix_all(WorldData& data) {
    for (ContactRecord& c : data.contacts) {
        if (c.shape_a == none) continue;
        remix(data, data.settings, c);
        enable(c);
    }
}

}  // namespace detail

void World::set_filter(PairFilter filter) {
    WorldData& data = edit(__func__);
    data.read_all();  // if a refresh callback throws, the old filter stays
    // The old function is destroyed with the argument, after this call: it may own the world.
    std::swap(data.self.filter, filter);
    WorldLock lock(data.self, WorldLock::During::change, in_edit);
    for (uint32_t slot = 0; slot < data.contacts.size(); ++slot) {
        const ContactRecord& c = data.contacts[slot];
        if (c.shape_a == none || data.may_collide(c.shape_a, c.shape_b)) continue;
        data.change<wake_for_edit>(c.body_a);
        data.change<wake_for_edit>(c.body_b);
        data.change<destroy_contact>(slot);
    }
    data.search_all_pairs();
    lock.finish();
}
void World::ignore_until_separated(const Shape& a, const Shape& b) {
    WorldData& data = edit(__func__);
    for (const Shape* shape : {&a, &b})
        if (!data.is_valid(shape->id()))
            refuse_dangling("shape", shape->link_, shape->index(), shape->id().generation);
    if (a == b) throw std::invalid_argument("expected two shapes, got one twice");
    for (const Shape* shape : {&a, &b})
        if (const uint32_t body = data.forms[shape->index()].body; body != none)
            data.change<wake_for_edit>(body);
    data.ignored_pairs.push_back({a.id(), b.id()});
}
void World::set_mixing(ContactCallback mix) {
    WorldData& data = edit(__func__);
    std::swap(data.self.mix, mix);
    // Another callback changes the contacts in the next step. Until then they stay, so that a copy
    // of a world that gets the callback of the original goes on like the original.
    if (!data.self.mix) remix_all(data);
}
void World::set_parallel_callbacks(bool parallel) {
    edit(__func__).self.parallel_callbacks = parallel;
}
bool World::parallel_callbacks() const {
    return data_->self.parallel_callbacks;
}
void World::refresh() {
    edit(__func__).refresh({});
}
void World::set_before_solve(ContactCallback callback) {
    WorldData& data = edit(__func__);
    std::swap(data.self.before_solve, callback);
    if (!data.self.before_solve) remix_all(data);
}

}  // namespace fettle::physics
