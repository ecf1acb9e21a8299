"""Rigid bodies in the plane: Fettle's physics library.

    import fettle

    world = fettle.World()
    world.body("static", position=(0, -1)).add(fettle.Box(40, 2))
    ball = world.body(position=(0, 5))
    ball.add(fettle.Circle(0.5), restitution=0.8)
    for _ in range(60):
        world.step(1 / 60)
    print(ball.position.y)

Units are SI, angles are in radians, counter-clockwise. A call that is refused raises `Error` with a message that names the
value and what was expected, and has changed nothing.
"""

from ._call import Error, Invalid, Locked, Stale, version
from ._values import Aabb, Pose, Vec2
from .body import Body
from .fields import Attractor, Buoyancy, Drag, Field, Wind
from .geometry import Box, Chain, Circle, Concave, Ellipse, Polygon, Segment, convex_hull
from .joints import (DistanceJoint, FilterJoint, GearJoint, GrooveJoint, Joint, MotorJoint, MouseJoint, PinSlotJoint,
                     PrismaticJoint, PulleyJoint, RatchetJoint, RevoluteJoint, RotaryLimitJoint, WeldJoint, WheelJoint)
from .mover import Moved, Mover, MoverPlane, MoverState
from .shape import Shape
from .vector_world import VectorWorld
from .world import World

__all__ = ["Aabb", "Attractor", "Body", "Box", "Buoyancy", "Chain", "Circle", "Concave", "DistanceJoint", "Drag", "Ellipse",
           "Error", "Field", "FilterJoint", "GearJoint", "GrooveJoint", "Invalid", "Joint", "Locked", "MotorJoint", "MouseJoint",
           "Moved", "Mover", "MoverPlane", "MoverState",
           "PinSlotJoint", "Polygon", "Pose", "PrismaticJoint", "PulleyJoint", "RatchetJoint", "RevoluteJoint",
           "RotaryLimitJoint", "Segment", "Shape", "Stale", "Vec2", "VectorWorld", "WeldJoint", "WheelJoint", "Wind", "World", "convex_hull", "version"]
