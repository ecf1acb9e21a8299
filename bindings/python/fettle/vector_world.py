"""Many copies of one world, for machine learning."""

import math
import os
from concurrent.futures import ThreadPoolExecutor

import numpy

from ._call import Invalid, check, ffi, hold, lib
from ._properties import to_number
from ._values import floats
from .body import Body
from .world import World


class VectorWorld:
    """`count` copies of one world. `build(world)` fills the world once and returns the bodies that are observed and pushed.

        def build(world):
            cart = world.body(position=(0, 1))
            cart.add(fettle.Box(1, 0.5))
            return [cart]

        env = fettle.VectorWorld(build, count=256)
        observation = env.reset()                       # (256, 1, 8)
        observation = env.step(numpy.zeros((256, 1, 2)))  # forces, N

    An observation has for each copy and each body x, y, angle, angular velocity, velocity x and y, cosine and sine of the angle.
    It is the same array each time. `dt` is the length of a step, s. `threads`, 1 to 64, share the copies, at most one for each
    processor; they change no result. It cannot be copied.
    """

    def __init__(self, build, count=256, dt=1 / 60, threads=1, **settings):
        count, threads = (to_number("uint32_t", value, name) for value, name in ((count, "count"), (threads, "threads")))
        if count < 1:
            raise Invalid(f"count = {count}: expected at least 1")
        if not 1 <= threads <= 64:
            raise Invalid(f"threads = {threads}: expected 1 to 64")
        self.dt = dt
        threads = min(threads, count, os.cpu_count() or 1)
        self._template = World(**settings)
        self._bodies = self._built(build)
        self._worlds = tuple(self.template.clone() for _ in range(count))
        # A view: the library writes into its memory, so it must not be resized.
        self._observation = numpy.zeros((count, len(self.bodies), 8), dtype=numpy.float32)[:]
        self._forces = numpy.zeros((count, len(self.bodies), 2), dtype=numpy.float32)
        self._pointers = ffi.new("fettle_world*[]", [world._pointer for world in self.worlds])
        self._ids = ffi.new("fettle_id[]", [body.id for body in self.bodies] * count)
        self._parts = self._divide(count, threads)
        self._pool = ThreadPoolExecutor(threads) if threads > 1 else None

    @property
    def dt(self):
        """Length of a step, s."""
        return self._dt

    @dt.setter
    def dt(self, dt):
        number = to_number("float", dt, "dt")
        if not 0 < float(ffi.cast("float", number)) < math.inf:
            raise Invalid(f"dt = {dt}: expected a finite time above 0, s")
        self._dt = number

    # The library reads and writes the memory of these, so a program cannot put others in their place.
    template = property(lambda self: self._template, doc="The world that `build` filled.")
    bodies = property(lambda self: self._bodies, doc="Those that `build` returned.")
    worlds = property(lambda self: self._worlds, doc="The copies.")
    observation = property(lambda self: self._observation, doc="The array that `reset` and `step` return.")

    def _built(self, build):
        expected = "build: expected a function that returns a list of bodies of the world that it gets, got"
        if not callable(build):
            raise Invalid(f"{expected} {build!r}")
        bodies = build(self.template)
        if not isinstance(bodies, (list, tuple)) or not all(isinstance(b, Body) and b.world is self.template for b in bodies):
            raise Invalid(f"{expected} one that returned {bodies!r}")
        return tuple(bodies)

    def __reduce__(self):
        raise TypeError("a VectorWorld cannot be copied or pickled: make another one with the same function")

    @staticmethod
    def _divide(count, threads):
        bounds = [count * i // threads for i in range(threads + 1)]
        return list(zip(bounds, bounds[1:]))

    def _observe(self):
        states = ffi.cast("fettle_body_state*", self.observation.ctypes.data)
        check(lib.fettle_worlds_read_states(self._pointers, len(self.worlds), self._ids, len(self.bodies), states))
        return self.observation

    def reset(self, which=None):
        """Brings all copies, or those whose numbers or flags `which` has, back to the beginning."""
        chosen = self._chosen(which)
        with hold(self.worlds, "reset"):
            for i in chosen:
                check(lib.fettle_world_assign(self.worlds[i]._pointer, self.template._pointer))
            return self._observe()

    def _chosen(self, which):
        """The numbers of the copies that are meant."""
        count = len(self.worlds)
        if which is None:
            return range(count)
        given = numpy.asarray(which)
        if given.size == 0 and given.ndim == 1:
            return ()
        if given.dtype == bool and given.shape == (count,):
            return numpy.flatnonzero(given)
        if given.dtype.kind in "iu" and given.ndim <= 1 and given.size and given.min() >= -count and given.max() < count:
            return numpy.atleast_1d(given)
        raise Invalid(f"which: expected numbers of copies below {count}, or {count} flags, got {which!r}")

    def step(self, forces=None, steps=1):
        """Makes `steps` steps, each with these forces (N): an array for (copies, bodies, 2). Returns the observation."""
        if forces is not None:
            self._set_forces(forces)
        dt, steps = self.dt, to_number("uint32_t", steps, "steps")
        with hold(self.worlds, "step"):
            if self._pool is None:
                self._step_part((0, len(self.worlds)), forces is not None, steps, dt)
            else:
                list(self._pool.map(lambda part: self._step_part(part, forces is not None, steps, dt), self._parts))
            return self._observe()

    def _set_forces(self, forces):
        try:
            self._forces[...] = floats(forces)
        except (TypeError, ValueError, OverflowError):
            shape = numpy.shape(forces) if isinstance(forces, numpy.ndarray) else forces
            raise Invalid(f"forces: expected an array of numbers of the shape {self._forces.shape}, got {shape!r}") from None

    def _step_part(self, part, pushed, steps, dt):
        begin, end = part
        worlds, count, bodies = self._pointers + begin, end - begin, len(self.bodies)
        ids = self._ids + begin * bodies
        forces = ffi.cast("fettle_vec2*", self._forces.ctypes.data) + begin * bodies
        for _ in range(steps):
            if pushed:
                check(lib.fettle_worlds_apply_forces(worlds, count, ids, bodies, forces))
            check(lib.fettle_worlds_step(worlds, count, dt))
