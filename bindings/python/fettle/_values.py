"""Values of the library as values of Python, and the other way round."""

from numbers import Complex, Real
from typing import NamedTuple

from ._call import Invalid, ffi


class Vec2(NamedTuple):
    x: float
    y: float


class Aabb(NamedTuple):
    """Axis-aligned box, from its lower left to its upper right corner."""
    min: Vec2
    max: Vec2


class Pose(NamedTuple):
    position: Vec2
    angle: float


def names_of(enum, prefix):
    """Names of enumerators by number: FETTLE_BODY_STATIC is "static"."""
    return {n: name[len(prefix):].lower() for n, name in sorted(ffi.typeof("enum " + enum).elements.items())}


body_types = names_of("fettle_body_type", "FETTLE_BODY_")
shape_types = names_of("fettle_shape_type", "FETTLE_SHAPE_")
joint_types = names_of("fettle_joint_type", "FETTLE_JOINT_")
mix_rules = names_of("fettle_mix_rule", "FETTLE_MIX_")
hull_statuses = names_of("fettle_hull_status", "FETTLE_HULL_")
log_levels = names_of("fettle_log_level", "FETTLE_LOG_")
windings = names_of("fettle_winding", "FETTLE_WINDING_")
solvers = names_of("fettle_solver", "FETTLE_SOLVER_")


def number_of(names, text, what):
    """The number of a name."""
    for number, name in names.items():
        if isinstance(text, str) and name == text:
            return number
    raise Invalid(f"{what} = {text!r}: expected one of {', '.join(names.values())}")


def is_real(value):
    """False for what `float` and `int` take although it is no real number: text, and complex numbers of numpy."""
    if type(value) in (float, int):
        return True
    return not isinstance(value, (str, bytes, bytearray)) and (not isinstance(value, Complex) or isinstance(value, Real))


def floats(values):
    """An array of floats in one piece, of anything with real numbers; TypeError, ValueError or OverflowError for anything else."""
    import numpy
    array = numpy.asarray(values)
    if array.size and array.dtype.kind not in "biufO":
        raise TypeError
    with numpy.errstate(over="ignore"):  # the library refuses infinity
        return numpy.ascontiguousarray(array, dtype=numpy.float32)


def pair(value, what="a vector"):
    """Two numbers of anything with two of them."""
    try:
        x, y = value
        if not isinstance(value, (str, bytes, bytearray)) and is_real(x) and is_real(y):
            return float(x), float(y)
    except (TypeError, ValueError, OverflowError):
        pass
    raise Invalid(f"{what}: expected two numbers, got {value!r}")


def to_list(values, what):
    """A list of anything that can be iterated."""
    try:
        return list(values)
    except TypeError:
        raise Invalid(f"{what}: expected a list, got {values!r}") from None


def two(value, what, expected):
    """The two parts of a value."""
    try:
        first, second = value
    except (TypeError, ValueError):
        raise Invalid(f"{what}: expected {expected}, got {value!r}") from None
    return first, second


def vec2(v):
    return Vec2(v.x, v.y)


def aabb(box):
    return Aabb(vec2(box.min), vec2(box.max))


def to_aabb(box, what):
    low, high = two(box, what, "((left, bottom), (right, top))")
    made = ffi.new("fettle_aabb*")
    (made.min.x, made.min.y), (made.max.x, made.max.y) = pair(low, what), pair(high, what)
    return made


def points(values, what="points"):
    """An array in C, and its length."""
    try:
        array = floats(values)
    except (TypeError, ValueError, OverflowError):
        raise Invalid(f"{what}: expected pairs of numbers, got {values!r}") from None
    if array.size == 0:
        return ffi.NULL, 0
    if array.ndim != 2 or array.shape[1] != 2:
        raise Invalid(f"{what}: expected pairs of numbers, got an array of shape {array.shape}")
    made = ffi.new("fettle_vec2[]", len(array))
    ffi.memmove(made, array, array.nbytes)
    return made, len(array)
