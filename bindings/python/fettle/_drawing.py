"""Drawing of a world by functions of Python."""

from ._call import Invalid, definition, ffi, keep_exception, unknown
from ._properties import to_number
from ._values import to_aabb, vec2
from .body import Body
from .shape import Shape

_flags = ("shapes", "joints", "contacts", "boxes", "centers")


def _functions(world, target):
    """The functions in C for the methods that the target has."""
    def polygon(user, points, count, closed, color):
        target.polygon([vec2(points[i]) for i in range(count)], closed, color)

    def circle(user, center, radius, angle, color):
        target.circle(vec2(center), radius, angle, color)

    def segment(user, begin, end, color):
        target.segment(vec2(begin), vec2(end), color)

    def point(user, at, color):
        target.point(vec2(at), color)

    def color_of(user, pointer, body, shape):
        return to_number("uint32_t", target.color_of(Body(world, body), Shape(world, shape)), "color_of")

    calls = dict(polygon=polygon, circle=circle, segment=segment, point=point, color_of=color_of)
    if not any(callable(getattr(target, name, None)) for name in calls):
        raise Invalid(f"expected a target with some of the methods {', '.join(calls)}, got {target!r}")
    members = dict(ffi.typeof("fettle_debug_draw").fields)
    return {name: ffi.callback(members[name].type, call, onerror=keep_exception)
            for name, call in calls.items()
            if callable(getattr(target, name, None))}


def drawing_of(world, target, options):
    """The definition in C, and what must live as long as it is used."""
    made, functions = definition("fettle_debug_draw"), _functions(world, target)
    for name, function in functions.items():
        setattr(made, name, function)
    for name, value in options.items():
        if name in _flags:
            setattr(made, name, to_number("_Bool", value, name))
        elif name == "fraction":
            made.fraction = to_number("float", value, name)
        elif name == "region":
            made.has_region = value is not None
            if value is not None:
                made.region = to_aabb(value, name)[0]
        else:
            raise unknown(f"draw has no {name}", [*_flags, "region", "fraction"])
    return made, functions
