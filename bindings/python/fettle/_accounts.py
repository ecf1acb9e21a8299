"""Accounts: what changed the velocity of a body in the last step."""

from typing import NamedTuple

from ._call import check, ffi, lib, list_of
from ._handle import id_of
from ._values import Vec2, vec2
from .body import Body
from .shape import Shape


class ContactShare(NamedTuple):
    """The part of a contact of two shapes in the change of a velocity."""
    own: Shape
    other: Shape
    body: Body  # of `other`
    impulse: Vec2  # N s, on the body of `own`
    change: Vec2  # m/s
    twist: float  # N m s
    turn: float  # rad/s


class JointShare(NamedTuple):
    """The part of a joint in the change of a velocity."""
    joint: object
    impulse: Vec2  # N s, on the body
    change: Vec2  # m/s
    twist: float  # N m s
    turn: float  # rad/s


class TurnAccount(NamedTuple):
    """The changes of the angular velocity, rad/s, besides those by contacts and joints."""
    earlier: float  # at the end of the step before
    before: float  # at the start of the step
    after: float  # at its end
    torque: float
    applied: float
    fields: float
    damping: float
    rest: float  # other changes
    size: float  # the sum of the sizes of all changes


class VelocityAccount(NamedTuple):
    """The changes of a velocity, m/s: `after` minus `before` is the sum of what follows."""
    earlier: Vec2  # at the end of the step before
    before: Vec2  # at the start of the step
    after: Vec2  # at its end
    gravity: Vec2
    force: Vec2
    applied: Vec2
    fields: Vec2
    damping: Vec2
    rest: Vec2  # other changes
    turn: TurnAccount  # of the angular velocity
    contacts: list
    joints: list


def _values(cls, struct):
    return [getattr(struct, name) for name in cls._fields if hasattr(struct, name)]


def account_of(world, body):
    id, is_set, account = id_of(body, Body), ffi.new("bool*"), ffi.new("fettle_velocity_account*")
    check(lib.fettle_world_account(world._pointer, id, is_set, account))
    if not is_set[0]:
        return None
    *vectors, turn = _values(VelocityAccount, account)
    contacts = list_of("fettle_contact_share", lambda *a: lib.fettle_world_account_contacts(world._pointer, id, *a))
    joints = list_of("fettle_joint_share", lambda *a: lib.fettle_world_account_joints(world._pointer, id, *a))
    return VelocityAccount(
        *map(vec2, vectors), TurnAccount(*_values(TurnAccount, turn)),
        [ContactShare(Shape(world, c.own), Shape(world, c.other), Body(world, c.body), vec2(c.impulse), vec2(c.change), c.twist, c.turn)
         for c in contacts],
        [JointShare(world._joint(j.joint), vec2(j.impulse), vec2(j.change), j.twist, j.turn) for j in joints])
