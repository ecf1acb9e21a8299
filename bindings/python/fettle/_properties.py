"""Properties of Python from the getters and setters of the interface in C."""

from ._call import Invalid, check, ffi, lib, type_of
from ._values import Pose, aabb, is_real, pair, two, vec2

_convert = {
    "float": None,
    "_Bool": None,
    "int32_t": None,
    "uint32_t": None,
    "uint64_t": None,
    "struct fettle_vec2": vec2,
    "struct fettle_aabb": aabb,
    "struct fettle_pose": lambda pose: Pose(vec2(pose.position), pose.angle),
}
_not_settings = {"size", "body", "body_a", "body_b"}  # members of definitions that `set_members` does not set
_whole = {"int32_t": (-(1 << 31), (1 << 31) - 1), "uint32_t": (0, (1 << 32) - 1), "uint64_t": (0, (1 << 64) - 1)}


def to_number(ctype, value, name):
    """A value for an argument in C, or an error that names it."""
    expected = {"_Bool": "True or False", "float": "a number"}.get(ctype, f"a whole number that fits {ctype}")
    try:
        if ctype == "_Bool":
            if value in (False, True):
                return bool(value)
        elif ctype == "float":
            if is_real(value):
                return float(value)
        elif is_real(value) and int(value) == value and _whole[ctype][0] <= value <= _whole[ctype][1]:
            return int(value)
    except (TypeError, ValueError, OverflowError):
        pass
    raise Invalid(f"{name} = {value!r}: expected {expected}")


def set_members(made, values):
    """Moves values into the members of a definition in C that have their names. None: the library measures the value."""
    members = dict(ffi.typeof(made).item.fields)
    for name in [name for name in values if name in members and name not in _not_settings and not name.startswith("has_")]:
        value, has, ctype = values.pop(name), "has_" + name, members[name].type.cname
        if has in members:
            setattr(made, has, value is not None)
            if value is None:
                continue
        if ctype == "struct fettle_vec2":
            vector = getattr(made, name)
            vector.x, vector.y = pair(value, name)
        else:
            setattr(made, name, to_number(ctype, value, name))


def to_pose(value, what):
    """x, y and angle of a pose."""
    position, angle = two(value, what, "a pose: (position, angle)")
    return *pair(position, "position"), to_number("float", angle, "angle")


def to_function(value, name):
    """A function of the program that the library calls later, or None."""
    if value is not None and not callable(value):
        raise Invalid(f"{name}: expected a function, got {value!r}")
    return value


def to_bytes(value, name):
    """A view of bytes for C."""
    try:
        return ffi.from_buffer(value)
    except TypeError:
        raise Invalid(f"{name}: expected bytes, got {type(value).__name__}") from None
    except (ValueError, BufferError) as error:
        raise Invalid(f"{name}: expected bytes in one piece: {error}") from None


def to_text(value, name):
    """The bytes of a text for C."""
    if not isinstance(value, str) or "\0" in value:
        raise Invalid(f"{name} = {value!r}: expected a text without a zero")
    try:
        return value.encode()
    except UnicodeEncodeError as error:
        raise Invalid(f"{name} = {value!r}: expected a text of Unicode: {error.reason}") from None


def _getter(function, out, has_id):
    convert = _convert[out]

    def get(self):
        result = ffi.new(out + "*")
        check(function(self._pointer, self.id, result) if has_id else function(self._pointer, result))
        return convert(result[0]) if convert else result[0]

    return get


def _setter(function, types, has_id, name):
    def set(self, value):
        values = pair(value, name) if len(types) == 2 else (to_number(types[0], value, name),)
        check(function(self._pointer, self.id, *values) if has_id else function(self._pointer, *values))

    return set


bound = set()  # the functions in C that properties call


def bind(prefix, has_id=True):
    """A decorator: gives a class a property for each function `fettle_PREFIX_NAME` in C that has nothing but a plain result,
    and lets it be set where there is `fettle_PREFIX_set_NAME`. What the class has already stays."""
    begin, first = f"fettle_{prefix}_", 2 if has_id else 1

    def decorate(cls):
        functions = {name: getattr(lib, name) for name in dir(lib) if name.startswith(begin)}
        for full, function in functions.items():
            name, types = full[len(begin):], type_of(full).args
            if name in cls.__dict__ or name.startswith("set_") or len(types) != first + 1:
                continue
            out = types[first]
            if out.kind != "pointer" or out.item.cname not in _convert or has_id and types[1].cname != "uint64_t":
                continue
            setter = None
            if (set_name := begin + "set_" + name) in functions:
                values = [value.cname for value in type_of(set_name).args[first:]]
                if all(value in _convert for value in values):
                    setter = _setter(functions[set_name], values, has_id, name)
                    bound.add(set_name)
            bound.add(full)
            setattr(cls, name, property(_getter(function, out.item.cname, has_id), setter))
        return cls

    return decorate
