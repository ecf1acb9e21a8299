"""What bodies, shapes, joints and fields have in common."""

from ._call import Invalid, unknown
from ._names import HasProperties, settable

slot_mask = (1 << 28) - 1


class Handle(HasProperties):
    """Names an object of a world. It may outlive the object; then its methods raise `Stale`."""

    __slots__ = ("world", "id")
    _made_by = "a method of a world"

    def __init__(self, world=None, id=None, *more, **values):
        if id is None or more or values:
            raise Invalid(f"{type(self).__name__} names what a world has; {self._made_by} makes one")
        self.world = world
        self.id = id

    @property
    def _pointer(self):
        return self.world._pointer

    @property
    def slot(self):
        """Index of the object in the arrays of its world."""
        return self.id & slot_mask

    def __eq__(self, other):
        return isinstance(other, Handle) and self.id == other.id and self.world is other.world

    def __hash__(self):
        return hash(self.id)

    def __repr__(self):
        return f"<{type(self).__name__} {self.slot}{'' if self.is_valid else ', destroyed'}>"

    def _set_all(self, values):
        """Sets properties by name."""
        for name, value in values.items():
            known = getattr(type(self), name, None)
            if not isinstance(known, property) or known.fset is None:
                raise unknown(f"{type(self).__name__} has no settable property {name}", settable(type(self)))
            setattr(self, name, value)


def id_of(thing, kind):
    """Id of an object of a kind; None stands for 0."""
    if thing is None:
        return 0
    if not isinstance(thing, kind):
        raise Invalid(f"expected a {kind.__name__}, got {thing!r}")
    return thing.id
