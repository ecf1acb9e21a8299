"""The package has what the interface in C has."""

import pathlib
import re
import unittest

import fettle
from fettle import _properties
from fettle._call import ffi, lib

# Functions of which the package says only a part of the name, and where.
spelled = {
    '"_init"': [name for name in dir(lib) if name.endswith("_init")],
    'f"fettle_world_create_{type}_joint"': [f"fettle_world_create_{type}_joint" for type in fettle.joints.classes],
    'f"fettle_world_{name}"': ["fettle_world_friction_mix", "fettle_world_restitution_mix", "fettle_world_solver"],
    'f"fettle_world_set_{name}"': ["fettle_world_set_friction_mix", "fettle_world_set_restitution_mix", "fettle_world_set_solver"],
    '"fettle_world_" + name': ["fettle_world_set_filter", "fettle_world_set_mixing", "fettle_world_set_before_solve"],
    'f"fettle_body_{name}"': ["fettle_body_mass", "fettle_body_inertia", "fettle_body_sleep_speed"],
    'f"fettle_body_set_{name}"': ["fettle_body_set_mass", "fettle_body_set_inertia", "fettle_body_set_sleep_speed"],
    'f"fettle_body_{name}_override"': [f"fettle_body_{name}_override" for name in ("mass", "inertia", "center", "sleep_speed")],
    'f"fettle_body_apply_{name}"': ["fettle_body_apply_force", "fettle_body_apply_impulse"],
    'f"fettle_body_apply_{name}_at"': ["fettle_body_apply_force_at", "fettle_body_apply_impulse_at"],
    '"fettle_body_" + name': ["fettle_body_world_point", "fettle_body_local_point", "fettle_body_world_vector",
                              "fettle_body_local_vector", "fettle_body_velocity_at"],
}

# Functions that a program in Python has no use for, and why.
left_out = {
    r"fettle_owner_\w+|fettle_world_set_owner": "for engines that keep data for every object of a world",
    r"fettle_world_(on_)?refresh": "for hosts that read the memory of a world while it is edited",
    r"fettle_world_(state|previous|mass|velocity)": "the arrays have them, and so have bodies",
    r"fettle_world_(write|write_velocity|set_velocity)": "saves a host less than a call from Python costs",
    r"fettle_world_set_scheduler": "threads of Python take turns; `World.threads` and `VectorWorld` use others",
    r"fettle_slot": "`slot` of an object",
}


class Coverage(unittest.TestCase):
    def test_each_function_in_c_is_called_or_left_out_for_a_reason(self):
        folder = pathlib.Path(fettle.__file__).parent
        text = "\n".join(file.read_text() for file in folder.glob("*.py") if file.name != "_interface.py")
        covered = set(re.findall(r"\blib\.(fettle_\w+)", text)) | _properties.bound
        for part, names in spelled.items():
            self.assertIn(part, text)
            covered.update(names)
        declared = {name for name in dir(lib) if name.startswith("fettle_")}
        self.assertGreater(len(declared), 500)
        self.assertEqual(covered - declared, set())
        missing = declared - covered
        unexplained = sorted(name for name in missing if not any(re.fullmatch(pattern, name) for pattern in left_out))
        self.assertEqual(unexplained, [])
        for pattern in left_out:
            self.assertTrue(any(re.fullmatch(pattern, name) for name in missing), f"{pattern} is not missing")

    def test_what_a_call_gives_has_all_members_in_c(self):
        from fettle import _events, _queries, shape
        for cls, structure, others in (
                (_events.ContactEvent, "contact_event", ()), (_events.ContactEndEvent, "contact_end_event", ()),
                (_events.SensorEvent, "sensor_event", ()), (_events.JointBreakEvent, "joint_break_event", ()),
                (_events.JointLoadEvent, "joint_load_event", ()), (shape.Contact, "contact", {"point_count"}),
                (shape.ContactPoint, "contact_point", ()), (fettle.SegmentSurface, "segment_surface", ()),
                (_queries.RayHit, "ray_hit", ()), (_queries.PointHit, "point_hit", ()),
                (fettle.Moved, "moved", ()), (fettle.MoverState, "mover_state", {"size"}),
                (fettle.MoverPlane, "mover_plane", ()), (fettle.ContactShare, "contact_share", ()),
                (fettle.JointShare, "joint_share", ()), (fettle.TurnAccount, "turn_account", ()),
                (fettle.VelocityAccount, "velocity_account", ()), (fettle.ReplayedStep, "replayed_step", {"has_recorded_hash"})):
            with self.subTest(structure=structure):
                in_c = {name for name, _ in ffi.typeof("fettle_" + structure).fields}
                self.assertEqual(in_c - set(cls._fields), set(others))

    def test_every_property_can_be_read_and_set_to_what_it_is(self):
        world = fettle.World()
        a, b = world.body(), world.body(position=(3, 0))
        shapes = [a.add(geometry) for geometry in (
            fettle.Circle(), fettle.Box(), fettle.Segment(), fettle.Polygon([(0, 0), (1, 0), (0, 1)]), fettle.Ellipse(),
            fettle.Concave([(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2)]), fettle.Chain([(0, 0), (1, 0), (2, 1)]))]
        joints = [world.dormant_joint(type) for type in fettle.joints.classes]
        world.field(fettle.Wind(velocity=(1, 0)))
        read = written = 0
        for thing in [world, a, *shapes, *joints, *world.fields]:
            for name in dir(type(thing)):
                known = getattr(type(thing), name)
                if not isinstance(known, property):
                    continue
                try:
                    value = getattr(thing, name)
                except fettle.Error as error:  # a radius of a box
                    self.assertIsInstance(error, fettle.Invalid)
                    continue
                read += 1
                if known.fset is not None:
                    with self.subTest(thing=type(thing).__name__, name=name):
                        try:
                            setattr(thing, name, value)
                        except fettle.Error as error:  # vertices of a circle, the body of a mouse joint that has none
                            self.assertRegex(str(error), "expected|no such property|a mouse joint")
                            continue
                        written += 1
                        # A pose is kept as numbers that may differ in the last digit.
                        if isinstance(value, (bool, int, str)):
                            self.assertEqual(getattr(thing, name), value)
        self.assertGreater(read, 400)
        self.assertGreater(written, 250)


if __name__ == "__main__":
    unittest.main()
