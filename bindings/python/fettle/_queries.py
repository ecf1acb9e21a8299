"""Queries: shapes at a point, in a box, on a ray, and along a motion."""

from typing import NamedTuple

from . import _callbacks, geometry as geometries
from ._call import Invalid, check, definition, ffi, lib, list_of, unknown
from ._properties import to_function, to_number
from ._values import Vec2, pair, to_aabb, vec2
from .shape import Shape


class RayHit(NamedTuple):
    shape: Shape
    point: Vec2
    normal: Vec2
    fraction: float  # 0 at the start, 1 at the end


class PointHit(NamedTuple):
    shape: Shape
    point: Vec2
    normal: Vec2
    distance: float


def _no_pose(pose):
    if pose is not None:
        raise Invalid(f"pose = {pose!r}: expected none, because a shape is where its body is")


def _visitor(function):
    if to_function(function, "function") is None:
        raise Invalid("function: expected a function, got None")
    return function


class Queries:
    """Part of `World`. Each query takes as `only`: `category`, `mask`, `group` (numbers), `sensors` (whether to find them) and
    `accept`, a function that gets a shape and returns whether it is found."""

    __slots__ = ()

    def _filter(self, only):
        made = definition("fettle_query_filter")
        kept = None
        for name, value in only.items():
            if name == "accept":
                if to_function(value, name) is not None:
                    made.accept = kept = _callbacks.accept(self, value)
            elif name in ("category", "mask", "group", "sensors"):
                ctype = {"group": "int32_t", "sensors": "_Bool"}.get(name, "uint64_t")
                setattr(made, name, to_number(ctype, value, name))
            else:
                raise unknown(f"a query has no {name}", ["accept", "category", "group", "mask", "sensors"])
        return made, kept

    def _shapes(self, call):
        return [Shape(self, i) for i in list_of("fettle_id", call)]

    def _hit(self, found, hit):
        return self._ray_hit(hit) if found[0] else None

    def _ray_hit(self, hit):
        return RayHit(Shape(self, hit.shape), vec2(hit.point), vec2(hit.normal), hit.fraction)

    def query_point(self, point, **only):
        """Shapes that contain a point."""
        at, (given, kept) = pair(point, "point"), self._filter(only)
        return self._shapes(lambda *a: lib.fettle_world_query_point(self._pointer, *at, given, *a))

    def query_aabb(self, box, **only):
        """Shapes that overlap a box: ((left, bottom), (right, top))."""
        within, (given, kept) = to_aabb(box, "box"), self._filter(only)
        return self._shapes(lambda *a: lib.fettle_world_query_aabb(self._pointer, within, given, *a))

    def query_overlap(self, shape, pose=None, **only):
        """Shapes that overlap a shape, or a geometry at a pose: (position, angle)."""
        given, kept = self._filter(only)
        if isinstance(shape, Shape):
            _no_pose(pose)
            return self._shapes(lambda *a: lib.fettle_world_query_overlap(self._pointer, shape._pointer, shape.id, given, *a))
        geometry, points = geometries.to_c(shape)
        at = geometries.to_pose(pose)
        return self._shapes(lambda *a: lib.fettle_world_query_overlap_geometry(self._pointer, geometry, at, given, *a))

    def cast_ray(self, start, end, **only):
        """The first hit on a ray, or None."""
        given, kept = self._filter(only)
        found, hit = ffi.new("bool*"), ffi.new("fettle_ray_hit*")
        check(lib.fettle_world_cast_ray(self._pointer, *pair(start, "start"), *pair(end, "end"), given, found, hit))
        return self._hit(found, hit)

    def cast_ray_all(self, start, end, **only):
        """All hits on a ray, nearest first."""
        given, kept = self._filter(only)
        ray = *pair(start, "start"), *pair(end, "end")
        hits = list_of("fettle_ray_hit", lambda *a: lib.fettle_world_cast_ray_all(self._pointer, *ray, given, *a))
        return [self._ray_hit(hit) for hit in hits]

    def cast_shape(self, shape, motion, pose=None, **only):
        """The first hit of a shape, or of a geometry at a pose, along a motion, or None."""
        given, kept = self._filter(only)
        found, hit = ffi.new("bool*"), ffi.new("fettle_ray_hit*")
        way = pair(motion, "motion")
        if isinstance(shape, Shape):
            _no_pose(pose)
            check(lib.fettle_world_cast_shape(self._pointer, shape._pointer, shape.id, *way, given, found, hit))
        else:
            geometry, points = geometries.to_c(shape)
            check(lib.fettle_world_cast_geometry(self._pointer, geometry, geometries.to_pose(pose), *way, given, found, hit))
        return self._hit(found, hit)

    # Visitors: `function` is called for each shape or hit. If it returns False, the query ends.

    def visit_point(self, point, function, **only):
        """Calls `function(shape)` for shapes that contain a point."""
        (given, kept), visitor = self._filter(only), _callbacks.shape_visitor(self, _visitor(function))
        check(lib.fettle_world_visit_point(self._pointer, *pair(point, "point"), given, visitor, ffi.NULL))

    def visit_aabb(self, box, function, **only):
        """Calls `function(shape)` for shapes that overlap a box: ((left, bottom), (right, top))."""
        (given, kept), visitor = self._filter(only), _callbacks.shape_visitor(self, _visitor(function))
        check(lib.fettle_world_visit_aabb(self._pointer, to_aabb(box, "box"), given, visitor, ffi.NULL))

    def visit_overlap(self, shape, function, pose=None, **only):
        """Calls `function(shape)` for shapes that overlap a shape, or a geometry at a pose."""
        (given, kept), visitor = self._filter(only), _callbacks.shape_visitor(self, _visitor(function))
        if isinstance(shape, Shape):
            _no_pose(pose)
            check(lib.fettle_world_visit_overlap(self._pointer, shape._pointer, shape.id, given, visitor, ffi.NULL))
            return
        geometry, points = geometries.to_c(shape)
        check(lib.fettle_world_visit_overlap_geometry(self._pointer, geometry, geometries.to_pose(pose), given, visitor, ffi.NULL))

    def visit_ray(self, start, end, function, **only):
        """Calls `function(hit)` for all hits on a ray, nearest first."""
        (given, kept), visitor = self._filter(only), _callbacks.ray_visitor(_visitor(function), self._ray_hit)
        check(lib.fettle_world_visit_ray(self._pointer, *pair(start, "start"), *pair(end, "end"), given, visitor, ffi.NULL))

    def closest(self, point, reach=float("inf"), **only):
        """The shape nearest to a point, at most `reach` meters away, or None."""
        given, kept = self._filter(only)
        found, hit = ffi.new("bool*"), ffi.new("fettle_point_hit*")
        check(lib.fettle_world_closest(self._pointer, *pair(point, "point"), to_number("float", reach, "reach"), given, found,
                                       hit))
        return PointHit(Shape(self, hit.shape), vec2(hit.point), vec2(hit.normal), hit.distance) if found[0] else None

    def explode(self, point, radius, impulse, **only):
        """Pushes dynamic bodies away from a point: with `impulse` (N s) there, falling to 0 at `radius` (m)."""
        given, kept = self._filter(only)
        check(lib.fettle_world_explode(self._pointer, *pair(point, "point"), to_number("float", radius, "radius"),
                                       to_number("float", impulse, "impulse"), given))

    def explode_surfaces(self, point, radius, falloff, impulse_per_length, **only):
        """Pushes dynamic bodies away from a point: each shape with an impulse (N s) for each meter of its outline as seen from
        there, which falls to 0 over `falloff` (m) beyond `radius` (m)."""
        given, kept = self._filter(only)
        definition = ffi.new("fettle_explosion_def*")
        check(lib.fettle_explosion_def_init(definition, ffi.sizeof("fettle_explosion_def")))
        definition.point.x, definition.point.y = pair(point, "point")
        definition.radius = to_number("float", radius, "radius")
        definition.falloff = to_number("float", falloff, "falloff")
        definition.impulse_per_length = to_number("float", impulse_per_length, "impulse_per_length")
        check(lib.fettle_world_explode_surfaces(self._pointer, definition, given))
