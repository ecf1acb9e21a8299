// Snapshots: the worlds as the physics library saves them, and the other data of the module. Worlds
// are restored in place, so that handles into them stay valid.

#include <algorithm>
#include <stdexcept>

#include <hosting/hosting.h>
#include <saving/flags.h>
#include <saving/rows.h>

namespace fettle::physics_module {
namespace {

using Departed = std::unordered_map<std::uint32_t, Handle>;

void put(property::ByteWriter& to, const Departed& departed) {
    std::vector<std::pair<std::uint32_t, Handle>> sorted(departed.begin(), departed.end());
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    to.put(std::uint64_t{sorted.size()});
    for (const auto& [generation, handle] : sorted) {
        to.put(generation);
        to.put(handle);
    }
}

Departed get_departed(property::ByteReader& from) {
    Departed departed;
    for (std::size_t n = from.count(12); n > 0; --n) {
        const auto generation = from.get<std::uint32_t>();
        departed[generation] = from.get<Handle>();
    }
    return departed;
}

/// Data of a hosted world in addition to its physics::World.
struct Beside {
    Handle self;
    bool placed = false, unreported = false;
    std::vector<Look> looks;
    std::vector<std::optional<property::Color>> body_colors;
    std::vector<std::optional<physics::Vec2>> velocities;
    Departed bodies, shapes;
};

bool is_color(const std::optional<property::Color>& color) {
    if (!is_optional(color)) return false;
    if (!color) return true;
    const auto is_channel = [](float value) { return value >= 0.0f && value <= 1.0f; };
    return is_channel(color->r) && is_channel(color->g) && is_channel(color->b) &&
           is_channel(color->a);
}

void save_beside(property::ByteWriter& to, const HostedWorld& hosted) {
    to.put(hosted.self);
    to.put(std::uint8_t{hosted.placed});
    to.put(std::uint8_t{hosted.unreported});
    to.put(hosted.looks.all());
    to.put(hosted.body_colors.all());
    to.put(hosted.velocities.all());
    put(to, hosted.departed_bodies);
    put(to, hosted.departed_shapes);
}

Beside read_beside(property::ByteReader& from) {
    Beside beside;
    beside.self = from.get<Handle>();
    beside.placed = from.boolean();
    beside.unreported = from.boolean();
    beside.looks = from.list<Look>();
    beside.body_colors = from.list<std::optional<property::Color>>();
    beside.velocities = from.list<std::optional<physics::Vec2>>();
    for (const Look& look : beside.looks)
        from.require(is_color(look.fill) && is_color(look.border) && is_flag(look.visible),
                     "a look");
    for (const auto& color : beside.body_colors) from.require(is_color(color), "a color");
    for (const auto& velocity : beside.velocities)
        from.require(is_optional(velocity) && (!velocity || velocity->allFinite()), "a velocity");
    beside.bodies = get_departed(from);
    beside.shapes = get_departed(from);
    return beside;
}

void put_beside(Beside beside, HostedWorld& hosted) {
    hosted.self = beside.self;
    hosted.placed = beside.placed;
    hosted.unreported = beside.unreported;
    hosted.looks.replace(std::move(beside.looks));
    hosted.body_colors.replace(std::move(beside.body_colors));
    hosted.velocities.replace(std::move(beside.velocities));
    hosted.departed_bodies = std::move(beside.bodies);
    hosted.departed_shapes = std::move(beside.shapes);
}

/// True if the bytes of all flags in the settings of a joint are valid.
template <class Settings>
bool flags_hold(const Settings& settings) {
    bool hold = true;
    Settings::each([&](auto field, auto, auto... ask) {
        const auto& value = settings.*field;
        if constexpr (sizeof...(ask) != 0)
            hold &= is_optional(value.value) && is_flag(value.given);
        else if constexpr (std::is_same_v<decltype(value), const bool&>)
            hold &= is_flag(value);
    });
    return hold;
}

}  // namespace

void Hosting::save(property::ByteWriter& to) const {
    if (!postponed_.empty())
        throw property::Error(property::ErrorKind::rejected,
                              "a snapshot cannot be taken by a function that a physics world calls "
                              "after it has deleted something: wait until that step or query is "
                              "over");
    to.put(std::uint8_t{wanted_.hits});
    const auto count = std::count_if(worlds_.begin(), worlds_.end(),
                                     [](const auto& hosted) { return hosted != nullptr; });
    to.put(static_cast<std::uint64_t>(count));
    for (std::uint32_t number = 0; number < most_worlds; ++number) {
        if (worlds_[number] == nullptr) continue;
        to.put(number);
        save_beside(to, *worlds_[number]);
        const std::size_t block = to.begin_block();
        worlds_[number]->world.save(to.out());
        to.end_block(block);
    }
    joints.save(to);
}

std::function<void()> Hosting::restore(property::ByteReader& from) {
    struct Saved {
        std::uint32_t number;
        Beside beside;
        std::unique_ptr<physics::World> world;
    };
    for (const auto& hosted : worlds_)
        if (hosted != nullptr && hosted->world.locked())
            throw property::Error(property::ErrorKind::rejected,
                                  "a snapshot cannot be restored by a function that a physics "
                                  "world calls: wait until its step or query is over");
    auto worlds = std::make_shared<std::vector<Saved>>();
    const bool hits_wanted = from.boolean();
    std::vector<bool> found(most_worlds, false);
    for (std::size_t n = from.count(16); n > 0; --n) {
        const auto number = from.get<std::uint32_t>();
        from.require(number < most_worlds && !found[number], "a world without a number");
        found[number] = true;
        Saved saved{number, read_beside(from), std::make_unique<physics::World>()};
        const property::ByteReader block = from.block();
        try {
            saved.world->restore(block.rest());
        } catch (const std::invalid_argument& problem) {
            from.fail(problem.what());
        }
        worlds->push_back(std::move(saved));
    }
    from.require(found[limbo], "there is no place for what is in no world");
    RestoredObjects objects;
    const std::function<void()> put_joints = joints.restore(from, objects.joints);
    for (const Saved& saved : *worlds) {
        objects.worlds[saved.number] = saved.world.get();
        objects.selves[saved.number] = saved.beside.self;
    }
    check_rows(*this, objects, from);
    return [this, worlds, hits_wanted, put_joints, found] {
        const Placing placing(*this);
        postponed_.clear();
        for (std::uint32_t number = 0; number < most_worlds; ++number)
            if (!found[number]) worlds_[number].reset();
        for (Saved& saved : *worlds) {
            auto& hosted = worlds_[saved.number];
            // Handlers are not restored: the current ones stay. A world that existed before kept
            // its callbacks.
            Wanted told = hosted == nullptr ? Wanted{} : wanted_;
            told.hits = hits_wanted;
            if (hosted == nullptr) hosted = make_world(saved.number);
            hosted->world.take(std::move(*saved.world));
            put_beside(std::move(saved.beside), *hosted);
            hosted->placed = tree.alive(hosted->self) && tree.is_below(hosted->self, tree.root());
            listen(*hosted, told);
        }
        put_joints();
    };
}

void Joints::save(property::ByteWriter& to) const {
    to.put(records_);
    to.put(free_);
    to.put(std::uint8_t{loose_});
}

std::function<void()> Joints::restore(property::ByteReader& from,
                                      const std::vector<JointRecord>*& read) {
    const auto records = std::make_shared<std::vector<JointRecord>>(from.list<JointRecord>());
    const auto free = std::make_shared<std::vector<std::uint32_t>>(from.list<std::uint32_t>());
    const bool loose = from.boolean();
    read = records.get();
    for (const JointRecord& record : *records)
        from.require(record.settings.index() < std::variant_size_v<decltype(record.settings)> &&
                         record.world < most_worlds && is_flag(record.used) &&
                         is_flag(record.collide) && is_flag(record.enabled) &&
                         is_flag(record.broken),
                     "a joint of no type");
    for (const JointRecord& record : *records) {
        if (!record.used) continue;
        from.require(
            std::visit([](const auto& settings) { return flags_hold(settings); }, record.settings),
            "a flag of a joint");
        try {
            check(record);
        } catch (const std::invalid_argument& problem) {
            from.fail(problem.what());
        }
    }
    std::vector<bool> seen(records->size());
    for (const std::uint32_t row : *free) {
        from.require(row < records->size() && !(*records)[row].used && !seen[row],
                     "a free joint that is used");
        seen[row] = true;
    }
    return [this, records, free, loose] {
        records_ = std::move(*records);
        free_ = std::move(*free);
        loose_ = loose;
    };
}

}  // namespace fettle::physics_module
