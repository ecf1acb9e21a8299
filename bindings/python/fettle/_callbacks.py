"""Functions of Python that a world calls."""

import weakref

from ._call import Stale, called_by, ffi, keep_exception
from ._properties import to_number, to_pose
from ._values import Pose, pair, vec2
from .body import Body
from .shape import Shape


class Edit:
    """A structure that the library passes to a function of the program, which may set some members. It is valid during the call."""

    __slots__ = ("world", "_c")
    settable = ()

    def __init__(self, world, c):
        object.__setattr__(self, "world", world)
        object.__setattr__(self, "_c", c)

    def _valid(self):
        if self._c is None:
            raise Stale(f"the {type(self).__name__} is valid only during the call that has got it")
        return self._c

    def __getattr__(self, name):
        if name.startswith("_"):  # such as what `copy` asks for
            raise AttributeError(f"a {type(self).__name__} has no {name}")
        value = getattr(self._valid(), name)
        if name in ("shape_a", "shape_b"):
            return Shape(self.world, value)
        if name == "body":
            return Body(self.world, value)
        if not isinstance(value, ffi.CData):
            return value
        return vec2(value) if ffi.typeof(value).cname == "struct fettle_vec2" else Pose(vec2(value.position), value.angle)

    def __setattr__(self, name, value):
        if name not in self.settable:
            raise AttributeError(f"{name} of a {type(self).__name__} cannot be set; there are {', '.join(self.settable)}")
        member = getattr(self._valid(), name)
        if not isinstance(member, ffi.CData):
            setattr(self._c, name, to_number("_Bool" if isinstance(member, bool) else "float", value, name))
        elif ffi.typeof(member).cname == "struct fettle_vec2":
            member.x, member.y = pair(value, name)
        else:
            member.position.x, member.position.y, member.angle = to_pose(value, name)


class ContactEdit(Edit):
    """A contact about to be solved."""

    __slots__ = ()
    settable = ("friction", "restitution", "surface_speed", "enabled", "ignored")


class VelocityEdit(Edit):
    """The motion of a body in a step, before contacts and joints act."""

    __slots__ = ()
    settable = ("velocity", "angular_velocity")


class PositionEdit(Edit):
    """The pose of a body at the end of a step."""

    __slots__ = ()
    settable = ("pose",)


def _edits(ctype, kind):
    def make(world, function):
        def call(user, pointer, c):
            edit = kind(world, c)
            try:
                with called_by(world):
                    function(edit)
            finally:
                object.__setattr__(edit, "_c", None)

        return ffi.callback(ctype, call, onerror=keep_exception)

    return make


contact_callback = _edits("fettle_contact_callback", ContactEdit)
velocity_function = _edits("fettle_velocity_function", VelocityEdit)
position_function = _edits("fettle_position_function", PositionEdit)


def pair_filter(world, function):
    def call(user, pointer, a, b):
        with called_by(world):
            return bool(function(Shape(world, a), Shape(world, b)))

    return ffi.callback("fettle_pair_filter", call, error=True, onerror=keep_exception)


def accept(world, function):
    return ffi.callback("fettle_accept", lambda user, pointer, shape: bool(function(Shape(world, shape))),
                        error=False, onerror=keep_exception)


def shape_visitor(world, function):
    return ffi.callback("fettle_shape_visitor", lambda user, pointer, shape: function(Shape(world, shape)) is not False,
                        error=False, onerror=keep_exception)


def ray_visitor(function, hit_of):
    return ffi.callback("fettle_ray_visitor", lambda user, pointer, hit: function(hit_of(hit)) is not False,
                        error=False, onerror=keep_exception)


class RecordingSink:
    """Gives the parts of a recording to a function. If that raises, the recording ends, because a part would be missing."""

    def __init__(self, world, function):
        self.ended = False  # the function gets no more parts
        self.in_step = False  # the call that has started the recording is over

        def call(user, pointer, begin, size):
            if self.ended:
                return
            try:
                with called_by(world):
                    function(ffi.buffer(begin, size)[:])
            except BaseException:
                self.ended = True
                if self.in_step:
                    world.after_step(world.stop_recording)
                raise

        self.callback = ffi.callback("fettle_recording_sink", call, onerror=keep_exception)


def after_step(world):
    """Calls the first of the functions that wait."""
    known = weakref.ref(world)

    def call(user, pointer):
        with called_by(known()):
            known()._waiting.popleft()()

    return ffi.callback("fettle_after_step", call, onerror=keep_exception)
