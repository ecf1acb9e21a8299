"""Geometry of shapes, in body coordinates, m."""

from dataclasses import dataclass
from typing import Sequence

from ._call import Invalid, definition, ffi, lib, list_of
from ._properties import to_number
from ._values import Vec2, pair, points, vec2


@dataclass
class Circle:
    radius: float = 0.5
    center: Vec2 = Vec2(0, 0)


@dataclass
class Box:
    width: float = 1.0  # full, with the rounding
    height: float = 1.0
    center: Vec2 = Vec2(0, 0)
    angle: float = 0.0
    rounding: float = 0.0


@dataclass
class Segment:
    """A capsule if `rounding` is positive."""
    begin: Vec2 = Vec2(-0.5, 0)
    end: Vec2 = Vec2(0.5, 0)
    rounding: float = 0.0


@dataclass
class Polygon:
    """The hull of points in any order."""
    points: Sequence
    rounding: float = 0.0


@dataclass
class Ellipse:
    radius_x: float = 0.5
    radius_y: float = 0.25
    center: Vec2 = Vec2(0, 0)
    angle: float = 0.0


@dataclass
class Concave:
    """The outline of a polygon that may be concave."""
    points: Sequence


@dataclass
class Chain:
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


def from_c(told, vertices):
    """The geometry that C tells; `vertices`: its points."""
    cls = classes[told.type]
    values = {}
    for name in cls.__dataclass_fields__:
        value = vertices if name == "points" else getattr(told, _in_c.get(name, name))
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
