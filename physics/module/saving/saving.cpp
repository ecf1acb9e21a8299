// Snapshots: the worlds as the physics library saves them, and the other data of the module. Worlds
// are restored in place, so that handles into them stay valid.

#include <algorithm>
#include <stdexcept>

#include <hosting/hosting.h>
#include <saving/optionals.h>
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

void put_looks(property::ByteWriter& to, const std::vector<Look>& looks) {
    to.put(std::uint64_t{looks.size()});
    for (const Look& look : looks) {
        put_optional(to, look.fill);
        put_optional(to, look.border);
        to.put(std::uint8_t{look.visible});
        to.put(std::uint8_t{look.orientation_mark});
    }
}

std::vector<Look> get_looks(property::ByteReader& from) {
    std::vector<Look> looks;
    for (std::size_t n = from.count(2 * sizeof(property::Color) + 4); n > 0; --n) {
        Look& look = looks.emplace_back();
        look.fill = get_optional<property::Color>(from);
        look.border = get_optional<property::Color>(from);
        look.visible = get_flag(from);
        look.orientation_mark = get_flag(from);
    }
    return looks;
}

/// Data of a hosted world in addition to its physics::World.
struct ModuleData {
    Handle self;
    bool placed = false, unreported = false;
    std::vector<Look> looks;
    std::vector<std::optional<property::Color>> body_colors;
    std::vector<std::optional<physics::Vec2>> velocities;
    std::vector<Ties> ties;
    std::vector<MoverRecord> movers;
    Departed bodies, shapes;
};

bool is_color(const std::optional<property::Color>& color) {
    if (!color) return true;
    const auto is_channel = [](float value) { return value >= 0.0f && value <= 1.0f; };
    return is_channel(color->r) && is_channel(color->g) && is_channel(color->b) &&
           is_channel(color->a);
}

void save_module_data(property::ByteWriter& to, const HostedWorld& hosted) {
    to.put(hosted.self);
    to.put(std::uint8_t{hosted.placed});
    to.put(std::uint8_t{hosted.unreported});
    put_looks(to, hosted.looks.all());
    put_optionals(to, hosted.body_colors.all());
    put_optionals(to, hosted.velocities.all());
    to.put(hosted.ties.all());
    to.put(hosted.movers.all());
    put(to, hosted.departed_bodies);
    put(to, hosted.departed_shapes);
}

ModuleData read_module_data(property::ByteReader& from) {
    ModuleData data;
    data.self = from.get<Handle>();
    data.placed = from.boolean();
    data.unreported = from.boolean();
    data.looks = get_looks(from);
    data.body_colors = get_optionals<property::Color>(from);
    data.velocities = get_optionals<physics::Vec2>(from);
    data.ties = from.list<Ties>();
    data.movers = from.list<MoverRecord>();
    for (const Look& look : data.looks)
        from.require(is_color(look.fill) && is_color(look.border), "a look");
    for (const auto& color : data.body_colors) from.require(is_color(color), "a color");
    for (const auto& velocity : data.velocities)
        from.require(!velocity || velocity->is_finite(), "a velocity");
    for (const Ties& ties : data.ties)
        from.require(ties.source <= Source::given, "the source of a measured value");
    from.require(are_valid(data.movers), "a mover");
    data.bodies = get_departed(from);
    data.shapes = get_departed(from);
    return data;
}

void put_module_data(ModuleData data, HostedWorld& hosted) {
    hosted.self = data.self;
    hosted.placed = data.placed;
    hosted.unreported = data.unreported;
    hosted.looks.replace(std::move(data.looks));
    hosted.body_colors.replace(std::move(data.body_colors));
    hosted.velocities.replace(std::move(data.velocities));
    hosted.ties.replace(std::move(data.ties));
    hosted.movers.replace(std::move(data.movers));
    hosted.departed_bodies = std::move(data.bodies);
    hosted.departed_shapes = std::move(data.shapes);
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
    for (std::uint32_t number = 0; number < max_worlds; ++number) {
        if (worlds_[number] == nullptr) continue;
        to.put(number);
        save_module_data(to, *worlds_[number]);
        const std::size_t block = to.begin_block();
        worlds_[number]->world.save(to.out());
        to.end_block(block);
    }
    to.put(std::uint8_t{joints.connect_needed()});
}

std::function<void()> Hosting::restore(property::ByteReader& from) {
    struct Saved {
        std::uint32_t number;
        ModuleData data;
        std::unique_ptr<physics::World> world;
    };
    for (const auto& hosted : worlds_)
        if (hosted != nullptr && hosted->world.locked())
            throw property::Error(property::ErrorKind::rejected,
                                  "a snapshot cannot be restored by a function that a physics "
                                  "world calls: wait until its step or query is over");
    auto worlds = std::make_shared<std::vector<Saved>>();
    const bool hits_wanted = from.boolean();
    std::vector<bool> found(max_worlds, false);
    for (std::size_t n = from.count(16); n > 0; --n) {
        const auto number = from.get<std::uint32_t>();
        from.require(number < max_worlds && !found[number], "a world without a number");
        found[number] = true;
        Saved saved{number, read_module_data(from), std::make_unique<physics::World>()};
        const property::ByteReader block = from.block();
        try {
            saved.world->restore(block.rest());
        } catch (const std::invalid_argument& problem) {
            from.fail(problem.what());
        }
        worlds->push_back(std::move(saved));
    }
    from.require(found[limbo], "the world for objects outside of worlds is missing");
    RestoredObjects objects;
    const bool connect_needed = from.boolean();
    for (const Saved& saved : *worlds) {
        objects.worlds[saved.number] = saved.world.get();
        objects.selves[saved.number] = saved.data.self;
        objects.ties[saved.number] = saved.data.ties;
    }
    check_rows(*this, objects, from);
    return [this, worlds, hits_wanted, connect_needed, found] {
        const Placing placing(*this);
        postponed_.clear();
        for (std::uint32_t number = 0; number < max_worlds; ++number)
            if (!found[number]) worlds_[number].reset();
        for (Saved& saved : *worlds) {
            auto& hosted = worlds_[saved.number];
            // Handlers are not restored: the current ones stay. A world that existed before kept
            // its callbacks.
            Wanted wanted = hosted == nullptr ? Wanted{} : wanted_;
            wanted.hits = hits_wanted;
            if (hosted == nullptr) hosted = make_world(saved.number);
            hosted->world.take(std::move(*saved.world));
            hosted->written_poses.clear();
            put_module_data(std::move(saved.data), *hosted);
            hosted->placed = tree.alive(hosted->self) && tree.is_below(hosted->self, tree.root());
            set_callbacks(*hosted, wanted);
        }
        joints.set_connect_needed(connect_needed);
    };
}

}  // namespace fettle::physics_module
