"""Names that a program misspells where it sets an attribute."""

from ._call import unknown


def settable(kind):
    """Names of the properties of a class that can be set."""
    return [name for name in dir(kind) if isinstance(known := getattr(kind, name), property) and known.fset]


class HasProperties:
    """For classes with `__slots__`: an error for another name has the nearest one."""

    __slots__ = ()

    def __setattr__(self, name, value):
        try:
            object.__setattr__(self, name, value)
        except AttributeError:
            kind = type(self)
            known = getattr(kind, name, None)
            if isinstance(known, property) and known.fset is None:
                raise AttributeError(f"{kind.__name__}.{name} can be read, but not set") from None
            if known is not None:
                raise
            raise unknown(f"{kind.__name__} has no settable property {name}", settable(kind), AttributeError) from None


class HasMembers:
    """For dataclasses: another name is an error, which has the nearest one."""

    __slots__ = ()

    def __setattr__(self, name, value):
        if name not in self.__dataclass_fields__:
            raise unknown(f"{type(self).__name__} has no member {name}", self.__dataclass_fields__, AttributeError)
        object.__setattr__(self, name, value)
