"""Fields of force."""

from dataclasses import dataclass
from typing import Optional

from ._call import Invalid, check, definition, lib
from ._handle import Handle
from ._names import HasMembers
from ._properties import to_number
from ._values import Aabb, Vec2, aabb, pair, to_aabb, vec2


@dataclass
class _Force(HasMembers):
    region: Optional[Aabb] = None  # None: everywhere
    mask: int = (1 << 64) - 1
    enabled: bool = True
    user_data: int = 0


@dataclass
class Wind(_Force):
    velocity: Vec2 = Vec2(5, 0)
    density: float = 1.2


@dataclass
class Drag(_Force):
    flow: Vec2 = Vec2(0, 0)
    linear: float = 1.0
    quadratic: float = 0.0


@dataclass
class Buoyancy(_Force):
    level: float = 0.0
    normal: Vec2 = Vec2(0, 1)
    density: float = 2.0
    drag: float = 2.0
    flow: Vec2 = Vec2(0, 0)


@dataclass
class Attractor(_Force):
    center: Vec2 = Vec2(0, 0)
    strength: float = 10.0
    falloff: int = 2
    core: float = 0.5


_classes = [Wind, Drag, Buoyancy, Attractor]  # in the order of fettle_field_type
_vectors = ("velocity", "flow", "normal", "center")
_whole = {"mask": "uint64_t", "user_data": "uint64_t", "enabled": "_Bool", "falloff": "int32_t"}


def to_c(force):
    if type(force) not in _classes:
        raise Invalid(f"field: expected {', '.join(c.__name__ for c in _classes)}, got {force!r}")
    made = definition("fettle_field_def", _classes.index(type(force)))
    for name in force.__dataclass_fields__:
        value = getattr(force, name)
        if name == "region":
            made.has_region = value is not None
            if value is not None:
                made.region = to_aabb(value, "region")[0]
        elif name in _vectors:
            vector = getattr(made, name)
            vector.x, vector.y = pair(value, name)
        else:
            setattr(made, name, to_number(_whole.get(name, "float"), value, name))
    return made


class Field(Handle):
    """A field of force in a world."""

    __slots__ = ()
    _made_by = "world.field(force)"

    @property
    def is_valid(self):
        return lib.fettle_field_is_valid(self._pointer, self.id)

    def destroy(self):
        check(lib.fettle_field_destroy(self._pointer, self.id))

    @property
    def force(self):
        """A `Wind`, `Drag`, `Buoyancy` or `Attractor`: a copy. Setting it may change its type."""
        made = definition("fettle_field_def", 0)
        check(lib.fettle_field_definition(self._pointer, self.id, made))
        cls = _classes[made.type]
        values = {}
        for name in cls.__dataclass_fields__:
            value = getattr(made, name)
            if name == "region":
                value = aabb(value) if made.has_region else None
            values[name] = vec2(value) if name in _vectors else value
        return cls(**values)

    @force.setter
    def force(self, force):
        check(lib.fettle_field_set(self._pointer, self.id, to_c(force)))
