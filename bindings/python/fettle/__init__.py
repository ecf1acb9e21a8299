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

from ._accounts import ContactShare, JointShare, TurnAccount, VelocityAccount
from ._call import Error, Invalid, Locked, Stale, version
from ._values import Aabb, Pose, Vec2
from .body import Body
from .fields import Attractor, Buoyancy, Drag, Field, Wind
from .geometry import Box, Chain, Circle, Concave, Ellipse, Geometry, Movement, Polygon, Segment, convex_hull
from .hooks import set_failure_function, set_log, simd_width
from .joints import (DistanceJoint, FilterJoint, GearJoint, GrooveJoint, Joint, MotorJoint, MouseJoint, PinSlotJoint,
                     PrismaticJoint, PulleyJoint, RatchetJoint, RevoluteJoint, RotaryLimitJoint, WeldJoint, WheelJoint)
from .mover import Moved, Mover, MoverPlane, MoverState, clip_velocity, solve_planes
from .outlines import Line, grid_outlines, join_lines, without_straight_points
from .recording import Replay, ReplayedStep
from .shape import SegmentSurface, Shape
from .vector_world import VectorWorld
from .world import World

__all__ = ["Aabb", "Attractor", "Body", "Box", "Buoyancy", "Chain", "Circle", "clip_velocity", "Concave",
           "ContactShare", "convex_hull", "DistanceJoint", "Drag", "Ellipse", "Error", "Field", "FilterJoint",
           "GearJoint", "Geometry", "grid_outlines", "GrooveJoint", "Invalid", "join_lines", "Joint", "JointShare",
           "Line", "Locked", "MotorJoint", "MouseJoint", "Moved", "Movement", "Mover", "MoverPlane", "MoverState",
           "PinSlotJoint", "Polygon", "Pose", "PrismaticJoint", "PulleyJoint", "RatchetJoint", "Replay",
           "ReplayedStep", "RevoluteJoint", "RotaryLimitJoint", "Segment", "SegmentSurface", "set_failure_function",
           "set_log", "Shape", "simd_width", "solve_planes", "Stale", "TurnAccount", "Vec2", "VectorWorld",
           "VelocityAccount", "version", "WeldJoint", "WheelJoint", "Wind", "without_straight_points", "World"]
