#include <calls/calls.h>

#include <fettle/physics_c/shape.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

bool fettle_shape_is_valid(const fettle_world* world, fettle_id shape) {
    return lives<ShapeId>(world, shape);
}

fettle_code fettle_shape_destroy(fettle_world* world, fettle_id shape) {
    return edit<&Shape::destroy>(__func__, world, shape);
}

fettle_code fettle_shape_type(const fettle_world* world, fettle_id shape, int32_t* type) {
    return read<&Shape::type>(__func__, world, shape, type);
}

fettle_code fettle_shape_body(const fettle_world* world, fettle_id shape, fettle_id* body) {
    return read<&Shape::body>(__func__, world, shape, body);
}

fettle_code fettle_shape_attach(fettle_world* world, fettle_id shape, fettle_id body) {
    return on<Shape>(__func__, world, shape,
                     [&](Shape it) { it.attach(handle<Body>(world, body)); });
}

fettle_code fettle_shape_detach(fettle_world* world, fettle_id shape) {
    return edit<&Shape::detach>(__func__, world, shape);
}

fettle_code fettle_shape_geometry(const fettle_world* world, fettle_id shape,
                                  fettle_geometry* geometry) {
    return on<Shape>(__func__, world, shape, [&](Shape it) { tell_geometry(it, geometry); });
}

fettle_code fettle_shape_set_geometry(fettle_world* world, fettle_id shape,
                                      const fettle_geometry* geometry) {
    return on<Shape>(__func__, world, shape,
                     [&](Shape it) { it.set_geometry(geometry_of(geometry)); });
}

fettle_code fettle_shape_radius(const fettle_world* world, fettle_id shape, float* radius) {
    return read<&Shape::radius>(__func__, world, shape, radius);
}

fettle_code fettle_shape_set_radius(fettle_world* world, fettle_id shape, float radius) {
    return edit<&Shape::set_radius>(__func__, world, shape, radius);
}

fettle_code fettle_shape_radius_x(const fettle_world* world, fettle_id shape, float* radius_x) {
    return read<&Shape::radius_x>(__func__, world, shape, radius_x);
}

fettle_code fettle_shape_set_radius_x(fettle_world* world, fettle_id shape, float radius_x) {
    return edit<&Shape::set_radius_x>(__func__, world, shape, radius_x);
}

fettle_code fettle_shape_radius_y(const fettle_world* world, fettle_id shape, float* radius_y) {
    return read<&Shape::radius_y>(__func__, world, shape, radius_y);
}

fettle_code fettle_shape_set_radius_y(fettle_world* world, fettle_id shape, float radius_y) {
    return edit<&Shape::set_radius_y>(__func__, world, shape, radius_y);
}

fettle_code fettle_shape_center(const fettle_world* world, fettle_id shape, fettle_vec2* center) {
    return read<&Shape::center>(__func__, world, shape, center);
}

fettle_code fettle_shape_set_center(fettle_world* world, fettle_id shape, float x, float y) {
    return edit<&Shape::set_center>(__func__, world, shape, Vec2(x, y));
}

fettle_code fettle_shape_width(const fettle_world* world, fettle_id shape, float* width) {
    return read<&Shape::width>(__func__, world, shape, width);
}

fettle_code fettle_shape_set_width(fettle_world* world, fettle_id shape, float width) {
    return edit<&Shape::set_width>(__func__, world, shape, width);
}

fettle_code fettle_shape_height(const fettle_world* world, fettle_id shape, float* height) {
    return read<&Shape::height>(__func__, world, shape, height);
}

fettle_code fettle_shape_set_height(fettle_world* world, fettle_id shape, float height) {
    return edit<&Shape::set_height>(__func__, world, shape, height);
}

fettle_code fettle_shape_angle(const fettle_world* world, fettle_id shape, float* angle) {
    return read<&Shape::angle>(__func__, world, shape, angle);
}

fettle_code fettle_shape_set_angle(fettle_world* world, fettle_id shape, float angle) {
    return edit<&Shape::set_angle>(__func__, world, shape, angle);
}

fettle_code fettle_shape_rounding(const fettle_world* world, fettle_id shape, float* rounding) {
    return read<&Shape::rounding>(__func__, world, shape, rounding);
}

fettle_code fettle_shape_set_rounding(fettle_world* world, fettle_id shape, float rounding) {
    return edit<&Shape::set_rounding>(__func__, world, shape, rounding);
}

fettle_code fettle_shape_from(const fettle_world* world, fettle_id shape, fettle_vec2* from) {
    return read<&Shape::from>(__func__, world, shape, from);
}

fettle_code fettle_shape_set_from(fettle_world* world, fettle_id shape, float x, float y) {
    return edit<&Shape::set_from>(__func__, world, shape, Vec2(x, y));
}

fettle_code fettle_shape_to(const fettle_world* world, fettle_id shape, fettle_vec2* to) {
    return read<&Shape::to>(__func__, world, shape, to);
}

fettle_code fettle_shape_set_to(fettle_world* world, fettle_id shape, float x, float y) {
    return edit<&Shape::set_to>(__func__, world, shape, Vec2(x, y));
}

fettle_code fettle_shape_vertices(const fettle_world* world, fettle_id shape, fettle_vec2* out,
                                  uint32_t room, uint32_t* count) {
    return list<&Shape::vertices>(__func__, world, shape, out, room, count);
}

fettle_code fettle_shape_set_vertices(fettle_world* world, fettle_id shape,
                                      const fettle_vec2* points, uint32_t count) {
    return on<Shape>(__func__, world, shape,
                     [&](Shape it) { it.set_vertices(points_of(points, count)); });
}

fettle_code fettle_shape_try_set_vertices(fettle_world* world, fettle_id shape,
                                          const fettle_vec2* points, uint32_t count,
                                          int32_t* status) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        int32_t& told = needed("status", status);
        told = int32_t(it.try_set_vertices(points_of(points, count)));
    });
}

fettle_code fettle_shape_add_vertex(fettle_world* world, fettle_id shape, float x, float y) {
    return edit<&Shape::add_vertex>(__func__, world, shape, Vec2(x, y));
}

fettle_code fettle_shape_closed(const fettle_world* world, fettle_id shape, bool* closed) {
    return read<&Shape::closed>(__func__, world, shape, closed);
}

fettle_code fettle_shape_set_closed(fettle_world* world, fettle_id shape, bool closed) {
    return edit<&Shape::set_closed>(__func__, world, shape, closed);
}

fettle_code fettle_shape_pieces(const fettle_world* world, fettle_id shape, uint32_t piece,
                                fettle_vec2* out, uint32_t room, uint32_t* count,
                                uint32_t* pieces) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        const auto all = it.pieces();
        tell_list(piece < all.size() ? all[piece] : std::vector<Vec2>(), out, room, count);
        needed("pieces", pieces) = uint32_t(all.size());
    });
}

fettle_code fettle_shape_density(const fettle_world* world, fettle_id shape, float* density) {
    return read<&Shape::density>(__func__, world, shape, density);
}

fettle_code fettle_shape_set_density(fettle_world* world, fettle_id shape, float density) {
    return edit<&Shape::set_density>(__func__, world, shape, density);
}

fettle_code fettle_shape_friction(const fettle_world* world, fettle_id shape, float* friction) {
    return read<&Shape::friction>(__func__, world, shape, friction);
}

fettle_code fettle_shape_set_friction(fettle_world* world, fettle_id shape, float friction) {
    return edit<&Shape::set_friction>(__func__, world, shape, friction);
}

fettle_code fettle_shape_restitution(const fettle_world* world, fettle_id shape,
                                     float* restitution) {
    return read<&Shape::restitution>(__func__, world, shape, restitution);
}

fettle_code fettle_shape_set_restitution(fettle_world* world, fettle_id shape, float restitution) {
    return edit<&Shape::set_restitution>(__func__, world, shape, restitution);
}

fettle_code fettle_shape_rolling_resistance(const fettle_world* world, fettle_id shape,
                                            float* rolling_resistance) {
    return read<&Shape::rolling_resistance>(__func__, world, shape, rolling_resistance);
}

fettle_code fettle_shape_set_rolling_resistance(fettle_world* world, fettle_id shape,
                                                float rolling_resistance) {
    return edit<&Shape::set_rolling_resistance>(__func__, world, shape, rolling_resistance);
}

fettle_code fettle_shape_surface_speed(const fettle_world* world, fettle_id shape,
                                       float* surface_speed) {
    return read<&Shape::surface_speed>(__func__, world, shape, surface_speed);
}

fettle_code fettle_shape_set_surface_speed(fettle_world* world, fettle_id shape,
                                           float surface_speed) {
    return edit<&Shape::set_surface_speed>(__func__, world, shape, surface_speed);
}

fettle_code fettle_shape_sensor(const fettle_world* world, fettle_id shape, bool* sensor) {
    return read<&Shape::sensor>(__func__, world, shape, sensor);
}

fettle_code fettle_shape_set_sensor(fettle_world* world, fettle_id shape, bool sensor) {
    return edit<&Shape::set_sensor>(__func__, world, shape, sensor);
}

fettle_code fettle_shape_hit_events(const fettle_world* world, fettle_id shape, bool* hit_events) {
    return read<&Shape::hit_events>(__func__, world, shape, hit_events);
}

fettle_code fettle_shape_set_hit_events(fettle_world* world, fettle_id shape, bool hit_events) {
    return edit<&Shape::set_hit_events>(__func__, world, shape, hit_events);
}

fettle_code fettle_shape_contact_events(const fettle_world* world, fettle_id shape,
                                        bool* contact_events) {
    return read<&Shape::contact_events>(__func__, world, shape, contact_events);
}

fettle_code fettle_shape_set_contact_events(fettle_world* world, fettle_id shape,
                                            bool contact_events) {
    return edit<&Shape::set_contact_events>(__func__, world, shape, contact_events);
}

fettle_code fettle_shape_sensor_events(const fettle_world* world, fettle_id shape,
                                       bool* sensor_events) {
    return read<&Shape::sensor_events>(__func__, world, shape, sensor_events);
}

fettle_code fettle_shape_set_sensor_events(fettle_world* world, fettle_id shape,
                                           bool sensor_events) {
    return edit<&Shape::set_sensor_events>(__func__, world, shape, sensor_events);
}

fettle_code fettle_shape_before_solve(const fettle_world* world, fettle_id shape,
                                      bool* before_solve) {
    return read<&Shape::before_solve>(__func__, world, shape, before_solve);
}

fettle_code fettle_shape_set_before_solve(fettle_world* world, fettle_id shape, bool before_solve) {
    return edit<&Shape::set_before_solve>(__func__, world, shape, before_solve);
}

fettle_code fettle_shape_material(const fettle_world* world, fettle_id shape, uint32_t* material) {
    return read<&Shape::material>(__func__, world, shape, material);
}

fettle_code fettle_shape_set_material(fettle_world* world, fettle_id shape, uint32_t material) {
    return edit<&Shape::set_material>(__func__, world, shape, Material{material});
}

fettle_code fettle_shape_category(const fettle_world* world, fettle_id shape, uint64_t* category) {
    return read<&Shape::category>(__func__, world, shape, category);
}

fettle_code fettle_shape_set_category(fettle_world* world, fettle_id shape, uint64_t category) {
    return edit<&Shape::set_category>(__func__, world, shape, category);
}

fettle_code fettle_shape_mask(const fettle_world* world, fettle_id shape, uint64_t* mask) {
    return read<&Shape::mask>(__func__, world, shape, mask);
}

fettle_code fettle_shape_set_mask(fettle_world* world, fettle_id shape, uint64_t mask) {
    return edit<&Shape::set_mask>(__func__, world, shape, mask);
}

fettle_code fettle_shape_group(const fettle_world* world, fettle_id shape, int32_t* group) {
    return read<&Shape::group>(__func__, world, shape, group);
}

fettle_code fettle_shape_set_group(fettle_world* world, fettle_id shape, int32_t group) {
    return edit<&Shape::set_group>(__func__, world, shape, group);
}

fettle_code fettle_shape_area(const fettle_world* world, fettle_id shape, float* area) {
    return read<&Shape::area>(__func__, world, shape, area);
}

fettle_code fettle_shape_mass(const fettle_world* world, fettle_id shape, float* mass) {
    return read<&Shape::mass>(__func__, world, shape, mass);
}

fettle_code fettle_shape_aabb(const fettle_world* world, fettle_id shape, fettle_aabb* aabb) {
    return read<&Shape::aabb>(__func__, world, shape, aabb);
}

fettle_code fettle_shape_world_vertices(const fettle_world* world, fettle_id shape,
                                        fettle_position* out, uint32_t room, uint32_t* count) {
    return list<&Shape::world_vertices>(__func__, world, shape, out, room, count);
}

fettle_code fettle_shape_contains(const fettle_world* world, fettle_id shape, fettle_coordinate x,
                                  fettle_coordinate y, bool* inside) {
    return read<&Shape::contains>(__func__, world, shape, inside, FinitePoint{x, y});
}

fettle_code fettle_shape_world_center(const fettle_world* world, fettle_id shape,
                                      fettle_position* world_center) {
    return read<&Shape::world_center>(__func__, world, shape, world_center);
}

fettle_code fettle_shape_is_touching(const fettle_world* world, fettle_id shape,
                                     bool* is_touching) {
    return read<&Shape::is_touching>(__func__, world, shape, is_touching);
}

fettle_code fettle_shape_rebuilds(const fettle_world* world, fettle_id shape, uint32_t* rebuilds) {
    return read<&Shape::rebuilds>(__func__, world, shape, rebuilds);
}

fettle_code fettle_shape_user_data(const fettle_world* world, fettle_id shape,
                                   uint64_t* user_data) {
    return read<&Shape::user_data>(__func__, world, shape, user_data);
}

fettle_code fettle_shape_set_user_data(fettle_world* world, fettle_id shape, uint64_t user_data) {
    return edit<&Shape::set_user_data>(__func__, world, shape, user_data);
}
