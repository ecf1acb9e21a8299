"""Lines as levels have them, made into the points of chains."""

from typing import NamedTuple

from ._call import Invalid, definition, ffi, lib, list_of
from ._properties import to_number
from ._values import Vec2, floats, number_of, pair, points, to_list, vec2, windings


class Line(NamedTuple):
    points: list
    closed: bool


def lines_of(found):
    """Lines from the points that C lists with the numbers of their lines."""
    lines = []
    for p in found:
        if p.line == len(lines):
            lines.append(Line([], p.closed))
        lines[p.line].points.append(vec2(p.point))
    return lines


def join_lines(lines, reach=0.001, straight=0.0, closed="as_given"):
    """Joins lines, each a list of points in any order and direction, into a list of `Line`. Ends nearer than `reach` (m) are
    joined, points that are at most `straight` (m) from the line are dropped. `closed`: the direction of closed lines,
    "as_given", "clockwise" or "counter_clockwise"."""
    given = [(pair(point, "a point"), number) for number, line in enumerate(to_list(lines, "lines")) for point in to_list(line, "a line")]
    made = ffi.new("fettle_line_point[]", len(given))
    for out, ((x, y), number) in zip(made, given):
        out.point.x, out.point.y, out.line = x, y, number
    options = definition("fettle_join_options")
    options.reach, options.straight = to_number("float", reach, "reach"), to_number("float", straight, "straight")
    options.closed = number_of(windings, closed, "closed")
    return lines_of(list_of("fettle_line_point", lambda *a: lib.fettle_join_lines(made, len(given), options, *a)))


def without_straight_points(line, straight, closed=False):
    """The points without those that are at most `straight` (m) from the line through the others."""
    given, count = points(line)
    distance, is_closed = to_number("float", straight, "straight"), to_number("_Bool", closed, "closed")
    found = list_of("fettle_vec2", lambda *a: lib.fettle_without_straight_points(given, count, is_closed, distance, *a))
    return [vec2(p) for p in found]


def grid_outlines(values, threshold=0.5, origin=Vec2(0, 0), cell=1.0, straight=0.0):
    """The closed outlines of the area where a grid of numbers, row after row, is above `threshold`: clockwise around an area,
    counter-clockwise around a hole. Sample (column, row) is at origin + cell * (column, row)."""
    try:
        array = floats(values)
    except (TypeError, ValueError, OverflowError):
        raise Invalid("values: expected rows of numbers") from None
    if array.ndim != 2:
        raise Invalid(f"values: expected rows of numbers, got an array of shape {array.shape}")
    layout = definition("fettle_grid_layout")
    layout.rows, layout.columns = array.shape
    layout.origin.x, layout.origin.y = pair(origin, "origin")
    layout.cell = to_number("float", cell, "cell")
    begin = ffi.cast("float*", array.ctypes.data)
    limits = to_number("float", threshold, "threshold"), to_number("float", straight, "straight")
    return lines_of(list_of("fettle_line_point",
                            lambda *a: lib.fettle_grid_outlines(begin, array.size, layout, *limits, *a)))
