"""Functions of Python that a world calls."""

from ._call import ffi, keep_exception
from ._values import vec2
from .shape import Shape


class ContactEdit:
    """A contact about to be solved. `friction`, `restitution`, `surface_speed` and `enabled` may be set; it is valid during the
    call."""

    __slots__ = ("world", "_c")

    def __init__(self, world, c):
        object.__setattr__(self, "world", world)
        object.__setattr__(self, "_c", c)

    def __getattr__(self, name):
        value = getattr(self._c, name)
        if name in ("shape_a", "shape_b"):
            return Shape(self.world, value)
        return vec2(value) if name in ("point", "normal") else value

    def __setattr__(self, name, value):
        if name not in ("friction", "restitution", "surface_speed", "enabled"):
            raise AttributeError(f"{name} of a contact cannot be set")
        setattr(self._c, name, value)


def pair_filter(world, function):
    return ffi.callback("fettle_pair_filter", lambda user, pointer, a, b: bool(function(Shape(world, a), Shape(world, b))),
                        error=True, onerror=keep_exception)


def contact_callback(world, function):
    def call(user, pointer, contact):
        function(ContactEdit(world, contact))

    return ffi.callback("fettle_contact_callback", call, onerror=keep_exception)


def accept(world, function):
    return ffi.callback("fettle_accept", lambda user, pointer, shape: bool(function(Shape(world, shape))),
                        error=False, onerror=keep_exception)
