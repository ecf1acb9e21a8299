"""Joints. Their properties are those of the headers in C, with the same names."""

from ._call import check, ffi, lib
from ._handle import Handle, id_of
from ._properties import bind
from ._values import joint_types
from .body import Body, body_or_none


@bind("joint")
class Joint(Handle):
    """Between two bodies, or between one body and the world, which is None."""

    __slots__ = ()
    _made_by = "world.joint(type, ...)"

    @property
    def is_valid(self):
        return lib.fettle_joint_is_valid(self._pointer, self.id)

    def destroy(self):
        check(lib.fettle_joint_destroy(self._pointer, self.id))

    @property
    def type(self):
        """For example "revolute"."""
        number = ffi.new("int32_t*")
        check(lib.fettle_joint_type(self._pointer, self.id, number))
        return joint_types[number[0]]

    def _body(self, function):
        out = ffi.new("fettle_id*")
        check(function(self._pointer, self.id, out))
        return body_or_none(self.world, out[0])

    @property
    def body_a(self):
        return self._body(lib.fettle_joint_body_a)

    @body_a.setter
    def body_a(self, body):
        check(lib.fettle_joint_set_body_a(self._pointer, self.id, id_of(body, Body)))

    @property
    def body_b(self):
        return self._body(lib.fettle_joint_body_b)

    @body_b.setter
    def body_b(self, body):
        check(lib.fettle_joint_set_body_b(self._pointer, self.id, id_of(body, Body)))

    def connect(self, a, b):
        """Connects two bodies at the same time."""
        check(lib.fettle_joint_connect(self._pointer, self.id, id_of(a, Body), id_of(b, Body)))

    def disconnect(self):
        """Disconnects both bodies; the joint keeps its settings."""
        check(lib.fettle_joint_disconnect(self._pointer, self.id))


@bind("mouse_joint")
class MouseJoint(Joint):
    """Drags a point of a body softly towards a target."""
    __slots__ = ()

    @property
    def body(self):
        return self._body(lib.fettle_mouse_joint_body)

    @body.setter
    def body(self, body):
        check(lib.fettle_mouse_joint_set_body(self._pointer, self.id, id_of(body, Body)))


@bind("distance_joint")
class DistanceJoint(Joint):
    """A rod, a rope or a spring between two points."""
    __slots__ = ()


@bind("revolute_joint")
class RevoluteJoint(Joint):
    """Holds two points together; the bodies rotate about this point."""
    __slots__ = ()


@bind("prismatic_joint")
class PrismaticJoint(Joint):
    """Lets b slide along an axis of a without rotating."""
    __slots__ = ()


@bind("wheel_joint")
class WheelJoint(Joint):
    """A sprung wheel (b) of a vehicle (a)."""
    __slots__ = ()


@bind("weld_joint")
class WeldJoint(Joint):
    """Holds two bodies together at a point and at an angle."""
    __slots__ = ()


@bind("motor_joint")
class MotorJoint(Joint):
    """Drives b relative to a, with a limited force and torque."""
    __slots__ = ()


@bind("pulley_joint")
class PulleyJoint(Joint):
    """A rope from a over two wheels of the world to b."""
    __slots__ = ()


@bind("gear_joint")
class GearJoint(Joint):
    """Rotates b with a."""
    __slots__ = ()


@bind("groove_joint")
class GrooveJoint(Joint):
    """A pin of b in a groove of a."""
    __slots__ = ()


@bind("pin_slot_joint")
class PinSlotJoint(Joint):
    """A pin of b in a straight slot of a."""
    __slots__ = ()


@bind("ratchet_joint")
class RatchetJoint(Joint):
    """Lets b rotate relative to a in one direction only."""
    __slots__ = ()


@bind("filter_joint")
class FilterJoint(Joint):
    """The two bodies do not collide with each other; nothing else."""
    __slots__ = ()


@bind("rotary_limit_joint")
class RotaryLimitJoint(Joint):
    """Keeps the angle of b relative to a between two angles."""
    __slots__ = ()


classes = {"mouse": MouseJoint, "distance": DistanceJoint, "revolute": RevoluteJoint, "prismatic": PrismaticJoint,
           "wheel": WheelJoint, "weld": WeldJoint, "motor": MotorJoint, "pulley": PulleyJoint, "gear": GearJoint,
           "groove": GrooveJoint, "pin_slot": PinSlotJoint, "ratchet": RatchetJoint, "filter": FilterJoint,
           "rotary_limit": RotaryLimitJoint}
