"""Tests of the package: python3 -m unittest discover bindings/python/tests"""

import copy
import gc
import math
import pickle
import unittest
import warnings
import weakref

import numpy

import fettle
from fettle._call import lib, list_of


def a_world(**settings):
    world = fettle.World(**settings)
    world.body("static", position=(0, -0.5)).add(fettle.Box(40, 1))
    return world


class Bodies(unittest.TestCase):
    def test_a_ball_falls_and_rests(self):
        world = a_world()
        ball = world.body(position=(0, 3))
        ball.add(fettle.Circle(0.5), restitution=0)
        begun = []
        for _ in range(120):
            world.step(1 / 60)
            begun += world.events.contact_begin
        self.assertAlmostEqual(ball.position.y, 0.5, delta=0.02)
        self.assertEqual(len(begun), 1)
        self.assertIn(ball, (begun[0].body_a, begun[0].body_b))
        self.assertEqual(len(ball.contacts), 1)
        self.assertTrue(ball.is_touching)

    def test_a_class_that_is_called_in_place_of_a_method_names_the_method(self):
        for kind, method in ((fettle.Body, "world.body"), (fettle.Shape, "body.add"), (fettle.Joint, "world.joint"),
                             (fettle.WheelJoint, "world.joint"), (fettle.Field, "world.field")):
            for arguments, named in (((), {}), (((0, 1),), {}), ((), {"position": (0, 5)}), ((1, 2, 3), {})):
                with self.assertRaisesRegex(fettle.Invalid, method.replace(".", "[.]")):
                    kind(*arguments, **named)

    def test_properties_are_read_and_set(self):
        world = fettle.World(gravity=(0, 0), substeps=8, solver="sequential", bounds=((-5, -5), (5, 5)))
        self.assertEqual((world.gravity, world.substeps, world.solver), ((0, 0), 8, "sequential"))
        self.assertEqual(world.bounds.max, (5, 5))
        body = world.body("kinematic", position=(1, 2), angle=0.5, locked_x=True, user_data=1 << 63)
        self.assertEqual((body.type, body.position, body.angle, body.locked_x), ("kinematic", (1, 2), 0.5, True))
        self.assertEqual(body.user_data, 1 << 63)
        body.mass = 3
        self.assertEqual((body.mass, body.mass_override), (3, 3))
        body.mass = None
        self.assertIsNone(body.mass_override)
        shape = body.add(fettle.Box(2, 1), friction=0.25, sensor=True)
        self.assertEqual((shape.width, shape.friction, shape.sensor, shape.type), (2, 0.25, True, "box"))
        shape.geometry = fettle.Polygon([(0, 0), (1, 0), (0, 1)])
        self.assertEqual(len(shape.geometry.points), 3)
        self.assertEqual(shape.body, body)
        segment = body.add(fettle.Segment((0, 0), (3, 0)))
        segment.end = (4, 0)
        self.assertEqual(segment.end, (4, 0))

    def test_errors_are_exceptions_with_a_message(self):
        world = fettle.World()
        body = world.body()
        with self.assertRaisesRegex(fettle.Invalid, "position"):
            body.position = (math.nan, 0)
        with self.assertRaisesRegex(ValueError, "linear_damping = -1"):
            body.linear_damping = -1
        with self.assertRaisesRegex(fettle.Invalid, r'no settable property positon \(did you mean "position"\?\); there are angle'):
            world.body(positon=(0, 1))
        with self.assertRaisesRegex(AttributeError, r'Body has no settable property postion \(did you mean "position"\?\); there are angle'):
            body.postion = (0, 1)
        with self.assertRaisesRegex(AttributeError, 'World has no settable property gravty .did you mean "gravity"'):
            world.gravty = (0, 1)
        with self.assertRaisesRegex(AttributeError, 'Mover has no settable property hight .did you mean "height"'):
            fettle.Mover(world).hight = 1
        for name in ("slot", "area"):
            with self.assertRaisesRegex(AttributeError, f"Body.{name} can be read, but not set"):
                setattr(body, name, 1)
        with self.assertRaisesRegex(AttributeError, 'Circle has no member raduis .did you mean "radius"'):
            fettle.Circle().raduis = 1
        with self.assertRaisesRegex(AttributeError, 'Wind has no member desity .did you mean "density"'):
            fettle.Wind().desity = 1
        with self.assertRaisesRegex(fettle.Invalid, 'did you mean "gravity"'):
            fettle.World(gravty=(0, -10))
        with self.assertRaisesRegex(fettle.Invalid, 'no property frction .did you mean "friction"'):
            body.add(fettle.Circle(), frction=1)
        with self.assertRaisesRegex(fettle.Invalid, "a mover has no setting zzz; there are"):
            fettle.Mover(world, zzz=1)
        with self.assertRaisesRegex(fettle.Invalid, "expected two numbers"):
            body.velocity = 7
        with self.assertRaisesRegex(fettle.Invalid, "static, kinematic, dynamic"):
            body.type = "heavy"
        with self.assertRaisesRegex(fettle.Invalid, "on one line|one line"):
            body.add(fettle.Polygon([(0, 0), (1, 1), (2, 2)]))
        self.assertEqual(world.body_count, 1)
        body.destroy()
        with self.assertRaises(fettle.Stale):
            body.angle
        other = fettle.World()
        lives = world.body()
        self.assertEqual(repr(lives), f"<Body {lives.slot}>")
        with self.assertRaisesRegex(fettle.Stale, f"got that of body {lives.slot} "):
            fettle.Body(other, lives.id).angle
        world.close()
        with self.assertRaises(fettle.Stale):
            world.step(1)

    def test_a_value_is_not_made_into_another_one(self):
        world = fettle.World()
        body = world.body()
        for owner, name, value in ((world, "substeps", 2.5), (body, "user_data", "7"), (body, "bullet", "no"),
                                   (body, "bullet", None), (body, "angle", "1"), (world, "substeps", None)):
            before = getattr(owner, name)
            with self.assertRaisesRegex(fettle.Invalid, f"{name} = .*: expected (a|True)"):
                setattr(owner, name, value)
            self.assertEqual(getattr(owner, name), before)
        for value in (("1", 2), "12", b"12", (10**400, 0)):
            with self.assertRaisesRegex(fettle.Invalid, "position: expected two numbers"):
                body.position = value
        world.substeps, body.bullet, body.angle = numpy.int64(2), numpy.bool_(True), numpy.float64(1)
        self.assertEqual((world.substeps, body.bullet, body.angle), (2, True, 1))
        for restore in (lambda: world.restore("text"), lambda: fettle.Replay(None)):
            with self.assertRaisesRegex(fettle.Invalid, "expected bytes, got"):
                restore()

    def test_a_world_may_be_closed_twice(self):
        world = fettle.World()
        world.close()
        world.close()
        with self.assertRaises(fettle.Stale):
            world.body()

    def test_joints_have_types(self):
        world = fettle.World(gravity=(0, 0))
        wheel = world.body(position=(1, 0))
        wheel.add(fettle.Circle(0.5))
        joint = world.joint("revolute", None, wheel, (0, 0), (-1, 0), motor_speed=2, max_motor_torque=math.inf)
        for _ in range(60):
            world.step(1 / 60)
        self.assertAlmostEqual(joint.angle, 2, delta=0.05)
        self.assertEqual((wheel.joints, joint.body_a, joint.body_b), ([joint], None, wheel))
        self.assertIsInstance(world.joints[0], fettle.RevoluteJoint)
        for name in fettle.joints.classes:
            other = world.joint(name, None, wheel)
            self.assertEqual(other.type, name)
            other.destroy()
        self.assertFalse(other.is_valid)

    def test_what_a_joint_does_not_set_is_measured_with_what_it_sets(self):
        world = fettle.World(gravity=(0, 0))
        a, b = world.body(), world.body(position=(3, 0))
        rope = world.joint("pulley", a, b, ground_a=(0, 4), ground_b=(3, 5), ratio=2)
        self.assertEqual(rope.length, 14)
        self.assertEqual(world.joint("pulley", a, b, ground_a=(0, 4), length=20).length, 20)
        gear = world.joint("gear", a, b, ratio=3, phase=None)
        self.assertEqual((gear.ratio, gear.phase), (3, 0))
        drag = world.joint("mouse", None, b, target=(5, 0), hertz=3, anchor=(1, 0))
        self.assertEqual((drag.target, drag.hertz, drag.anchor), ((5, 0), 3, (1, 0)))
        with self.assertRaisesRegex(fettle.Invalid, "axis: expected two numbers"):
            world.joint("wheel", a, b, axis=1)
        with self.assertRaisesRegex(fettle.Invalid, 'has_length'):
            world.joint("distance", a, b, has_length=True)
        self.assertEqual(len(world.joints), 4)

    def test_fields_act(self):
        world = fettle.World(gravity=(0, 0))
        leaf = world.body()
        leaf.add(fettle.Box())
        field = world.field(fettle.Attractor(center=(5, 0), strength=3, falloff=0))
        for _ in range(30):
            world.step(1 / 60)
        self.assertGreater(leaf.position.x, 0.2)
        self.assertEqual(field.force.strength, 3)
        self.assertEqual(world.fields, [field])


class Queries(unittest.TestCase):
    def test_what_is_where(self):
        world = a_world()
        box = world.body(position=(0, 0.5))
        shape = box.add(fettle.Box())
        self.assertEqual(world.query_point((0, 0.5)), [shape])
        self.assertEqual(len(world.query_aabb(((-1, -1), (1, 1)))), 2)
        self.assertEqual(world.query_aabb(((-1, -1), (1, 1)), accept=lambda s: s == shape), [shape])
        hit = world.cast_ray((0, 5), (0, -5))
        self.assertEqual(hit.shape, shape)
        self.assertAlmostEqual(hit.point.y, 1, delta=1e-3)
        self.assertEqual(len(world.cast_ray_all((0, 5), (0, -5))), 2)
        self.assertIsNone(world.cast_ray((5, 5), (6, 5)))
        self.assertAlmostEqual(world.cast_shape(fettle.Circle(0.5), (0, -4), ((0, 3), 0)).fraction, 0.375, delta=0.01)
        self.assertAlmostEqual(world.closest((0, 4)).distance, 3, delta=1e-3)
        self.assertEqual(len(world.query_overlap(fettle.Circle(2))), 2)
        self.assertEqual(fettle.convex_hull([(0, 0), (2, 0), (1, 0.1), (1, 2)]), [(0, 0), (2, 0), (1, 2)])

    def test_functions_are_called_and_may_raise(self):
        world = a_world()
        ball = world.body(position=(0, 0.5))
        ball.add(fettle.Circle())
        world.set_filter(lambda a, b: False)
        for _ in range(30):
            world.step(1 / 60)
        self.assertLess(ball.position.y, -0.5)
        world.set_filter(None)

        def forbidden(contact):
            ball.position = (0, 0)

        ball.position = (0, 0.4)
        world.set_before_solve(forbidden)
        with self.assertRaises(fettle.Locked):
            world.step(1 / 60)
        world.set_before_solve(None)
        with self.assertRaises(ZeroDivisionError):
            world.query_point((0, 0.4), accept=lambda s: 1 / 0)
        self.assertIsNone(world.fault)


class Lists(unittest.TestCase):
    def test_a_list_keeps_the_memory_of_its_structures(self):
        arrays = []

        def call(out, room, count):
            arrays.append(weakref.ref(out))
            count[0] = 2
            return lib.FETTLE_DONE

        found = list_of("fettle_contact", call)
        gc.collect()
        self.assertIsNotNone(arrays[0](), "the structures are views of freed memory")
        self.assertEqual([contact.shape_a for contact in found], [0, 0])


class Arrays(unittest.TestCase):
    def test_arrays_show_the_world_itself(self):
        for room in (1 << 40, -1, "four"):
            with self.assertRaisesRegex(fettle.Invalid, "bodies"):
                fettle.World(room=room)
        world = fettle.World(room=4)
        ball = world.body(position=(1, 5))
        poses, velocities = world.poses, world.velocities
        self.assertEqual(list(poses[ball.slot]), [1, 5, 0])
        world.step(0.5)
        self.assertEqual(tuple(poses[ball.slot, :2]), ball.position)
        self.assertEqual(tuple(velocities[ball.slot]), ball.velocity)
        self.assertEqual(world.previous_poses[ball.slot, 1], 5)
        with self.assertRaises(ValueError):
            poses[ball.slot] = 0

    def test_memory_that_is_shown_does_not_move(self):
        world = fettle.World(room=2)
        poses = world.poses[1:]
        first = world.body()
        world.body()
        with self.assertRaisesRegex(BufferError, "World.room"):
            world.body()
        state = world.save()
        for call in (lambda: world.restore(state), world.clear, world.close):
            with self.assertRaises(BufferError):
                call()
        first.destroy()
        world.body()
        del poses
        gc.collect()
        world.body()
        world.restore(state)

    def test_an_array_outlives_the_names_of_its_world(self):
        world = fettle.World()
        world.body(position=(3, 4))
        positions = world.positions
        del world
        gc.collect()
        self.assertEqual(list(positions[-1]), [3, 4])


class Snapshots(unittest.TestCase):
    def test_the_same_future(self):
        world = a_world()
        for i in range(6):
            world.body(position=(0.1 * i, 1 + i)).add(fettle.Box())
        state, copy = world.save(), world.clone()
        for _ in range(60):
            world.step(1 / 60)
            copy.step(1 / 60)
        self.assertEqual(world.hash, copy.hash)
        end = world.hash
        world.restore(state)
        for _ in range(60):
            world.step(1 / 60)
        self.assertEqual(world.hash, end)
        with self.assertRaises(fettle.Invalid):
            world.restore(state[:-1])


    def test_copies_and_pickles_are_worlds_of_their_own(self):
        world = a_world(solver="direct")
        ball = world.body(position=(0, 3))
        ball.add(fettle.Circle(0.5))
        for make in (copy.copy, copy.deepcopy, lambda each: pickle.loads(pickle.dumps(each))):
            other = make(world)
            other.step(1)
            self.assertEqual((other.solver, len(other.bodies), ball.position.y), ("direct", 2, 3))
            del other
            gc.collect()
            self.assertEqual(world.fault, None)
            both = make({"world": world, "ball": ball})
        self.assertIs(both["ball"].world, both["world"])
        both["world"].step(1 / 60)
        self.assertLess(both["ball"].position.y, 3)
        self.assertEqual(ball.position.y, 3)

    def test_a_state_of_any_layout_is_read_by_its_bytes(self):
        world = a_world()
        world.restore(numpy.frombuffer(world.save(), dtype=numpy.uint8).reshape(1, -1))
        self.assertEqual(len(world.bodies), 1)

    def test_a_misspelled_setting_is_refused(self):
        with self.assertRaises(AttributeError):
            fettle.World().gravty = (0, 0)


class Vectors(unittest.TestCase):
    @staticmethod
    def build(world):
        world.body("static", position=(0, -0.5)).add(fettle.Box(40, 1))
        cart = world.body(position=(0, 0.5))
        cart.add(fettle.Box(1, 1), friction=0)
        return [cart]

    def test_each_copy_goes_its_own_way(self):
        env = fettle.VectorWorld(self.build, count=8)
        begin = env.reset().copy()
        forces = numpy.zeros((8, 1, 2))
        forces[:, 0, 0] = numpy.arange(8)
        end = env.step(forces, steps=30)
        self.assertEqual(end.shape, (8, 1, 8))
        self.assertTrue((numpy.diff(end[:, 0, 0]) > 0).all())
        self.assertAlmostEqual(end[4, 0, 4], 4 * 0.5, delta=0.01)
        env.reset([7])
        self.assertEqual(list(env.observation[7, 0]), list(begin[7, 0]))
        self.assertGreater(env.observation[6, 0, 0], 0.1)
        env.reset([])
        self.assertGreater(env.observation[6, 0, 0], 0.1)
        env.reset(env.observation[:, 0, 0] > 0.1)
        self.assertLess(env.observation[:, 0, 0].max(), 0.2)

    def test_threads_change_no_result(self):
        one, two = (fettle.VectorWorld(self.build, count=9, threads=t) for t in (1, 2))
        forces = numpy.random.default_rng(1).normal(size=(9, 1, 2)) * 5
        for env in (one, two):
            env.step(forces, steps=50)
        self.assertTrue((one.observation == two.observation).all())

    def test_there_are_no_more_threads_than_processors(self):
        env = fettle.VectorWorld(self.build, count=9, threads=64)
        self.assertEqual(env.step().shape, (9, 1, 8))
        with self.assertRaisesRegex(fettle.Invalid, "threads = 65: expected 1 to 64"):
            fettle.VectorWorld(self.build, count=9, threads=65)

    def test_the_length_of_a_step_is_checked_when_it_is_set(self):
        env = fettle.VectorWorld(self.build, count=2)
        for dt in (0, -1, math.nan, math.inf, 1e-60):
            with self.assertRaisesRegex(fettle.Invalid, "dt = .*: expected a finite time above 0"):
                fettle.VectorWorld(self.build, count=2, dt=dt)
            with self.assertRaisesRegex(fettle.Invalid, "dt = .*: expected a finite time above 0"):
                env.dt = dt
        env.dt = 0.5
        self.assertEqual(env.dt, 0.5)
        env.step()

    def test_numbers_beyond_the_range_of_a_float_are_refused(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(fettle.Invalid, "forces.*inf"):
                fettle.VectorWorld(self.build, count=2).step(numpy.full((2, 1, 2), 1e300))
            with self.assertRaises(fettle.Invalid):
                fettle.World().body().add(fettle.Polygon([(0, 0), (1e300, 0), (0, 1)]))
            with self.assertRaises(fettle.Invalid):
                fettle.grid_outlines([[0, 10**400]])

    def test_wrong_shapes_are_refused(self):
        with self.assertRaises(fettle.Invalid):
            fettle.VectorWorld(lambda world: [3])
        env = fettle.VectorWorld(self.build, count=2)
        with self.assertRaises(ValueError):
            env.step(numpy.zeros((3, 1, 2)))
        with self.assertRaises(AttributeError):
            env.observation = numpy.zeros(1)
        with self.assertRaises(ValueError):
            env.observation.resize((1, 1, 1), refcheck=False)
        for wrong in ({"count": 2.5}, {"count": "2"}, {"count": 0}, {"threads": None}, {"dt": "slow"}):
            with self.assertRaisesRegex(fettle.Invalid, f"{list(wrong)[0]} = "):
                fettle.VectorWorld(self.build, **{"count": 2, **wrong})
        for build in (None, lambda world: None, lambda world: world.body()):
            with self.assertRaisesRegex(fettle.Invalid, "build: expected a function that returns a list of bodies"):
                fettle.VectorWorld(build, count=2)
        for steps in (-1, 1.5, "2"):
            with self.assertRaisesRegex(fettle.Invalid, "steps = "):
                env.step(steps=steps)
        for forces in ("much", numpy.zeros((2, 2, 2)), [[1], [1, 2]]):
            with self.assertRaisesRegex(fettle.Invalid, r"forces: expected an array of numbers of the shape \(2, 1, 2\)"):
                env.step(forces)
        for which in (2, [0, 5], [0.5], "all", True, [True], numpy.zeros((2, 1), bool)):
            with self.assertRaisesRegex(fettle.Invalid, "which: expected numbers of copies below 2, or 2 flags"):
                env.reset(which)
        env.reset(1)
        for how in (copy.copy, copy.deepcopy, pickle.dumps):
            with self.assertRaisesRegex(TypeError, "a VectorWorld cannot be copied"):
                how(env)

    def test_a_copy_is_not_closed_while_they_are_stepped(self):
        env = fettle.VectorWorld(self.build, count=4)
        env.worlds[0].bodies[-1].set_velocity_function(lambda edit: env.worlds[2].close())
        with self.assertRaisesRegex(fettle.Locked, "stepped together with others"):
            env.step()
        env.worlds[0].bodies[-1].set_velocity_function(None)
        env.step()
        env.worlds[2].close()
        for call in (env.step, env.reset, lambda: env.reset([0])):
            with self.assertRaises(fettle.Stale):
                call()


class Movers(unittest.TestCase):
    def course(self):
        """A floor at y = 0, a step of 0.2 m at x = 2, a wall at x = 4."""
        world = a_world()
        ground = world.body("static")
        ground.add(fettle.Box(2, 0.4, center=(3, 0)))
        return world, ground.add(fettle.Box(1, 10, center=(4.5, 0)))

    def test_a_mover_lands_and_climbs_a_step_and_is_stopped_by_a_wall(self):
        world, wall = self.course()
        hero = fettle.Mover(world, (0, 2), radius=0.3, height=1.5)
        self.assertFalse(hero.on_ground)
        self.assertIsNone(hero.ground)
        velocity = fettle.Vec2(0, 0)
        for _ in range(60):
            velocity = hero.move((0, velocity.y - 10 / 60), 1 / 60).velocity
            world.step(1 / 60)
        self.assertTrue(hero.on_ground)
        self.assertAlmostEqual(hero.position.y, 0, delta=0.03)
        self.assertAlmostEqual(hero.ground_normal.y, 1, delta=1e-4)
        stepped = False
        for _ in range(240):
            moved = hero.move((2, 0), 1 / 60)
            stepped = stepped or moved.stepped
            world.step(1 / 60)
        self.assertTrue(stepped and moved.hit_wall)
        self.assertEqual(moved.wall, wall)
        self.assertAlmostEqual(hero.position.x, 4 - 0.3, delta=0.05)
        self.assertAlmostEqual(hero.position.y, 0.2, delta=0.03)

    def test_settings_are_properties_and_checked(self):
        world, wall = self.course()
        hero = fettle.Mover(world, mask=6)
        self.assertEqual(hero.mask, 6)
        hero.max_slope = 0.5
        self.assertEqual(hero.max_slope, 0.5)
        with self.assertRaisesRegex(fettle.Invalid, "radius"):
            hero.radius = -1
        self.assertAlmostEqual(hero.radius, 0.4)
        with self.assertRaisesRegex(fettle.Invalid, 'no setting hight .did you mean "height".*; there are body'):
            fettle.Mover(world, hight=2)
        with self.assertRaises(fettle.Invalid):
            fettle.Mover(world, up=(0, 0))
        with self.assertRaises(fettle.Invalid):
            hero.position = (math.nan, 0)
        with self.assertRaises(AttributeError):
            hero.speed = 2
        self.assertEqual(fettle.Mover(world, body=wall.body).body, wall.body)

    def test_it_crouches_where_there_is_no_room_to_stand(self):
        world, _ = self.course()
        world.body("static").add(fettle.Box(4, 1, center=(0, 1.5)))  # from 1 m
        hero = fettle.Mover(world, (0, 0.02), height=0.9)
        self.assertFalse(hero.fits(1.8))
        self.assertFalse(hero.set_height(1.8))
        hero.position = (-5, 0.02)
        self.assertTrue(hero.set_height(1.8))
        self.assertAlmostEqual(hero.height, 1.8, delta=1e-6)
        planes = hero.planes(0.5)
        self.assertAlmostEqual(planes[0].normal.y, 1, delta=1e-4)
        self.assertAlmostEqual(fettle.solve_planes((1, -2), planes).y, -planes[0].separation, delta=1e-4)
        self.assertAlmostEqual(fettle.clip_velocity((1, -2), planes).y, 0, delta=1e-6)
        self.assertEqual(fettle.clip_velocity((1, -2), []), (1, -2))
        with self.assertRaisesRegex(fettle.Invalid, "length 1"):
            fettle.solve_planes((1, -2), [planes[0]._replace(normal=(0, 3))])
        with self.assertRaisesRegex(fettle.Invalid, "climbing"):
            hero.climbing = "yes"

    def test_its_height_is_set_where_there_is_room(self):
        world, _ = self.course()
        world.body("static").add(fettle.Box(4, 1, center=(0, 1.5)))  # from 1 m
        hero = fettle.Mover(world, (0, 0.02), height=0.9)
        hero.height = 0.8
        self.assertAlmostEqual(hero.height, 0.8, delta=1e-6)
        with self.assertRaisesRegex(fettle.Error, "height = 1.8: there is no room for it"):
            hero.height = 1.8
        self.assertAlmostEqual(hero.height, 0.8, delta=1e-6)

    def test_errors_name_the_setting_and_no_function_that_the_program_did_not_call(self):
        hero = fettle.Mover(fettle.World())
        for name, value in (("radius", -1), ("skin", -1), ("up", (0, 0)), ("height", -1), ("height", 0.01)):
            with self.assertRaisesRegex(fettle.Invalid, rf"^Mover: .*{name}"):
                setattr(hero, name, value)
        with self.assertRaisesRegex(fettle.Invalid, "^Mover: radius = -1"):
            fettle.Mover(fettle.World(), radius=-1)

    def test_its_state_is_kept_and_copied(self):
        world, _ = self.course()
        hero = fettle.Mover(world, (0, 0.02))

        def walk(mover):
            for _ in range(30):
                mover.move((1, -1), 1 / 60)
            return mover.position

        walk(hero)
        kept, twin = hero.state, copy.copy(hero)
        both = copy.deepcopy((world, hero))
        end = walk(hero)
        self.assertGreater(end.x, kept.position.x + 0.4)
        self.assertEqual(twin.state, kept)
        self.assertEqual(walk(twin), end)
        hero.state = kept
        self.assertEqual(walk(hero), end)
        self.assertIs(both[1].world, both[0])
        self.assertEqual(walk(both[1]), end)
        hero.climbing = True
        self.assertEqual(hero.state.climbing, True)
        world.close()
        with self.assertRaises(fettle.Stale):
            hero.move((1, 0), 1 / 60)

    def test_it_drops_through_a_ledge(self):
        world, _ = self.course()
        ledge = world.body("static").add(fettle.Box(4, 0.2, center=(0, 3)), category=4)
        hero = fettle.Mover(world, (0, 3.12), ledges=4)
        for _ in range(10):
            hero.move((0, -1), 1 / 60)
        self.assertEqual(hero.ground, ledge)
        self.assertTrue(hero.drop())
        self.assertEqual(hero.dropped, ledge)
        for _ in range(60):
            hero.move((0, -4), 1 / 60)
        self.assertAlmostEqual(hero.position.y, 0, delta=0.03)
        self.assertFalse(hero.drop())


if __name__ == "__main__":
    unittest.main()
