#include <fettle/physics/geometry.h>
#include <fettle/physics/outlines.h>
#include <fettle/physics_c/geometry.h>

#include <algorithm>
#include <span>

#include <calls/members.h>

// Geometry without a world.

namespace fettle::physics_c {

using namespace physics;

template <class InC, class Each>
void each_member(InC& c, JoinOptions& options, const Each& each) {
    each(c.reach, options.reach);
    each(c.straight, options.straight);
    each(FETTLE_ENUMERATOR(closed, Winding::counter_clockwise), options.closed);
}

template <class InC, class Each>
void each_member(InC& c, GridLayout& layout, const Each& each) {
    each(c.columns, layout.columns);
    each(c.rows, layout.rows);
    each(c.origin, layout.origin);
    each(c.cell, layout.cell);
}

}  // namespace fettle::physics_c

using namespace fettle::physics;
using namespace fettle::physics_c;

namespace {

fettle_contact_manifold manifold_in_c(const ContactManifold& manifold) {
    fettle_contact_manifold result{};
    result.normal = converted(manifold.normal);
    result.point_count = manifold.point_count;
    for (size_t i = 0; i < manifold.points.size(); ++i) {
        const ContactPoint& point = manifold.points[i];
        result.points[i] = {converted(point.point), point.separation, point.normal_impulse,
                            point.tangent_impulse, point.feature};
    }
    return result;
}

/// Writes elements that need no conversion to C.
template <class Element>
void write_all(const std::vector<Element>& all, Element* out, uint32_t room, uint32_t* count) {
    uint32_t& result = needed("count", count);
    if (room > 0) needed("out", out);
    std::copy_n(all.begin(), std::min(size_t{room}, all.size()), out);
    result = uint32_t(all.size());
}

void add_points(std::vector<fettle_line_point>& all, std::span<const Vec2> points, bool closed,
                uint32_t line) {
    for (const Vec2& point : points) all.push_back({converted(point), line, closed});
}

std::vector<fettle_line_point> points_of_chains(const std::vector<Chain>& chains) {
    std::vector<fettle_line_point> all;
    for (size_t i = 0; i < chains.size(); ++i)
        add_points(all, chains[i].points, chains[i].closed, uint32_t(i));
    return all;
}

Movement movement_of(const char* name, const fettle_movement* movement) {
    const fettle_movement& given = needed(name, movement);
    return {pose_of(&given.from), pose_of(&given.to), vector_of(given.center)};
}

void check_number(const char* name, uint32_t count) {
    constexpr uint32_t most = 1u << 24;
    if (count > most)
        throw Failure{FETTLE_INVALID, std::string(name) + ": expected at most " +
                                          std::to_string(most) + " of them, got " +
                                          std::to_string(count)};
}

}  // namespace

fettle_code fettle_join_options_init(fettle_join_options* options, size_t size) {
    return init_as<JoinOptions>(__func__, options, size);
}

fettle_code fettle_grid_layout_init(fettle_grid_layout* layout, size_t size) {
    return init_as<GridLayout>(__func__, layout, size);
}

fettle_code fettle_geometry_mass_properties(const fettle_geometry* geometry, float density,
                                            fettle_mass_properties* properties) {
    return guarded(__func__, [&] {
        fettle_mass_properties& result = needed("mass_properties", properties);
        const MassProperties found = mass_properties(geometry_of(geometry), density);
        result = {found.area, found.mass, converted(found.centroid), found.inertia};
    });
}

fettle_code fettle_geometry_bounding_box(const fettle_geometry* geometry, const fettle_pose* pose,
                                         fettle_aabb* box) {
    return guarded(__func__, [&] {
        fettle_aabb& result = needed("bounding_box", box);
        result = converted(bounding_box(geometry_of(geometry), pose_of(pose)));
    });
}

fettle_code fettle_geometry_contains(const fettle_geometry* geometry, const fettle_pose* pose,
                                     fettle_coordinate x, fettle_coordinate y, bool* is_inside) {
    return guarded(__func__, [&] {
        bool& result = needed("contains", is_inside);
        result = contains(geometry_of(geometry), pose_of(pose), {x, y});
    });
}

fettle_code fettle_geometry_cast_ray(const fettle_geometry* geometry, const fettle_pose* pose,
                                     fettle_coordinate from_x, fettle_coordinate from_y,
                                     fettle_coordinate to_x, fettle_coordinate to_y, bool* found,
                                     fettle_surface_hit* hit) {
    return guarded(__func__, [&] {
        bool& result = needed("found", found);
        const auto entry =
            cast_ray(geometry_of(geometry), pose_of(pose), {from_x, from_y}, {to_x, to_y});
        result = entry.has_value();
        if (entry && hit != nullptr)
            *hit = {converted(entry->point), converted(entry->normal), entry->fraction};
    });
}

fettle_code fettle_geometry_distance(const fettle_geometry* a, const fettle_pose* pose_a,
                                     const fettle_geometry* b, const fettle_pose* pose_b,
                                     fettle_separation* separation) {
    return guarded(__func__, [&] {
        fettle_separation& result = needed("separation", separation);
        const Separation found =
            distance(geometry_of(a), pose_of(pose_a), geometry_of(b), pose_of(pose_b));
        result = {found.distance, converted(found.point_a), converted(found.point_b),
                  converted(found.normal)};
    });
}

fettle_code fettle_geometry_contact_manifolds(const fettle_geometry* a, const fettle_pose* pose_a,
                                              const fettle_geometry* b, const fettle_pose* pose_b,
                                              float margin, fettle_contact_manifold* out,
                                              uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        std::vector<fettle_contact_manifold> all;
        for (const ContactManifold& each : contact_manifolds(
                 geometry_of(a), pose_of(pose_a), geometry_of(b), pose_of(pose_b), margin))
            all.push_back(manifold_in_c(each));
        write_all(all, out, room, count);
    });
}

fettle_code fettle_geometry_time_of_impact(const fettle_geometry* a,
                                           const fettle_movement* movement_a,
                                           const fettle_geometry* b,
                                           const fettle_movement* movement_b, bool* found,
                                           float* fraction) {
    return guarded(__func__, [&] {
        bool& result = needed("found", found);
        const auto time = time_of_impact(geometry_of(a), movement_of("movement_a", movement_a),
                                         geometry_of(b), movement_of("movement_b", movement_b));
        result = time.has_value();
        if (time && fraction != nullptr) *fraction = *time;
    });
}

fettle_code fettle_geometry_parts(const fettle_geometry* geometry, fettle_line_point* out,
                                  uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        const auto parts = Form(geometry_of(geometry)).parts();
        std::vector<fettle_line_point> all;
        for (size_t i = 0; i < parts.size(); ++i)
            add_points(all, parts[i], parts[i].size() > 2, uint32_t(i));
        write_all(all, out, room, count);
    });
}

fettle_code fettle_join_lines(const fettle_line_point* points, uint32_t point_count,
                              const fettle_join_options* options, fettle_line_point* out,
                              uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        check_number("points", point_count);
        if (point_count > 0) needed("points", points);
        std::vector<std::vector<Vec2>> lines;
        for (uint32_t i = 0; i < point_count; ++i) {
            if (i == 0 || points[i].line != points[i - 1].line) lines.emplace_back();
            lines.back().push_back(vector_of(points[i].point));
        }
        write_all(points_of_chains(join_lines(lines, from_c_or_defaults<JoinOptions>(options))),
                  out, room, count);
    });
}

fettle_code fettle_without_straight_points(const fettle_vec2* points, uint32_t point_count,
                                           bool closed, float straight, fettle_vec2* out,
                                           uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        write_list(without_straight_points(points_of(points, point_count), flag(closed), straight),
                   out, room, count);
    });
}

fettle_code fettle_grid_outlines(const float* values, uint32_t value_count,
                                 const fettle_grid_layout* layout, float threshold, float straight,
                                 fettle_line_point* out, uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        check_number("values", value_count);
        if (value_count > 0) needed("values", values);
        const auto grid = from_c<GridLayout>(needed("layout", layout));
        const auto chains =
            grid_outlines(std::span(values, value_count), grid, threshold, straight);
        write_all(points_of_chains(chains), out, room, count);
    });
}
