"""Events of a step."""

from typing import NamedTuple

from ._call import check, ffi, lib
from ._values import Vec2, vec2
from .body import Body, body_or_none
from .joints import Joint
from .shape import Shape


class ContactEvent(NamedTuple):
    """A touch that begins or continues, or an impact; the normal points from a to b."""
    shape_a: Shape
    shape_b: Shape
    body_a: Body
    body_b: Body
    point: Vec2
    normal: Vec2
    speed: float  # m/s, of approach
    impulse: float  # N s
    friction: float
    restitution: float
    part_a: int  # segment of a chain or piece of a concave polygon, from 0
    part_b: int
    material_a: int  # of the shapes, or of the segments of chains
    material_b: int


class ContactEndEvent(NamedTuple):
    shape_a: Shape
    shape_b: Shape
    body_a: Body
    body_b: Body


class SensorEvent(NamedTuple):
    sensor: Shape
    visitor: Shape
    sensor_body: Body
    visitor_body: Body


class JointBreakEvent(NamedTuple):
    joint: Joint
    body_a: Body
    body_b: Body
    force: Vec2
    torque: float


class JointLoadEvent(NamedTuple):
    joint: Joint
    body_a: Body
    body_b: Body
    force: Vec2
    torque: float


class Events(NamedTuple):
    """Lists. Objects in them may be destroyed: they can still be compared."""
    contact_begin: list
    contact_persist: list
    contact_end: list
    contact_hit: list
    sensor_begin: list
    sensor_end: list
    joint_broke: list
    joint_loaded: list
    slept: list
    woke: list


def events_of(world):
    events = ffi.new("fettle_events*")
    check(lib.fettle_world_events(world._pointer, events))

    def all(name, make):
        array = getattr(events, name)
        return [make(array[i]) for i in range(getattr(events, name + "_count"))]

    def shapes_and_bodies(e):
        return Shape(world, e.shape_a), Shape(world, e.shape_b), Body(world, e.body_a), Body(world, e.body_b)

    def contact(e):
        return ContactEvent(*shapes_and_bodies(e), vec2(e.point), vec2(e.normal), e.speed, e.impulse, e.friction, e.restitution,
                            e.part_a, e.part_b, e.material_a, e.material_b)

    def end(e):
        return ContactEndEvent(*shapes_and_bodies(e))

    def sensor(e):
        return SensorEvent(Shape(world, e.sensor), Shape(world, e.visitor), Body(world, e.sensor_body),
                           Body(world, e.visitor_body))

    def broke(e):
        return JointBreakEvent(Joint(world, e.joint), body_or_none(world, e.body_a), body_or_none(world, e.body_b),
                               vec2(e.force), e.torque)

    def loaded(e):
        return JointLoadEvent(Joint(world, e.joint), body_or_none(world, e.body_a), body_or_none(world, e.body_b),
                              vec2(e.force), e.torque)

    def body(id):
        return Body(world, id)

    return Events(all("contact_begin", contact), all("contact_persist", contact), all("contact_end", end),
                  all("contact_hit", contact), all("sensor_begin", sensor), all("sensor_end", sensor),
                  all("joint_broke", broke), all("joint_loaded", loaded), all("slept", body), all("woke", body))
