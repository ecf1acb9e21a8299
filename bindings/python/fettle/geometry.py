"""Geometry of shapes, in body coordinates, m."""

from dataclasses import dataclass
from typing import NamedTuple, Sequence

from ._call import Invalid, check, definition, ffi, lib, list_of
from ._names import HasMembers
from . import _properties
from ._properties import to_number
from ._values import Pose, Vec2, aabb, pair, points, vec2
from .outlines import lines_of


class MassProperties(NamedTuple):
    area: float  # m2
    mass: float  # kg
    centroid: Vec2
    inertia: float  # kg m2, about the centroid


class SurfaceHit(NamedTuple):
    point: Vec2
    normal: Vec2  # outward
    fraction: float  # 0 at the start of the ray, 1 at its end


class Manifold(NamedTuple):
    """Where two convex parts touch; the normal points from the first to the second."""
    normal: Vec2
    points: list  # of pairs: the point, and the separation in m, negative where they overlap


class Movement(NamedTuple):
    """A uniform motion from one pose to another, during which `center` moves on a straight line."""
    begin: Pose
    end: Pose
    center: Vec2 = Vec2(0, 0)


def to_pose(pose):
    """A pose in C; None stands for the origin."""
    if pose is None:
        return ffi.NULL
    made = ffi.new("fettle_pose*")
    _set_pose(made, pose)
    return made


def _set_pose(made, pose):
    made.position.x, made.position.y, made.angle = _properties.to_pose(pose, "pose")


def _to_movement(movement):
    made, movement = ffi.new("fettle_movement*"), Movement(*movement)
    _set_pose(getattr(made, "from"), movement.begin)
    _set_pose(made.to, movement.end)
    made.center.x, made.center.y = pair(movement.center, "center")
    return made


class Geometry(HasMembers):
    """Measurements that every geometry offers, without a world. A pose is (position, angle); None is the origin."""

    def mass_properties(self, density=1.0):
        """Area, mass and inertia with a density in kg/m2. A chain has none."""
        (given, kept), out = to_c(self), ffi.new("fettle_mass_properties*")
        check(lib.fettle_geometry_mass_properties(given, to_number("float", density, "density"), out))
        return MassProperties(out.area, out.mass, vec2(out.centroid), out.inertia)

    def bounding_box(self, pose=None):
        """The smallest box around it."""
        (given, kept), out = to_c(self), ffi.new("fettle_aabb*")
        check(lib.fettle_geometry_bounding_box(given, to_pose(pose), out))
        return aabb(out)

    def contains(self, point, pose=None):
        """Whether a point is inside or on the edge."""
        (given, kept), out = to_c(self), ffi.new("bool*")
        check(lib.fettle_geometry_contains(given, to_pose(pose), *pair(point, "point"), out))
        return out[0]

    def cast_ray(self, start, end, pose=None):
        """Where a ray enters, or None."""
        (given, kept), found, hit = to_c(self), ffi.new("bool*"), ffi.new("fettle_surface_hit*")
        check(lib.fettle_geometry_cast_ray(given, to_pose(pose), *pair(start, "start"), *pair(end, "end"), found, hit))
        return SurfaceHit(vec2(hit.point), vec2(hit.normal), hit.fraction) if found[0] else None

    def distance(self, other, pose=None, other_pose=None):
        """Distance to another geometry (m), and the nearest points on this and on the other one."""
        (a, kept_a), (b, kept_b), out = to_c(self), to_c(other), ffi.new("fettle_separation*")
        check(lib.fettle_geometry_distance(a, to_pose(pose), b, to_pose(other_pose), out))
        return out.distance, vec2(out.point_a), vec2(out.point_b)

    def contact_manifolds(self, other, pose=None, other_pose=None, margin=0.0):
        """Where it touches another geometry, or is nearer than `margin` (m): one `Manifold` for each pair of convex parts."""
        (a, kept_a), (b, kept_b), poses = to_c(self), to_c(other), (to_pose(pose), to_pose(other_pose))
        reach = to_number("float", margin, "margin")
        found = list_of("fettle_contact_manifold", lambda *out: lib.fettle_geometry_contact_manifolds(
            a, poses[0], b, poses[1], reach, *out))
        return [Manifold(vec2(m.normal), [(vec2(p.point), p.separation) for p in m.points[0:m.point_count]]) for m in found]

    def time_of_impact(self, movement, other, other_movement):
        """The fraction of two movements (`Movement`) at which both first touch, or None."""
        (a, kept_a), (b, kept_b), found, out = to_c(self), to_c(other), ffi.new("bool*"), ffi.new("float*")
        check(lib.fettle_geometry_time_of_impact(a, _to_movement(movement), b, _to_movement(other_movement), found, out))
        return out[0] if found[0] else None

    def parts(self):
        """The points of its convex parts: corners, pieces of a concave polygon, segments of a chain."""
        given, kept = to_c(self)
        return [line.points for line in lines_of(list_of("fettle_line_point", lambda *a: lib.fettle_geometry_parts(given, *a)))]


@dataclass
class Circle(Geometry):
    radius: float = 0.5
    center: Vec2 = Vec2(0, 0)


@dataclass
class Box(Geometry):
    width: float = 1.0  # full, with the rounding
    height: float = 1.0
    center: Vec2 = Vec2(0, 0)
    angle: float = 0.0
    rounding: float = 0.0


@dataclass
class Segment(Geometry):
    """A capsule if `rounding` is positive."""
    begin: Vec2 = Vec2(-0.5, 0)
    end: Vec2 = Vec2(0.5, 0)
    rounding: float = 0.0


@dataclass
class Polygon(Geometry):
    """The hull of points in any order."""
    points: Sequence
    rounding: float = 0.0


@dataclass
class Ellipse(Geometry):
    radius_x: float = 0.5
    radius_y: float = 0.25
    center: Vec2 = Vec2(0, 0)
    angle: float = 0.0


@dataclass
class Concave(Geometry):
    """The outline of a polygon that may be concave."""
    points: Sequence


@dataclass
class Chain(Geometry):
    """A line of segments, solid for bodies on its left."""
    points: Sequence
    closed: bool = False


classes = [Circle, Box, Segment, Polygon, Ellipse, Concave, Chain]  # in the order of fettle_shape_type
_in_c = {"begin": "from", "end": "to"}


def to_c(geometry):
    """The geometry in C. Its points live as long as the second result."""
    if type(geometry) not in classes:
        raise Invalid(f"geometry: expected {', '.join(c.__name__ for c in classes)}, got {geometry!r}")
    made = definition("fettle_geometry", classes.index(type(geometry)))
    kept = None
    for name in geometry.__dataclass_fields__:
        value, member = getattr(geometry, name), _in_c.get(name, name)
        if name == "points":
            kept, made.point_count = points(value)
            made.points = kept
        elif name in ("center", "begin", "end"):
            vector = getattr(made, member)
            vector.x, vector.y = pair(value, name)
        else:
            setattr(made, member, to_number("_Bool" if name == "closed" else "float", value, name))
    return made, kept


def from_c(struct, vertices):
    """The geometry of a structure in C. `vertices`: its points."""
    cls = classes[struct.type]
    values = {}
    for name in cls.__dataclass_fields__:
        value = vertices if name == "points" else getattr(struct, _in_c.get(name, name))
        values[name] = vec2(value) if name in ("center", "begin", "end") else value
    return cls(**values)


def convex_hull(of):
    """The hull of points, counter-clockwise from the lowest of the leftmost ones."""
    given, count = points(of)
    status = ffi.new("int32_t*")
    hull = list_of("fettle_vec2", lambda out, room, n: lib.fettle_convex_hull(given, count, out, room, n, status))
    if status[0] != lib.FETTLE_HULL_OK:
        raise Invalid("points: " + ffi.string(lib.fettle_describe(status[0])).decode())
    return [vec2(p) for p in hull]
