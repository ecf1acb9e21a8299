"""Functions of the program that a world calls, recordings, surfaces of segments, and functions without a world."""

import copy
import gc
import math
import pickle
import threading
import unittest

import numpy

import fettle


def a_world():
    world = fettle.World(gravity=(0, -10))
    ground = world.body("static", position=(0, -0.5))
    ground.add(fettle.Box(40, 1))
    ball = world.body(position=(0, 2))
    ball.add(fettle.Circle(0.5))
    return world, ground, ball


def run(world, steps):
    for _ in range(steps):
        world.step(1 / 60)


class Functions(unittest.TestCase):
    def test_complex_numbers_and_text_are_no_numbers(self):
        world, _, ball = a_world()
        env = fettle.VectorWorld(lambda made: [made.body()], count=2)
        for bad in (numpy.array([1, 2j]), numpy.array([1, 2], dtype=numpy.complex64), ("1", "2"), [1j, 2]):
            for act in (lambda: setattr(ball, "position", bad), lambda: setattr(ball, "mass", bad[0]),
                        lambda: setattr(world, "substeps", bad[0]), lambda: setattr(ball, "user_data", bad[0]),
                        lambda: ball.add(fettle.Polygon([bad] * 3)), lambda: fettle.grid_outlines([bad, bad]),
                        lambda: env.step([[bad], [bad]])):
                with self.assertRaises(fettle.Invalid):
                    act()
        ball.user_data = 2**64 - 1
        self.assertEqual(ball.user_data, 2**64 - 1)

    def test_a_velocity_function_replaces_gravity(self):
        world, _, ball = a_world()
        seen = []

        def rise(edit):
            seen.append((edit.body, edit.dt, edit.before.y))
            edit.velocity = (0, 1)

        ball.set_velocity_function(rise)
        gc.collect()
        run(world, 60)
        self.assertAlmostEqual(ball.position.y, 3, delta=0.05)
        self.assertEqual((seen[0][0], len(seen)), (ball, 60))
        ball.set_velocity_function(None)
        run(world, 60)
        self.assertLess(ball.position.y, 1)

    def test_a_position_function_holds_a_body_on_a_line(self):
        world, _, ball = a_world()

        def hold(edit):
            edit.pose = ((1, edit.pose.position.y), 0.25)

        ball.set_position_function(hold)
        run(world, 20)
        self.assertAlmostEqual(ball.position.x, 1, delta=1e-4)
        self.assertAlmostEqual(ball.angle, 0.25, delta=1e-4)

    def test_limits_that_cross_are_refused(self):
        world = fettle.World()
        body = world.body()
        with self.assertRaisesRegex(fettle.Invalid, "lower_angle = 2: expected at most upper_angle, which is 1"):
            world.joint("revolute", None, body, lower_angle=2, upper_angle=1)
        self.assertEqual(world.joints, [])

    def test_a_function_that_raises_while_it_is_set_is_kept(self):
        # It was freed although C had it, and the next function took its place in memory.
        world, others = fettle.World(gravity=(0, 0)), []
        for _ in range(2):
            world.body().add(fettle.Circle(1))
        world.step(1 / 60)

        def refuse():
            raise KeyError("no")

        with self.assertRaises(KeyError):
            world.set_filter(lambda shape_a, shape_b: refuse())
        gc.collect()
        called = []
        for _ in range(50):
            other = fettle.World()
            other.body().set_velocity_function(called.append)
            others.append(other)
        world.body().add(fettle.Circle(1))
        with self.assertRaises(KeyError):
            world.step(1 / 60)
        self.assertEqual(called, [])

    def test_what_is_no_function_is_refused_when_it_is_given(self):
        world, _, ball = a_world()
        for give in (world.set_filter, world.set_mixing, world.set_before_solve, ball.set_velocity_function,
                     ball.set_position_function, world.after_step, world.start_recording, fettle.set_log,
                     fettle.set_failure_function):
            with self.assertRaisesRegex(fettle.Invalid, "expected a function, got 5"):
                give(5)
        world.step(1 / 60)

    def test_an_edit_is_valid_during_its_call_and_refuses_other_members(self):
        world, _, ball = a_world()
        kept, errors = [], []

        def keep(contact):
            kept.append(contact)
            for name, value in (("point", (0, 0)), ("friction", "much"), ("color", 1)):
                try:
                    setattr(contact, name, value)
                except (AttributeError, fettle.Invalid) as error:
                    errors.append(str(error))

        world.set_before_solve(keep)
        run(world, 60)
        self.assertIn("point of a ContactEdit cannot be set; there are friction, ", errors[0])
        self.assertIn("friction = 'much': expected a number", errors[1])
        with self.assertRaises(fettle.Stale):
            kept[0].friction
        with self.assertRaises(fettle.Stale):
            kept[0].friction = 1

    def test_another_thread_is_refused_during_a_call(self):
        world, _, ball = a_world()
        other, errors = fettle.World(), []

        def elsewhere(function):
            def act():
                try:
                    function()
                except fettle.Error as error:
                    errors.append(error)

            thread = threading.Thread(target=act)
            thread.start()
            thread.join()

        def inside(edit):
            elsewhere(lambda: world.step(1))
            elsewhere(lambda: ball.velocity)
            elsewhere(lambda: other.take(world))
            elsewhere(lambda: other.step(1))
            self.assertEqual(ball.position.x, 0)

        ball.set_velocity_function(inside)
        world.step(1 / 60)
        self.assertEqual([type(error) for error in errors], [fettle.Locked] * 3)
        self.assertRegex(str(errors[1]), "fettle_body_velocity: another thread is in a call with this world")
        ball.set_velocity_function(None)
        elsewhere(lambda: world.step(1 / 60))
        self.assertEqual(len(errors), 3)

    def test_threads_that_race_leave_a_whole_world(self):
        world, ground, ball = a_world()

        def act():
            for i in range(300):
                try:
                    world.body(position=(0, 3)).add(fettle.Circle(0.1))
                    world.step(1 / 60)
                    world.bodies[-1].destroy()
                except fettle.Error:
                    pass

        threads = [threading.Thread(target=act) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertIsNone(world.fault)

    def test_a_closed_world_is_not_the_one_that_has_its_memory(self):
        closed = fettle.World()
        ball = closed.body()
        closed.close()
        worlds = []
        for _ in range(1500):  # the library keeps the memory of a thousand
            worlds.append(fettle.World())
            fettle.World().close()
        with self.assertRaises(fettle.Stale):
            closed.step(1)
        self.assertFalse(ball.is_valid)
        closed.close()
        del closed, ball
        gc.collect()
        for world in worlds:
            world.step(1)

    def test_callbacks_may_run_on_several_threads(self):
        world, ground, ball = a_world()
        world.threads, world.parallel_callbacks = 2, True
        for i in range(100):
            world.body(position=(i * 0.3 - 5, 2)).add(fettle.Circle(0.1))
        calls = []
        world.set_before_solve(lambda contact: calls.append(contact.shape_b.body))
        run(world, 60)
        self.assertGreater(len(calls), 100)

        def fail(contact):
            raise KeyError(contact.friction)

        world.set_before_solve(fail)
        with self.assertRaises(KeyError):
            world.step(1 / 60)

    def test_a_contact_has_a_number_until_the_shapes_separate(self):
        world, ground, ball = a_world()
        pair = ground.shapes[0], ball.shapes[0]
        with self.assertRaisesRegex(fettle.Invalid, "do not touch"):
            world.set_contact_data(*pair, 1)
        run(world, 60)
        world.set_contact_data(*pair, 2**63)
        self.assertEqual(world.contact_data(*reversed(pair)), 2**63)
        with self.assertRaisesRegex(fettle.Invalid, "number"):
            world.set_contact_data(*pair, -1)
        ball.position = (0, 3)
        run(world, 2)
        self.assertEqual(world.contact_data(*pair), 0)

    def test_a_contact_can_be_ignored_until_the_shapes_have_separated(self):
        world, ground, ball = a_world()
        run(world, 60)
        pair = ground.shapes[0], ball.shapes[0]
        self.assertTrue(world.is_touching(*pair))
        self.assertEqual(len(world.contacts_of(*pair)), 1)
        world.ignore_until_separated(*pair)
        run(world, 10)
        self.assertLess(ball.position.y, 0.4)
        self.assertFalse(world.is_touching(*pair))
        ball.position = (0, 3)
        run(world, 1)

        def ignore(contact):
            contact.ignored = True

        world.set_before_solve(ignore)
        run(world, 60)
        self.assertLess(ball.position.y, 0)

    def test_functions_for_the_end_of_a_step_run_once_and_in_order(self):
        world, _, ball = a_world()
        order = []
        world.after_step(lambda: order.append("first"))
        world.after_step(lambda: order.append(world.body().slot))

        def burst(contact):
            with self.assertRaises(fettle.Locked):
                ball.destroy()
            if ball.is_valid and "burst" not in order:
                order.append("burst")
                world.after_step(ball.destroy)

        world.set_before_solve(burst)
        run(world, 60)
        self.assertEqual(order[0], "first")
        self.assertEqual(order[2:], ["burst"])
        self.assertFalse(ball.is_valid)

    def test_what_such_a_function_raises_comes_out_of_the_step(self):
        world, _, ball = a_world()

        def fail(*_):
            raise KeyError("mine")

        world.after_step(fail)
        with self.assertRaisesRegex(KeyError, "mine"):
            world.step(1 / 60)
        world.step(1 / 60)
        ball.set_velocity_function(fail)
        with self.assertRaisesRegex(KeyError, "mine"):
            world.step(1 / 60)

    def test_visitors_end_when_they_return_false(self):
        world, ground, ball = a_world()
        for x in range(5):
            world.body("static", position=(x, 5)).add(fettle.Box())
        shape = ground.shapes[0]
        visits = [
            lambda see: world.visit_aabb(((-9, 4.9), (9, 5.1)), see),
            lambda see: world.visit_ray((-9, 5), (9, 5), see),
            lambda see: world.visit_overlap(fettle.Box(20, 0.2), see, ((0, 5), 0)),
        ]
        for visit in visits:
            found = []
            visit(found.append)
            self.assertEqual(len(found), 5)
            first = []
            visit(lambda each: first.append(each) or False)
            self.assertEqual(len(first), 1)
            with self.assertRaises(ZeroDivisionError):
                visit(lambda each: 1 / 0)
        found = []
        world.visit_point((0, -0.5), found.append)
        world.visit_point((0, -0.5), found.append, category=0)
        self.assertEqual(found, [shape])
        world.body(position=(0, -0.5)).add(fettle.Box())
        found = []
        world.visit_overlap(shape, found.append)
        self.assertEqual(len(found), 1)

    def test_a_recording_is_repeated_with_the_edits_and_answers_of_functions(self):
        world, _, ball = a_world()
        recording = bytearray()
        world.set_before_solve(lambda contact: setattr(contact, "restitution", 0.5))
        world.start_recording(recording.extend)
        with self.assertRaises(fettle.Invalid):
            world.start_recording(print)
        gc.collect()
        run(world, 40)
        ball.velocity = (3, 1)
        run(world, 40)
        self.assertTrue(world.is_recorded)
        world.stop_recording()
        self.assertFalse(world.is_recorded)
        replay = fettle.Replay(recording)
        self.assertEqual(replay.steps, 80)
        steps = list(replay)
        self.assertEqual([step.number for step in steps], list(range(80)))
        self.assertTrue(all(step.same and step.recorded_hash == step.hash for step in steps))
        self.assertIn("set_velocity", steps[40].calls)
        self.assertEqual(replay.world.hash, world.hash)
        self.assertIsNone(replay.step())
        recording[len(recording) // 2] ^= 1
        with self.assertRaises(fettle.Invalid):
            fettle.Replay(recording)

    def test_a_function_that_raises_ends_the_recording_that_it_writes(self):
        world, _, ball = a_world()
        parts, room = [], 0

        def write(part):
            if len(parts) >= room:
                raise OSError("the disk is full")
            parts.append(part)

        with self.assertRaisesRegex(OSError, "full"):
            world.start_recording(write)
        self.assertFalse(world.is_recorded)
        room = 6
        world.start_recording(write)
        with self.assertRaisesRegex(OSError, "full"):
            run(world, 10)
        self.assertFalse(world.is_recorded)
        room = 100
        run(world, 10)
        self.assertEqual(len(parts), 6)
        replay = fettle.Replay(b"".join(parts))
        self.assertEqual([step.same for step in replay], [True] * replay.steps)
        self.assertEqual(replay.steps, 3)

    def test_a_replay_belongs_to_one_thread_and_is_not_copied(self):
        world, _, ball = a_world()
        recording = bytearray()
        world.start_recording(recording.extend)
        run(world, 200)
        replay, refused = fettle.Replay(recording), []
        for how in (copy.copy, copy.deepcopy, pickle.dumps):
            with self.assertRaisesRegex(TypeError, "a Replay cannot be copied"):
                how(replay)
        replay.step()
        replay.__init__(recording)
        self.assertEqual(replay.step().number, 0)

        def act():
            try:
                list(replay)
            except fettle.Locked as error:
                refused.append(str(error))

        threads = [threading.Thread(target=act) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(all("Replay, which belongs to one thread" in text for text in refused))
        self.assertIsNone(replay.step())
        with self.assertRaisesRegex(fettle.Invalid, "bytes in one piece"):
            fettle.Replay(numpy.zeros(200, numpy.uint8)[::2])

    def test_an_edit_can_be_asked_for_names_of_python(self):
        world, _, ball = a_world()
        kept = []
        world.set_before_solve(kept.append)
        run(world, 60)
        self.assertFalse(hasattr(kept[0], "__array__"))
        self.assertIn("settable", dir(kept[0]))
        with self.assertRaises(AttributeError):
            copy.copy(kept[0])

    def test_visitors_that_are_no_functions_are_refused(self):
        world, _, ball = a_world()
        for visitor in (None, 3):
            with self.assertRaisesRegex(fettle.Invalid, "function: expected a function"):
                world.visit_point((0, 2), visitor)
            with self.assertRaisesRegex(fettle.Invalid, "function: expected a function"):
                world.visit_ray((0, 9), (0, -9), visitor)
        with self.assertRaisesRegex(fettle.Invalid, "accept: expected a function"):
            world.cast_ray((0, 9), (0, -9), accept=3)
        self.assertEqual(world.cast_ray((0, 9), (0, -9), accept=None).shape.body, ball)

    def test_a_world_is_drawn_by_the_methods_that_a_target_has(self):
        class Picture:
            def __init__(self):
                self.drawn = []

            def polygon(self, points, closed, color):
                self.drawn.append(("polygon", len(points), closed))

            def circle(self, center, radius, angle, color):
                self.drawn.append(("circle", center.x, radius))

        world, _, _ = a_world()
        picture = Picture()
        world.draw(picture)
        self.assertIn(("polygon", 4, True), picture.drawn)
        self.assertIn(("circle", 0.0, 0.5), picture.drawn)
        picture.drawn.clear()
        world.draw(picture, region=((100, 100), (101, 101)))
        self.assertEqual(picture.drawn, [])
        with self.assertRaisesRegex(fettle.Invalid, "no colours"):
            world.draw(picture, colours=True)
        with self.assertRaisesRegex(fettle.Invalid, "joints = 'no': expected True or False"):
            world.draw(picture, joints="no")
        picture.circle = lambda *_: 1 / 0
        with self.assertRaises(ZeroDivisionError):
            world.draw(picture)

    def test_values_of_another_kind_are_refused_by_name(self):
        world, ground, ball = a_world()
        shape = ball.shapes[0]
        for refused, expected in (
                (lambda: setattr(world, "bounds", 3), "bounds: expected \\(\\(left, bottom\\)"),
                (lambda: world.query_aabb(None), "box: expected"),
                (lambda: setattr(ball, "pose", 3), "pose: expected a pose: \\(position, angle\\), got 3"),
                (lambda: ball.set_target(None, 1), "pose: expected"),
                (lambda: shape.attach("ground"), "expected a Body"),
                (lambda: shape.distance(ball), "expected a Shape"),
                (lambda: shape.set_segment_surfaces(None), "surfaces: expected a list"),
                (lambda: shape.set_segment_surface(0, 3), "expected a SegmentSurface"),
                (lambda: fettle.Mover(ball), "expected a World"),
                (lambda: setattr(fettle.Mover(world), "state", 3), "expected a MoverState"),
                (lambda: fettle.join_lines(3), "lines: expected a list"),
                (lambda: fettle.clip_velocity((1, 0), [3]), "expected a MoverPlane"),
                (lambda: world.query_overlap(shape, pose=((0, 0), 0)), "a shape is where its body is"),
                (lambda: world.draw(ball), "expected a target with some of the methods polygon"),
                (lambda: world.start_recording(None), "expected a function"),
                (lambda: world.joint(numpy.array([1, 2])), "type = array")):
            with self.subTest(expected=expected), self.assertRaisesRegex(fettle.Invalid, expected):
                refused()

    def test_a_target_colors_what_is_drawn(self):
        class Picture:
            def __init__(self):
                self.colors = set()

            def circle(self, center, radius, angle, color):
                self.colors.add(color)

            def color_of(self, body, shape):
                return 0x123456 if shape in body.shapes else "red"

        world, _, _ = a_world()
        picture = Picture()
        world.draw(picture)
        self.assertEqual(picture.colors, {0x123456})
        picture.color_of = lambda body, shape: "red"
        with self.assertRaisesRegex(fettle.Invalid, "color_of = 'red': expected a whole number"):
            world.draw(picture)

    def test_an_account_tells_what_changed_a_velocity(self):
        world, ground, ball = a_world()
        self.assertIsNone(world.account(ball))
        world.keep_account(ball)
        run(world, 120)
        ball.awake = True
        ball.apply_force((3, 0))
        world.step(1 / 60)
        account = world.account(ball)
        self.assertAlmostEqual(account.gravity.y, -10 / 60, delta=1e-5)
        self.assertGreater(account.applied.x, 0)
        share, = account.contacts
        self.assertEqual((share.own.body, share.body), (ball, ground))
        sum = account.gravity.y + account.force.y + account.applied.y + account.fields.y + account.damping.y + share.change.y
        self.assertAlmostEqual(account.before.y + sum + account.rest.y, account.after.y, delta=1e-6)
        self.assertEqual(account.joints, [])
        self.assertEqual(account.turn.damping, 0)
        pin = world.joint("revolute", body_a=ground, body_b=ball)
        world.step(1 / 60)
        self.assertEqual([share.joint for share in world.account(ball).joints], [pin])
        with self.assertRaises(fettle.Invalid):
            world.keep_account("ball")
        ball.destroy()
        with self.assertRaises(fettle.Stale):
            world.account(ball)

    def test_the_log_of_the_process(self):
        lines = []
        world, _, ball = a_world()
        ball.set_velocity_function(lambda edit: setattr(edit, "velocity", (math.nan, 0)))
        fettle.set_log(lambda level, text: lines.append((level, text)))
        run(world, 3)
        fettle.set_log(None)
        told = len(lines)
        run(world, 3)
        level, text = lines[0]
        self.assertEqual(level, "warning")
        self.assertRegex(text, r"^the velocity function of a body .*, for body \d+, set velocity to NaN, which changes nothing$")
        self.assertEqual(len(lines), told)
        self.assertIn(fettle.simd_width(), (4, 8, 16))
        faults = []
        fettle.set_failure_function(faults.append)
        world, _, _ = a_world()
        run(world, 5)
        fettle.set_failure_function(None)
        self.assertEqual(faults, [])


class Objects(unittest.TestCase):
    def test_segments_of_a_chain_have_surfaces(self):
        world = fettle.World(gravity=(0, -10))
        ground = world.body("static").add(fettle.Chain([(0, 0), (10, 0), (20, 0), (30, 0)]), friction=0.5)
        ice = fettle.SegmentSurface(friction=0, material=4)
        ground.set_segment_surface(1, ice)
        self.assertEqual(ground.segment_surface(1), ice)
        self.assertIsNone(ground.segment_surface_override(0))
        self.assertEqual(ground.segment_surface_override(1), ice)
        boxes = [world.body(position=(x, 0.5), velocity=(5, 0)) for x in (2, 12)]
        for box in boxes:
            box.add(fettle.Box(), friction=0.5)
        run(world, 60)
        self.assertAlmostEqual(boxes[0].velocity.x, 0, delta=0.01)
        self.assertAlmostEqual(boxes[1].velocity.x, 5, delta=0.01)
        ground.set_segment_surface(1, fettle.SegmentSurface(friction=0, restitution=float("inf"), material=65535))
        ground.restitution = 0.25
        self.assertEqual((ground.segment_surface(1).restitution, ground.segment_surface(1).material), (0.25, 0))
        ground.set_segment_surface(1, None)
        self.assertIsNone(ground.segment_surface_override(1))
        ground.set_segment_surfaces([ice] * 3)
        self.assertEqual(ground.segment_surface(2), ice)
        with self.assertRaisesRegex(fettle.Invalid, "surfaces: expected none or 3"):
            ground.set_segment_surfaces([ice])
        with self.assertRaises(fettle.Invalid):
            ground.set_segment_surface(3, ice)

    def test_bodies_have_names_and_targets(self):
        world, ground, ball = a_world()
        ball.name = "bäll"
        self.assertEqual((ball.name, ground.name), ("bäll", ""))
        with self.assertRaises(fettle.Invalid):
            ball.name = 3
        lift = world.body("kinematic")
        lift.set_target(((0, 1), 0.5), 0.5)
        run(world, 30)
        self.assertAlmostEqual(lift.position.y, 1, delta=1e-3)
        self.assertAlmostEqual(lift.angle, 0.5, delta=1e-3)
        ball.sleep_speed = 0.25
        self.assertEqual((ball.sleep_speed, ball.sleep_speed_override), (0.25, 0.25))
        ball.sleep_speed = None
        self.assertIsNone(ball.sleep_speed_override)

    def test_worlds_tell_what_moved_and_what_is_where(self):
        world, ground, ball = a_world()
        run(world, 1)
        self.assertEqual(world.moved_bodies, [ball])
        self.assertEqual(world.body_in(ball.slot), ball)
        self.assertEqual(world.shape_in(ball.shapes[0].slot), ball.shapes[0])
        self.assertIsNone(world.body_in(999))
        world.reserve(bodies=100)
        self.assertTrue(all(used <= reserved for used, reserved in world.memory.values()))
        self.assertGreater(sum(used for used, _ in world.memory.values()), 0)
        view = world.states
        for move in (lambda: world.reserve(bodies=10000), lambda: world.take(fettle.World())):
            with self.assertRaises(BufferError):
                move()
        del view
        other = fettle.World()
        other.take(world)
        self.assertEqual((other.body_count, world.body_count), (2, 0))

    def test_joints_like_others(self):
        world, _, ball = a_world()
        hinge = world.dormant_joint("revolute")
        hinge.motor_speed = 3
        other = world.joint_like(hinge)
        self.assertEqual((other.type, other.motor_speed), ("revolute", 3))
        other.connect(None, ball)
        self.assertEqual(ball.joints, [other])
        self.assertEqual(ball.shapes[0].type, "circle")
        with self.assertRaises(fettle.Error):
            world.joint_like(None)

    def test_vertices_are_tried(self):
        world, _, ball = a_world()
        triangle = ball.add(fettle.Polygon([(0, 0), (1, 0), (0, 1)]))
        self.assertEqual(triangle.try_set_vertices([(0, 0), (1, 1), (2, 2)]), "collinear")
        self.assertEqual(triangle.try_set_vertices([(0, 0), (2, 0), (0, 2)]), "ok")
        self.assertEqual(len(triangle.vertices), 3)


class Standalone(unittest.TestCase):
    def test_geometries_are_measured(self):
        box, ball = fettle.Box(2, 1), fettle.Circle(0.5)
        mass = box.mass_properties(density=3)
        self.assertAlmostEqual(mass.area, 2, delta=1e-5)
        self.assertAlmostEqual(mass.mass, 6, delta=1e-4)
        self.assertEqual(box.bounding_box(((5, 0), 0)), ((4, -0.5), (6, 0.5)))
        self.assertTrue(box.contains((5.9, 0), ((5, 0), 0)))
        self.assertFalse(box.contains((5.9, 0)))
        hit = box.cast_ray((-5, 0), (5, 0))
        self.assertAlmostEqual(hit.fraction, 0.4, delta=1e-5)
        self.assertIsNone(box.cast_ray((-5, 3), (5, 3)))
        distance, near, far = box.distance(ball, None, ((3, 0), 0))
        self.assertAlmostEqual(distance, 1.5, delta=1e-5)
        self.assertAlmostEqual(far.x - near.x, 1.5, delta=1e-5)
        manifold, = box.contact_manifolds(ball, None, ((1.4, 0), 0))
        self.assertAlmostEqual(manifold.normal.x, 1, delta=1e-5)
        self.assertAlmostEqual(manifold.points[0][1], -0.1, delta=1e-4)
        still = (((0, 0), 0), ((0, 0), 0))
        time = ball.time_of_impact((((-10, 0), 0), ((10, 0), 0)), box, still)
        self.assertAlmostEqual(time, 8.5 / 20, delta=1e-3)
        self.assertIsNone(ball.time_of_impact((((-10, 5), 0), ((10, 5), 0)), box, still))
        concave = fettle.Concave([(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2)])
        self.assertGreater(len(concave.parts()), 1)
        with self.assertRaises(fettle.Invalid):
            box.distance("ball")
        with self.assertRaises(fettle.Invalid):
            box.contains((math.nan, 0))

    def test_lines_are_joined_and_grids_outlined(self):
        lines = fettle.join_lines([[(0, 0), (1, 0)], [(2, 1), (1, 0)], [(5, 5), (6, 5)]])
        self.assertEqual(sorted(len(line.points) for line in lines), [2, 3])
        square, = fettle.join_lines([[(0, 0), (1, 0), (1, 1)], [(1, 1), (0, 1), (0, 0)]], closed="clockwise")
        self.assertTrue(square.closed)
        self.assertEqual(len(square.points), 4)
        self.assertEqual(fettle.join_lines([]), [])
        self.assertEqual(fettle.without_straight_points([(0, 0), (1, 0), (2, 0)], 0.01), [(0, 0), (2, 0)])
        outline, = fettle.grid_outlines([[0, 0, 0, 0], [0, 1, 1, 0], [0, 1, 1, 0], [0, 0, 0, 0]], origin=(10, 0))
        self.assertTrue(outline.closed)
        self.assertTrue(all(10 < x < 13 for x, _ in outline.points))
        with self.assertRaises(fettle.Invalid):
            fettle.grid_outlines([1, 2, 3])
        with self.assertRaises(fettle.Invalid):
            fettle.join_lines([[(0, 0)]], closed="left")


if __name__ == "__main__":
    unittest.main()
