#include <fettle/physics_c/query.h>

#include <calls/members.h>

namespace fettle::physics_c {

using namespace physics;

/// All members but the function.
template <class InC, class Each>
void each_member(InC& c, QueryFilter& filter, const Each& each) {
    each(c.category, filter.category);
    each(c.mask, filter.mask);
    each(c.group, filter.group);
    each(c.sensors, filter.sensors);
}

template <class InC, class Each>
void each_member(InC& c, ExplosionDef& def, const Each& each) {
    each(c.point, def.point);
    each(c.radius, def.radius);
    each(c.falloff, def.falloff);
    each(c.impulse_per_length, def.impulse_per_length);
}

QueryFilter filter_of(const fettle_world* world, const fettle_query_filter* filter) {
    if (filter == nullptr) return {};
    QueryFilter result = from_c<QueryFilter>(*filter);
    if (const fettle_accept accept = filter->accept; accept != nullptr) {
        result.accept = [world, accept, user = filter->user](const Shape& shape) {
            return accept(user, world, converted(shape));
        };
    }
    return result;
}

namespace {

void visit(fettle_world* world, const std::vector<Shape>& found, fettle_shape_visitor visitor,
           void* user) {
    needed("visitor", visitor);
    const Visiting visiting(*world);
    for (const Shape& shape : found)
        if (!visitor(user, world, converted(shape))) return;
}

void write_hit(const auto& found, bool* is_found, auto* hit) {
    needed("found", is_found) = found.has_value();
    if (found && hit != nullptr) *hit = converted(*found);
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics;
using namespace fettle::physics_c;

fettle_code fettle_query_filter_init(fettle_query_filter* filter, size_t size) {
    return init_as<QueryFilter>(__func__, filter, size);
}

fettle_code fettle_world_query_point(const fettle_world* world, fettle_coordinate x,
                                     fettle_coordinate y, const fettle_query_filter* filter,
                                     fettle_id* out, uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        write_list(live(world).query_point({x, y}, filter_of(world, filter)), out, room, count);
    });
}

fettle_code fettle_world_visit_point(fettle_world* world, fettle_coordinate x, fettle_coordinate y,
                                     const fettle_query_filter* filter,
                                     fettle_shape_visitor visitor, void* user) {
    return guarded(__func__, [&] {
        visit(world, live(world).query_point({x, y}, filter_of(world, filter)), visitor, user);
    });
}

fettle_code fettle_world_query_aabb(const fettle_world* world, const fettle_aabb* box,
                                    const fettle_query_filter* filter, fettle_id* out,
                                    uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        const Aabb within = box_of(needed("box", box));
        write_list(live(world).query_aabb(within, filter_of(world, filter)), out, room, count);
    });
}

fettle_code fettle_world_visit_aabb(fettle_world* world, const fettle_aabb* box,
                                    const fettle_query_filter* filter, fettle_shape_visitor visitor,
                                    void* user) {
    return guarded(__func__, [&] {
        const Aabb within = box_of(needed("box", box));
        visit(world, live(world).query_aabb(within, filter_of(world, filter)), visitor, user);
    });
}

fettle_code fettle_world_query_overlap(const fettle_world* world, const fettle_world* of,
                                       fettle_id shape, const fettle_query_filter* filter,
                                       fettle_id* out, uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        const auto found =
            live(world).query_overlap(handle<Shape>(of, shape), filter_of(world, filter));
        write_list(found, out, room, count);
    });
}

fettle_code fettle_world_visit_overlap(fettle_world* world, const fettle_world* of, fettle_id shape,
                                       const fettle_query_filter* filter,
                                       fettle_shape_visitor visitor, void* user) {
    return guarded(__func__, [&] {
        const auto found =
            live(world).query_overlap(handle<Shape>(of, shape), filter_of(world, filter));
        visit(world, found, visitor, user);
    });
}

fettle_code fettle_world_query_overlap_geometry(const fettle_world* world,
                                                const fettle_geometry* geometry,
                                                const fettle_pose* pose,
                                                const fettle_query_filter* filter, fettle_id* out,
                                                uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        const auto found = live(world).query_overlap(geometry_of(geometry), pose_of(pose),
                                                     filter_of(world, filter));
        write_list(found, out, room, count);
    });
}

fettle_code fettle_world_visit_overlap_geometry(fettle_world* world,
                                                const fettle_geometry* geometry,
                                                const fettle_pose* pose,
                                                const fettle_query_filter* filter,
                                                fettle_shape_visitor visitor, void* user) {
    return guarded(__func__, [&] {
        const auto found = live(world).query_overlap(geometry_of(geometry), pose_of(pose),
                                                     filter_of(world, filter));
        visit(world, found, visitor, user);
    });
}

fettle_code fettle_world_cast_ray(const fettle_world* world, fettle_coordinate from_x,
                                  fettle_coordinate from_y, fettle_coordinate to_x,
                                  fettle_coordinate to_y, const fettle_query_filter* filter,
                                  bool* found, fettle_ray_hit* hit) {
    return guarded(__func__, [&] {
        write_hit(live(world).cast_ray({from_x, from_y}, {to_x, to_y}, filter_of(world, filter)),
                  found, hit);
    });
}

fettle_code fettle_world_cast_ray_all(const fettle_world* world, fettle_coordinate from_x,
                                      fettle_coordinate from_y, fettle_coordinate to_x,
                                      fettle_coordinate to_y, const fettle_query_filter* filter,
                                      fettle_ray_hit* out, uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        const auto found =
            live(world).cast_ray_all({from_x, from_y}, {to_x, to_y}, filter_of(world, filter));
        write_list(found, out, room, count);
    });
}

fettle_code fettle_world_visit_ray(fettle_world* world, fettle_coordinate from_x,
                                   fettle_coordinate from_y, fettle_coordinate to_x,
                                   fettle_coordinate to_y, const fettle_query_filter* filter,
                                   fettle_ray_visitor visitor, void* user) {
    return guarded(__func__, [&] {
        const auto found =
            live(world).cast_ray_all({from_x, from_y}, {to_x, to_y}, filter_of(world, filter));
        needed("visitor", visitor);
        const Visiting visiting(*world);
        for (const RayHit& each : found) {
            const fettle_ray_hit hit = converted(each);
            if (!visitor(user, world, &hit)) return;
        }
    });
}

fettle_code fettle_world_cast_shape(const fettle_world* world, const fettle_world* of,
                                    fettle_id shape, float motion_x, float motion_y,
                                    const fettle_query_filter* filter, bool* found,
                                    fettle_ray_hit* hit) {
    return guarded(__func__, [&] {
        write_hit(live(world).cast_shape(handle<Shape>(of, shape), Vec2(motion_x, motion_y),
                                         filter_of(world, filter)),
                  found, hit);
    });
}

fettle_code fettle_world_cast_geometry(const fettle_world* world, const fettle_geometry* geometry,
                                       const fettle_pose* pose, float motion_x, float motion_y,
                                       const fettle_query_filter* filter, bool* found,
                                       fettle_ray_hit* hit) {
    return guarded(__func__, [&] {
        write_hit(live(world).cast_shape(geometry_of(geometry), pose_of(pose),
                                         Vec2(motion_x, motion_y), filter_of(world, filter)),
                  found, hit);
    });
}

fettle_code fettle_world_closest(const fettle_world* world, fettle_coordinate x,
                                 fettle_coordinate y, float reach,
                                 const fettle_query_filter* filter, bool* found,
                                 fettle_point_hit* hit) {
    return guarded(__func__, [&] {
        write_hit(live(world).closest({x, y}, reach, filter_of(world, filter)), found, hit);
    });
}

fettle_code fettle_distance(const fettle_world* world_a, fettle_id shape_a,
                            const fettle_world* world_b, fettle_id shape_b,
                            fettle_separation* separation) {
    return guarded(__func__, [&] {
        fettle_separation& result = needed("separation", separation);
        const Separation between =
            distance(handle<Shape>(world_a, shape_a), handle<Shape>(world_b, shape_b));
        result = {between.distance, converted(between.point_a), converted(between.point_b),
                  converted(between.normal)};
    });
}

fettle_code fettle_world_explode(fettle_world* world, fettle_coordinate x, fettle_coordinate y,
                                 float radius, float impulse, const fettle_query_filter* filter) {
    return guarded(__func__, [&] {
        editable(world).explode({x, y}, radius, impulse, filter_of(world, filter));
    });
}

fettle_code fettle_explosion_def_init(fettle_explosion_def* def, size_t size) {
    return init_as<ExplosionDef>(__func__, def, size);
}

fettle_code fettle_world_explode_surfaces(fettle_world* world, const fettle_explosion_def* def,
                                          const fettle_query_filter* filter) {
    return guarded(__func__, [&] {
        const ExplosionDef explosion = from_c<ExplosionDef>(needed("def", def));
        editable(world).explode(explosion, filter_of(world, filter));
    });
}
