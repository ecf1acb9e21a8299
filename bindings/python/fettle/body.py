"""Bodies."""

from . import geometry as geometries
from ._call import check, ffi, lib, list_of
from ._handle import Handle
from ._properties import bind, to_number, to_pose, to_text
from ._values import Pose, body_types, number_of, pair, vec2
from .shape import Shape, contact_of


@bind("body")
class Body(Handle):
    """A rigid body. Its properties are those of fettle/physics_c/body.h, with the same names."""

    __slots__ = ()
    _made_by = "world.body(...)"

    @property
    def is_valid(self):
        return lib.fettle_body_is_valid(self._pointer, self.id)

    def destroy(self):
        """Destroys the body with its shapes and the joints on it."""
        check(lib.fettle_body_destroy(self._pointer, self.id))

    @property
    def type(self):
        """"static", "kinematic" or "dynamic"."""
        number = ffi.new("int32_t*")
        check(lib.fettle_body_type(self._pointer, self.id, number))
        return body_types[number[0]]

    @type.setter
    def type(self, name):
        check(lib.fettle_body_set_type(self._pointer, self.id, number_of(body_types, name, "type")))

    @property
    def pose(self):
        return Pose(self.position, self.angle)

    @pose.setter
    def pose(self, pose):
        check(lib.fettle_body_set_pose(self._pointer, self.id, *to_pose(pose, "pose")))

    def _override(self, name, value):
        given = ffi.NULL if value is None else ffi.new("float*", to_number("float", value, name))
        check(getattr(lib, f"fettle_body_set_{name}")(self._pointer, self.id, given))

    def _number(self, name):
        out = ffi.new("float*")
        check(getattr(lib, f"fettle_body_{name}")(self._pointer, self.id, out))
        return out[0]

    @property
    def mass(self):
        """kg; infinity: does not move. None: from the shapes."""
        return self._number("mass")

    @mass.setter
    def mass(self, mass):
        self._override("mass", mass)

    @property
    def inertia(self):
        """kg m2 about the center of mass; infinity: does not rotate. None: from the shapes."""
        return self._number("inertia")

    @inertia.setter
    def inertia(self, inertia):
        self._override("inertia", inertia)

    @property
    def center(self):
        """Center of mass in body coordinates. None: from the shapes."""
        out = ffi.new("fettle_vec2*")
        check(lib.fettle_body_center(self._pointer, self.id, out))
        return vec2(out)

    @center.setter
    def center(self, center):
        given = ffi.NULL if center is None else ffi.new("fettle_vec2*", pair(center, "center"))
        check(lib.fettle_body_set_center(self._pointer, self.id, given))

    @property
    def sleep_speed(self):
        """m/s; the body rests below it. None: that of the world."""
        return self._number("sleep_speed")

    @sleep_speed.setter
    def sleep_speed(self, speed):
        self._override("sleep_speed", speed)

    def _overridden(self, name, ctype):
        is_set, value = ffi.new("bool*"), ffi.new(ctype + "*")
        check(getattr(lib, f"fettle_body_{name}_override")(self._pointer, self.id, is_set, value))
        if not is_set[0]:
            return None
        return vec2(value) if ctype == "fettle_vec2" else value[0]

    @property
    def mass_override(self):
        """kg, or None if the mass comes from the shapes."""
        return self._overridden("mass", "float")

    @property
    def inertia_override(self):
        """kg m2, or None if the inertia comes from the shapes."""
        return self._overridden("inertia", "float")

    @property
    def center_override(self):
        """Body coordinates, or None if the center of mass comes from the shapes."""
        return self._overridden("center", "fettle_vec2")

    @property
    def sleep_speed_override(self):
        """m/s, or None if it has that of the world."""
        return self._overridden("sleep_speed", "float")

    @property
    def name(self):
        """For messages and tools, at most 63 bytes."""
        out = ffi.new("char const**")
        check(lib.fettle_body_name(self._pointer, self.id, out))
        return ffi.string(out[0]).decode(errors="replace")

    @name.setter
    def name(self, name):
        check(lib.fettle_body_set_name(self._pointer, self.id, to_text(name, "name")))

    def set_target(self, pose, dt):
        """Sets both velocities so that steps of `dt` seconds in all bring the body to a pose: (position, angle)."""
        check(lib.fettle_body_set_target(self._pointer, self.id, *to_pose(pose, "pose"), to_number("float", dt, "dt")))

    def set_velocity_function(self, function):
        """`function(edit)` may set `velocity` and `angular_velocity` in every step, before contacts and joints act. None: none."""
        self.world._set_body_function(lib.fettle_body_set_velocity_function, "velocity", self, function)

    def set_position_function(self, function):
        """`function(edit)` may set `pose` at the end of every step. None: none."""
        self.world._set_body_function(lib.fettle_body_set_position_function, "position", self, function)

    def _apply(self, name, vector, at):
        x, y = pair(vector, name)
        if at is None:
            check(getattr(lib, f"fettle_body_apply_{name}")(self._pointer, self.id, x, y))
        else:
            check(getattr(lib, f"fettle_body_apply_{name}_at")(self._pointer, self.id, x, y, *pair(at, "at")))

    def apply_force(self, force, at=None):
        """N, for the next step only, at the center of mass or at a point of the world."""
        self._apply("force", force, at)

    def apply_impulse(self, impulse, at=None):
        """N s, at once, at the center of mass or at a point of the world."""
        self._apply("impulse", impulse, at)

    def apply_torque(self, torque):
        """N m, for the next step only."""
        check(lib.fettle_body_apply_torque(self._pointer, self.id, to_number("float", torque, "torque")))

    def apply_angular_impulse(self, impulse):
        """N m s, at once."""
        check(lib.fettle_body_apply_angular_impulse(self._pointer, self.id, to_number("float", impulse, "impulse")))

    def interpolated(self, fraction):
        """Pose at a fraction of the last step: 0 before it, 1 after it."""
        out = ffi.new("fettle_pose*")
        check(lib.fettle_body_interpolated(self._pointer, self.id, to_number("float", fraction, "fraction"), out))
        return Pose(vec2(out.position), out.angle)

    def _mapped(self, name, vector):
        out = ffi.new("fettle_vec2*")
        check(getattr(lib, "fettle_body_" + name)(self._pointer, self.id, *pair(vector, name), out))
        return vec2(out)

    def world_point(self, local):
        return self._mapped("world_point", local)

    def local_point(self, world):
        return self._mapped("local_point", world)

    def world_vector(self, local):
        return self._mapped("world_vector", local)

    def local_vector(self, world):
        return self._mapped("local_vector", world)

    def velocity_at(self, world_point):
        """m/s, of the point of the body that is at a point of the world."""
        return self._mapped("velocity_at", world_point)

    def add(self, geometry, **properties):
        """Attaches a new shape: `body.add(fettle.Circle(0.5), friction=0.3, sensor=True)`."""
        given, kept = geometries.to_c(geometry)
        made = ffi.new("fettle_id*")
        shape_def = Shape._definition(properties)
        check(lib.fettle_body_add(self._pointer, self.id, given, shape_def, made))
        return Shape(self.world, made[0])

    @property
    def shapes(self):
        """Its shapes in the order in which they were attached."""
        ids = list_of("fettle_id", lambda *a: lib.fettle_body_shapes(self._pointer, self.id, *a))
        return [Shape(self.world, i) for i in ids]

    @property
    def joints(self):
        """The joints on it."""
        ids = list_of("fettle_id", lambda *a: lib.fettle_body_joints(self._pointer, self.id, *a))
        return [self.world._joint(i) for i in ids]

    @property
    def contacts(self):
        """Touching contacts of the last step."""
        found = list_of("fettle_contact", lambda *a: lib.fettle_body_contacts(self._pointer, self.id, *a))
        return [contact_of(self.world, c) for c in found]


def body_or_none(world, id):
    return Body(world, id) if id else None

