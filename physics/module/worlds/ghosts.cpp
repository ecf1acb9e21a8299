// The method of World that looks ahead: a copy of the world makes steps, and the world itself is
// not touched.

#include <algorithm>
#include <cmath>

#include <bindings/bindings.h>
#include <worlds/world_class.h>

namespace fettle::physics_module {
namespace {

using property::Field;
using property::Record;

/// For each step, the bodies that are awake in it, or the points that are added if these are more,
/// and a part of the bodies that are looked at. The copy makes no step beyond.
constexpr std::size_t most_work = 300'000;
/// A body that stays this near to its place does not move, m and rad.
constexpr double least_motion = 1e-3;

const std::vector<Field> ghost_fields = {
    {"body", Type::reference, "", "A body that will move.", "Body"},
    {.name = "points",
     .type = Type::list,
     .unit = "m",
     .doc = "Its position now and after each step.",
     .element = Type::vec2},
    {"angle", Type::number, "rad", "Its angle at the end."},
};

/// The path of a body, one point for each step; only the first one as long as it stays there.
struct Path {
    std::uint32_t body;
    double first_angle;
    std::vector<physics::Vec2> points{};

    /// `step`: counted from 0. Returns the number of points that were added.
    std::size_t add(std::size_t step, const physics::Vec2& point) {
        if (points.size() == 1 && point == points.front()) return 0;
        const std::size_t before = points.size();
        if (before == 1) points.resize(step + 1, points.front());
        points.push_back(point);
        return points.size() - before;
    }
};

bool moves(const Path& path, double angle) {
    if (std::abs(angle - path.first_angle) > least_motion) return true;
    return std::ranges::any_of(path.points, [&](const physics::Vec2& point) {
        return (widen(point) - widen(path.points.front())).length() > least_motion;
    });
}

property::Result ghosts(Hosting& hosting, std::uint32_t number, double seconds) {
    const HostedWorld& hosted = *hosting.world_at(number);
    // Callbacks and handlers stay with the world: no script notices the steps of the copy.
    physics::World copy = hosted.world.clone();
    // A joint that was made since the last step acts from the next one on.
    hosting.joints.connect_copy(number, copy);
    std::vector<Path> paths;
    for (const physics::Body& body : copy.bodies())
        if (body.type() != physics::BodyType::static_body)
            paths.push_back({body.index(), static_cast<double>(body.angle()), {body.position()}});
    const auto steps = static_cast<int>(std::ceil(seconds / hosting.last_dt - 1e-9));
    std::size_t work = 0, made = 0;
    for (; made < static_cast<std::size_t>(steps) && work < most_work; ++made) {
        copy.step(static_cast<float>(hosting.last_dt));
        std::size_t points = 0;
        for (Path& path : paths)
            points += path.add(made, physics::HostAccess::state(copy, path.body).position);
        work +=
            std::max<std::size_t>(copy.statistics().awake_bodies, points) + 1 + paths.size() / 32;
    }
    std::vector<Record> records;
    for (Path& path : paths) {
        const auto angle = static_cast<double>(physics::HostAccess::state(copy, path.body).angle);
        const physics::BodyId id{path.body, physics::HostAccess::body_generation(copy, path.body)};
        const Handle instance = hosting.instance_of(hosted.world.body(id).user_data());
        if (!instance || !moves(path, angle)) continue;
        path.points.resize(made + 1, path.points.front());  // of a body that only turns
        property::List points;
        points.reserve(path.points.size());
        for (const physics::Vec2& point : path.points) points.push_back(to_value(point));
        records.push_back({&ghost_fields, {instance, Value(std::move(points)), angle}});
    }
    return records;
}

}  // namespace

property::Method ghosts_method(Hosting& hosting) {
    return {
        .name = "ghosts",
        .parameters = {{.name = "seconds",
                        .type = Type::number,
                        .unit = "s",
                        .doc = "How far to look ahead; 2 if it is left out.",
                        .range = {0, 60}}},
        .required = 0,
        .returns = ghost_fields,
        .many = true,
        .doc =
            "What will move in the next seconds, and where, if only the physics goes on: a copy "
            "of the world makes the steps, with the length of the last step. This world does "
            "not change, and no function of a script is called: what scripts would do in `step` "
            "or in handlers is not in it. With more than 2500 bodies awake it ends earlier: "
            "after 300 000 bodies times steps.",
        .context = &hosting,
        .call = [](void* context, property::Tree&, Handle, Row row,
                   std::span<const Value> arguments) -> property::Result {
            Hosting& h = *static_cast<Hosting*>(context);
            const double seconds = arguments[0].is_nil() ? 2 : arguments[0].number();
            if (!(seconds >= 0 && seconds <= 60))
                throw std::invalid_argument("expected a time from 0 to 60 s");
            return ghosts(h, world_number(row), seconds);
        },
        .effect = property::Effect::nothing};
}

}  // namespace fettle::physics_module
