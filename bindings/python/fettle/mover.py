"""Characters that walk through a world."""

from contextlib import contextmanager
from typing import NamedTuple, Optional

from ._call import Error, Invalid, check, definition, ffi, lib, list_of, unknown
from ._handle import id_of
from ._names import HasProperties
from ._properties import to_number
from ._values import Vec2, pair, to_list, vec2
from .body import Body, body_or_none
from .shape import Shape


class Moved(NamedTuple):
    """What happened in a move."""
    motion: Vec2  # m, the ride on the ground included
    velocity: Vec2  # for the next move, m/s: relative to the ground, in the air to the world
    ground_normal: Vec2  # zero in the air
    ground_velocity: Vec2  # of the ground, without what walls keep from it, m/s
    wall_normal: Vec2  # of the last wall or ceiling that it hit
    ground: Optional[Shape]
    wall: Optional[Shape]
    on_ground: bool
    hit_wall: bool
    hit_ceiling: bool
    stepped: bool  # it climbed a step
    crushed: bool  # it has no place between what presses it


class MoverState(NamedTuple):
    """All that a mover keeps from move to move."""
    position: Vec2
    ground_normal: Vec2
    ground_velocity: Vec2  # with which its ground carries it, m/s; zero in the air but after a drop
    ground: Optional[Shape]
    dropped: Optional[Shape]
    on_ground: bool
    climbing: bool
    ground_part: int = 0  # segment or piece of the ground, as in `Contact`


class MoverPlane(NamedTuple):
    """A plane that bounds the motion of a mover; the normal points from the shape to the mover."""
    normal: Vec2
    point: Vec2
    separation: float  # m, negative: overlap
    shape: Shape


_settings = {name: member.type.cname for name, member in ffi.typeof("fettle_mover_def").fields if name != "size"}


@contextmanager
def _errors_of_mover(function):
    """Errors of this function in C name the mover instead of the function."""
    try:
        yield
    except Error as error:
        raise type(error)(str(error).replace(function, "Mover")) from None


def _shape_or_none(world, id):
    return Shape(world, id) if id else None


def _setting_property(name):
    def read(self):
        value = getattr(self._definition, name)
        if name == "body":
            return body_or_none(self.world, value)
        return vec2(value) if name == "up" else value

    def write(self, value):
        self._check_and_set({name: value}, self._state)

    return property(read, write)


def _state_property(name, convert=lambda world, value: value):
    return property(lambda self: convert(self.world, getattr(self._state, name)))


class Mover(HasProperties):
    """An upright capsule that slides along walls, climbs slopes and steps, rides on moving platforms and pushes crates. It is no
    object of the world: bodies do not see it. Its settings are the members of `fettle_mover_def` in
    fettle/physics_c/mover.h, and properties. `position` is its lowest point, m."""

    __slots__ = ("world", "_definition", "_state")

    def __init__(self, world, position=(0, 0), **settings):
        from .world import World
        if not isinstance(world, World):
            raise Invalid(f"expected a World, got {world!r}")
        self.world = world
        self._definition = definition("fettle_mover_def")
        state = definition("fettle_mover_state")
        state.position.x, state.position.y = pair(position, "position")
        self._check_and_set(settings, state)

    def _check_and_set(self, settings, state):
        """Sets settings and a state after the library has checked them; if it refuses them, nothing changes."""
        made = ffi.new("fettle_mover_def*", self._definition[0])
        for name, value in settings.items():
            if name not in _settings:
                raise unknown(f"a mover has no setting {name}", _settings)
            if name == "body":
                made.body = id_of(value, Body)
            elif name == "up":
                made.up.x, made.up.y = pair(value, name)
            else:
                setattr(made, name, to_number(_settings[name], value, name))
        with _errors_of_mover("fettle_mover_fits"):  # a function that checks everything
            check(lib.fettle_mover_fits(self.world._pointer, made, state, made.height, ffi.new("bool*")))
        self._definition, self._state = made, state

    @property
    def height(self):
        """m. Where there is no room for the height that is set, it is an `Error`; `set_height` returns False there."""
        return self._definition.height

    @height.setter
    def height(self, height):
        with _errors_of_mover("fettle_mover_set_height"):
            has_room = self.set_height(height)
        if not has_room:
            raise Error(f"Mover: height = {height}: there is no room for it")

    on_ground = _state_property("on_ground")
    ground = _state_property("ground", _shape_or_none)
    ground_part = _state_property("ground_part")
    ground_normal = _state_property("ground_normal", lambda world, value: vec2(value))
    ground_velocity = _state_property("ground_velocity", lambda world, value: vec2(value))
    dropped = _state_property("dropped", _shape_or_none)

    @property
    def position(self):
        """Of its feet, m. Where it is set, the mover leaves the ground."""
        return vec2(self._state.position)

    @position.setter
    def position(self, position):
        self.state = MoverState(Vec2(*pair(position, "position")), Vec2(0, 0), Vec2(0, 0), None, self.dropped, False, self.climbing)

    @property
    def climbing(self):
        """Whether it moves freely, without ground, steps and rides."""
        return self._state.climbing

    @climbing.setter
    def climbing(self, climbing):
        self._state.climbing = to_number("_Bool", climbing, "climbing")

    @property
    def state(self):
        """For saving the mover; it can be set again."""
        state = self._state
        return MoverState(vec2(state.position), vec2(state.ground_normal), vec2(state.ground_velocity), self.ground,
                          self.dropped, state.on_ground, state.climbing, state.ground_part)

    @state.setter
    def state(self, state):
        if not isinstance(state, MoverState):
            raise Invalid(f"state: expected a MoverState, got {state!r}")
        made = definition("fettle_mover_state")
        for name in ("position", "ground_normal", "ground_velocity"):
            vector = getattr(made, name)
            vector.x, vector.y = pair(getattr(state, name), name)
        made.ground, made.dropped = id_of(state.ground, Shape), id_of(state.dropped, Shape)
        for name in ("on_ground", "climbing"):
            setattr(made, name, to_number("_Bool", getattr(state, name), name))
        made.ground_part = to_number("uint32_t", state.ground_part, "ground_part")
        self._check_and_set({}, made)

    def move(self, velocity, dt):
        """Moves it by velocity (m/s, relative to the ground if it stands) times dt (s), and with the ground. To be called before
        `world.step(dt)`. What happened is a `Moved`."""
        moved = ffi.new("fettle_moved*")
        x, y = pair(velocity, "velocity")
        check(lib.fettle_mover_move(self.world._pointer, self._definition, self._state, x, y, to_number("float", dt, "dt"), moved))
        values = {name: getattr(moved, name) for name in Moved._fields}
        for name in ("ground", "wall"):
            values[name] = _shape_or_none(self.world, values[name])
        for name in ("motion", "velocity", "ground_normal", "ground_velocity", "wall_normal"):
            values[name] = vec2(values[name])
        return Moved(**values)

    def drop(self):
        """Lets it fall through the ledge or the chain on which it stands; False if it stands on none."""
        dropped = ffi.new("bool*")
        check(lib.fettle_mover_drop(self.world._pointer, self._definition, self._state, dropped))
        return dropped[0]

    def fits(self, height):
        """Whether a mover of this height (m) has room at its position."""
        fits = ffi.new("bool*")
        height = to_number("float", height, "height")
        check(lib.fettle_mover_fits(self.world._pointer, self._definition, self._state, height, fits))
        return fits[0]

    def set_height(self, height):
        """Changes the height (m) if there is room for it; otherwise False."""
        changed = ffi.new("bool*")
        height = to_number("float", height, "height")
        check(lib.fettle_mover_set_height(self.world._pointer, self._definition, self._state, height, changed))
        return changed[0]

    def planes(self, distance):
        """The planes of all obstacles within a distance (m), nearest first."""
        distance = to_number("float", distance, "distance")
        found = list_of("fettle_mover_plane", lambda *a: lib.fettle_mover_planes(
            self.world._pointer, self._definition, self._state, distance, *a))
        return [MoverPlane(vec2(p.normal), vec2(p.point), p.separation, Shape(self.world, p.shape)) for p in found]

    def __reduce__(self):
        settings = {name: getattr(self, name) for name in _settings}
        return _restored, (self.world, settings, self.state)


for _name in _settings:
    if _name != "height":  # it changes only where there is room
        setattr(Mover, _name, _setting_property(_name))


def _restored(world, settings, state):
    mover = Mover(world, **settings)
    mover.state = state
    return mover


def _planes_to_c(planes):
    planes = to_list(planes, "planes")
    made = ffi.new("fettle_mover_plane[]", len(planes))
    for out, plane in zip(made, planes):
        if not isinstance(plane, MoverPlane):
            raise Invalid(f"planes: expected a MoverPlane, got {plane!r}")
        out.normal.x, out.normal.y = pair(plane.normal, "normal")
        out.separation = to_number("float", plane.separation, "separation")
    return made, len(made)


def solve_planes(motion, planes, distance=0.0):
    """For movers of the program's own: the motion nearest to a wanted one (m) after which all planes, each with `normal` and
    `separation`, are at least `distance` (m) away. If there is none, one that divides the overlap among them."""
    out = ffi.new("fettle_vec2*")
    check(lib.fettle_solve_planes(*pair(motion, "motion"), *_planes_to_c(planes), to_number("float", distance, "distance"), out))
    return vec2(out)


def clip_velocity(velocity, planes):
    """A velocity without the parts that go into the planes."""
    out = ffi.new("fettle_vec2*")
    check(lib.fettle_clip_velocity(*pair(velocity, "velocity"), *_planes_to_c(planes), out))
    return vec2(out)
