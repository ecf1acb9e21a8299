"""Shapes and their contacts."""

from typing import NamedTuple

from . import geometry as geometries
from ._call import Invalid, check, definition, ffi, lib, list_of, unknown
from ._handle import Handle, id_of
from ._properties import bind, to_number
from ._values import Vec2, hull_statuses, to_list, pair, points, shape_types, vec2


class ContactPoint(NamedTuple):
    point: Vec2
    separation: float  # m, negative: overlap
    normal_impulse: float  # N s in one sub-step
    tangent_impulse: float
    feature: int  # identifies the vertex and edge between steps


class Contact(NamedTuple):
    """Two shapes that touch; the normal points from a to b."""
    body_a: object
    body_b: object
    shape_a: object
    shape_b: object
    normal: Vec2
    points: list
    friction: float
    restitution: float
    normal_force: float
    part_a: int  # segment of a chain or piece of a concave polygon, from 0
    part_b: int
    material_a: int  # of the shapes, or of the segments of chains
    material_b: int


class SegmentSurface(NamedTuple):
    """The surface of one segment of a chain."""
    friction: float = 0.6
    restitution: float = 0.0
    rolling_resistance: float = 0.0
    surface_speed: float = 0.0  # m/s, against the order of the points
    material: int = 0


def _surface_of(c):
    return SegmentSurface(*(getattr(c, name) for name in SegmentSurface._fields))


def _surface_to_c(surface):
    types = {name: member.type.cname for name, member in ffi.typeof("fettle_segment_surface").fields}
    if not isinstance(surface, SegmentSurface):
        raise Invalid(f"expected a SegmentSurface, got {surface!r}")
    return {name: to_number(types[name], getattr(surface, name), name) for name in SegmentSurface._fields}


def _id_of_body(body):
    from .body import Body
    return id_of(body, Body)


def contact_of(world, c):
    from .body import Body
    points = [ContactPoint(vec2(p.point), p.separation, p.normal_impulse, p.tangent_impulse, p.feature)
              for p in c.points[0:c.point_count]]
    return Contact(Body(world, c.body_a), Body(world, c.body_b), Shape(world, c.shape_a), Shape(world, c.shape_b),
                   vec2(c.normal), points, c.friction, c.restitution, c.normal_force, c.part_a, c.part_b, c.material_a, c.material_b)


_members = {m[0]: m[1].type.cname for m in ffi.typeof("fettle_shape_def").fields if m[0] != "size"}


@bind("shape")
class Shape(Handle):
    """A shape of a body. Its properties are those of fettle/physics_c/shape.h, with the same names, but for the ends of a
    segment, which are `begin` and `end`."""

    __slots__ = ()
    _made_by = "body.add(geometry)"

    @staticmethod
    def _definition(properties):
        made = definition("fettle_shape_def")
        for name, value in properties.items():
            if name not in _members:
                raise unknown(f"a shape has no property {name}", _members)
            setattr(made, name, to_number(_members[name], value, name))
        return made

    @property
    def is_valid(self):
        return lib.fettle_shape_is_valid(self._pointer, self.id)

    def destroy(self):
        check(lib.fettle_shape_destroy(self._pointer, self.id))

    @property
    def type(self):
        """"circle", "box", "segment", "polygon", "ellipse", "concave", "chain" or "border"."""
        number = ffi.new("int32_t*")
        check(lib.fettle_shape_type(self._pointer, self.id, number))
        return shape_types[number[0]]

    @property
    def body(self):
        """The body that it is attached to, or None."""
        from .body import body_or_none
        out = ffi.new("fettle_id*")
        check(lib.fettle_shape_body(self._pointer, self.id, out))
        return body_or_none(self.world, out[0])

    def attach(self, body):
        check(lib.fettle_shape_attach(self._pointer, self.id, _id_of_body(body)))

    def detach(self):
        check(lib.fettle_shape_detach(self._pointer, self.id))

    @property
    def geometry(self):
        """A `Circle`, `Box`, ...: a copy. Setting it may change the type of the shape."""
        struct = definition("fettle_geometry", 0)
        check(lib.fettle_shape_geometry(self._pointer, self.id, struct))
        return geometries.from_c(struct, self.vertices)

    @geometry.setter
    def geometry(self, geometry):
        given, kept = geometries.to_c(geometry)
        check(lib.fettle_shape_set_geometry(self._pointer, self.id, given))

    @property
    def vertices(self):
        """Body coordinates: the hull of a polygon, the corners of a box or segment, the points of a chain or outline."""
        found = list_of("fettle_vec2", lambda *a: lib.fettle_shape_vertices(self._pointer, self.id, *a))
        return [vec2(p) for p in found]

    @vertices.setter
    def vertices(self, values):
        given, count = points(values, "vertices")
        check(lib.fettle_shape_set_vertices(self._pointer, self.id, given, count))

    def try_set_vertices(self, values):
        """Polygon: becomes the hull of points and returns "ok", or says what is wrong with them, as in "collinear"."""
        (given, count), status = points(values, "vertices"), ffi.new("int32_t*")
        check(lib.fettle_shape_try_set_vertices(self._pointer, self.id, given, count, status))
        return hull_statuses[status[0]]

    def segment_surface(self, segment):
        """Chain: the surface of a segment: its own values, and those of the shape for the others. They count from 0."""
        out = ffi.new("fettle_segment_surface*")
        check(lib.fettle_shape_segment_surface(self._pointer, self.id, to_number("uint32_t", segment, "segment"), out))
        return _surface_of(out)

    def segment_surface_override(self, segment):
        """Chain: the own surface of a segment, or None."""
        is_set, out = ffi.new("bool*"), ffi.new("fettle_segment_surface*")
        number = to_number("uint32_t", segment, "segment")
        check(lib.fettle_shape_segment_surface_override(self._pointer, self.id, number, is_set, out))
        return _surface_of(out) if is_set[0] else None

    def set_segment_surface(self, segment, surface):
        """Chain: gives a segment a surface of its own. None: that of the shape, as is each number that is infinite."""
        made = ffi.NULL if surface is None else ffi.new("fettle_segment_surface*", _surface_to_c(surface))
        number = to_number("uint32_t", segment, "segment")
        check(lib.fettle_shape_set_segment_surface(self._pointer, self.id, number, made))

    def set_segment_surfaces(self, surfaces):
        """Chain: the surfaces of all segments in order; an empty list: all have that of the shape."""
        made = [_surface_to_c(surface) for surface in to_list(surfaces, "surfaces")]
        given = ffi.new("fettle_segment_surface[]", made) if made else ffi.NULL
        check(lib.fettle_shape_set_segment_surfaces(self._pointer, self.id, given, len(made)))

    def add_vertex(self, point):
        """Polygon: becomes the hull with one point more."""
        check(lib.fettle_shape_add_vertex(self._pointer, self.id, *pair(point, "point")))

    @property
    def pieces(self):
        """Points of the convex pieces of a concave polygon, or of the segments of a chain."""
        pieces, found = ffi.new("uint32_t*", 1), []
        while len(found) < pieces[0]:
            piece = list_of("fettle_vec2", lambda out, room, count: lib.fettle_shape_pieces(
                self._pointer, self.id, len(found), out, room, count, pieces))
            if len(found) < pieces[0]:
                found.append([vec2(p) for p in piece])
        return found

    @property
    def world_vertices(self):
        """As `vertices`, in the world."""
        found = list_of("fettle_vec2", lambda *a: lib.fettle_shape_world_vertices(self._pointer, self.id, *a))
        return [vec2(p) for p in found]

    def contains(self, point):
        """Whether a point of the world is inside."""
        out = ffi.new("bool*")
        check(lib.fettle_shape_contains(self._pointer, self.id, *pair(point, "point"), out))
        return out[0]

    def distance(self, other):
        """Distance to another shape (m), and the nearest points on this and on the other one."""
        if not isinstance(other, Shape):
            raise Invalid(f"expected a Shape, got {other!r}")
        out = ffi.new("fettle_separation*")
        check(lib.fettle_distance(self._pointer, self.id, other._pointer, other.id, out))
        return out.distance, vec2(out.point_a), vec2(out.point_b)


Shape.begin = vars(Shape)["from"]
Shape.end = Shape.to
