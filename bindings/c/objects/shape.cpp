#include <calls/properties.h>

#include <fettle/physics_c/shape.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

bool fettle_shape_is_valid(const fettle_world* world, fettle_id shape) {
    return lives<ShapeId>(world, shape);
}

fettle_code fettle_shape_destroy(fettle_world* world, fettle_id shape) {
    return edit<&Shape::destroy>(__func__, world, shape);
}

FETTLE_READING(shape, Shape, type, int32_t)
FETTLE_READING(shape, Shape, body, fettle_id)

fettle_code fettle_shape_attach(fettle_world* world, fettle_id shape, fettle_id body) {
    return on<Shape>(__func__, world, shape,
                     [&](Shape it) { it.attach(handle<Body>(world, body)); });
}

fettle_code fettle_shape_detach(fettle_world* world, fettle_id shape) {
    return edit<&Shape::detach>(__func__, world, shape);
}

fettle_code fettle_shape_geometry(const fettle_world* world, fettle_id shape,
                                  fettle_geometry* geometry) {
    return on<Shape>(__func__, world, shape, [&](Shape it) { write_geometry(it, geometry); });
}

fettle_code fettle_shape_set_geometry(fettle_world* world, fettle_id shape,
                                      const fettle_geometry* geometry) {
    return on<Shape>(__func__, world, shape,
                     [&](Shape it) { it.set_geometry(geometry_of(geometry)); });
}

FETTLE_PROPERTY(shape, Shape, radius, float)
FETTLE_PROPERTY(shape, Shape, radius_x, float)
FETTLE_PROPERTY(shape, Shape, radius_y, float)
FETTLE_VECTOR(shape, Shape, center)
FETTLE_PROPERTY(shape, Shape, width, float)
FETTLE_PROPERTY(shape, Shape, height, float)
FETTLE_PROPERTY(shape, Shape, angle, float)
FETTLE_PROPERTY(shape, Shape, rounding, float)
FETTLE_VECTOR(shape, Shape, from)
FETTLE_VECTOR(shape, Shape, to)

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
        int32_t& result = needed("status", status);
        result = int32_t(it.try_set_vertices(points_of(points, count)));
    });
}

fettle_code fettle_shape_add_vertex(fettle_world* world, fettle_id shape, float x, float y) {
    return edit<&Shape::add_vertex>(__func__, world, shape, Vec2(x, y));
}

FETTLE_PROPERTY(shape, Shape, closed, bool)

fettle_code fettle_shape_pieces(const fettle_world* world, fettle_id shape, uint32_t piece,
                                fettle_vec2* out, uint32_t room, uint32_t* count,
                                uint32_t* pieces) {
    return on<Shape>(__func__, world, shape, [&](Shape it) {
        const auto all = it.pieces();
        uint32_t& number = needed("pieces", pieces);  // before the list is written
        write_list(piece < all.size() ? all[piece] : std::vector<Vec2>(), out, room, count);
        number = uint32_t(all.size());
    });
}

FETTLE_PROPERTY(shape, Shape, density, float)
FETTLE_PROPERTY(shape, Shape, friction, float)
FETTLE_PROPERTY(shape, Shape, restitution, float)
FETTLE_PROPERTY(shape, Shape, rolling_resistance, float)
FETTLE_PROPERTY(shape, Shape, surface_speed, float)
FETTLE_PROPERTY(shape, Shape, sensor, bool)
FETTLE_PROPERTY(shape, Shape, hit_events, bool)
FETTLE_PROPERTY(shape, Shape, contact_events, bool)
FETTLE_PROPERTY(shape, Shape, sensor_events, bool)
FETTLE_PROPERTY(shape, Shape, before_solve, bool)
FETTLE_READING(shape, Shape, material, uint32_t)

fettle_code fettle_shape_set_material(fettle_world* world, fettle_id shape, uint32_t material) {
    return edit<&Shape::set_material>(__func__, world, shape, Material{material});
}

FETTLE_PROPERTY(shape, Shape, category, uint64_t)
FETTLE_PROPERTY(shape, Shape, mask, uint64_t)
FETTLE_PROPERTY(shape, Shape, group, int32_t)
FETTLE_READING(shape, Shape, area, float)
FETTLE_READING(shape, Shape, mass, float)
FETTLE_READING(shape, Shape, aabb, fettle_aabb)

fettle_code fettle_shape_world_vertices(const fettle_world* world, fettle_id shape,
                                        fettle_position* out, uint32_t room, uint32_t* count) {
    return list<&Shape::world_vertices>(__func__, world, shape, out, room, count);
}

fettle_code fettle_shape_contains(const fettle_world* world, fettle_id shape, fettle_coordinate x,
                                  fettle_coordinate y, bool* inside) {
    return read<&Shape::contains>(__func__, world, shape, inside, FinitePoint{x, y});
}

FETTLE_READING(shape, Shape, world_center, fettle_position)
FETTLE_READING(shape, Shape, is_touching, bool)
FETTLE_READING(shape, Shape, rebuilds, uint32_t)
FETTLE_PROPERTY(shape, Shape, user_data, uint64_t)
