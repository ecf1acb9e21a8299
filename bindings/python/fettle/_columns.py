"""Arrays of numpy over the memory of a world, without copies."""

import weakref

import numpy

from ._call import check, ffi, lib


class _Memory:
    """The memory that an array of numpy shows. It keeps the world alive, and the world has a weak reference to it."""

    def __init__(self, world, address, shape):
        self.world = world
        self.__array_interface__ = {"version": 3, "data": (address, True), "shape": shape, "typestr": "<f4"}


class Columns:
    """The arrays that a world has given. While one of them is alive, its memory must not move."""

    def __init__(self, world):
        self._world = weakref.ref(world)
        self._memory = weakref.WeakSet()

    def _view(self, address, slots, width):
        memory = _Memory(self._world(), int(ffi.cast("uintptr_t", address)), (slots, width))
        self._memory.add(memory)
        return numpy.asarray(memory)

    def _columns(self):
        columns = ffi.new("fettle_columns*")
        check(lib.fettle_world_columns(self._world()._pointer, columns))
        return columns

    def states(self):
        columns = self._columns()
        return self._view(columns.states, columns.body_slots, 8)

    def previous(self):
        columns = self._columns()
        return self._view(columns.previous, columns.body_slots, 3)

    def may_move(self, what):
        """Refuses what would move memory that an array shows."""
        if len(self._memory):
            raise BufferError(f"{what}: arrays of this world exist and would show freed memory; delete them, take them anew "
                              "from the world each time, or make room for bodies with World(room=...)")

    def may_grow(self):
        """Refuses a new body if it would move memory that an array shows: a body in a free slot moves nothing."""
        if not len(self._memory):
            return
        world = self._world()
        if world.body_slots - 1 - world.body_count <= 0:  # slot 0 belongs to the world
            self.may_move("a new body")
