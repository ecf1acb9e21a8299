"""Repeating the recording of a world."""

import contextlib
import threading
from typing import NamedTuple, Optional

from ._call import Locked, check, ffi, lib
from ._properties import to_bytes
from .world import World


class ReplayedStep(NamedTuple):
    """A step that was repeated."""
    number: int  # from 0
    dt: float  # s
    same: bool  # False: it ends in other bits than when it was recorded, and the replay ends
    recorded_hash: Optional[int]  # None: the recording ends within this step
    hash: int
    calls: str  # the methods of C++ that edited the world before it


class Replay:
    """Repeats a recording, step by step:

        for step in fettle.Replay(recording):
            assert step.same

    A replay belongs to one thread at a time, as a world does, and cannot be copied.
    """

    __slots__ = ("_pointer", "_lock")

    def __new__(cls, *arguments, **named):
        self = super().__new__(cls)
        self._pointer, self._lock = ffi.NULL, threading.Lock()
        return self

    def __init__(self, recording):
        made, data = ffi.new("fettle_replay**"), to_bytes(recording, "Replay")
        check(lib.fettle_replay_create(data, len(data), made))
        with self._locked():
            self._end()  # of an earlier recording
            self._pointer = made[0]

    def __del__(self):
        self._end()

    def _end(self):
        pointer, self._pointer = self._pointer, ffi.NULL
        lib.fettle_replay_destroy(pointer)

    def __reduce__(self):
        raise TypeError("a Replay cannot be copied or pickled: make another one of the recording")

    @contextlib.contextmanager
    def _locked(self):
        """The pointer for a `with`, in which no other thread may use it."""
        if not self._lock.acquire(blocking=False):
            raise Locked("another thread is in a call with this Replay, which belongs to one thread at a time")
        try:
            yield self._pointer
        finally:
            self._lock.release()

    @property
    def steps(self):
        """Number of steps in the recording."""
        out = ffi.new("uint64_t*")
        with self._locked() as pointer:
            check(lib.fettle_replay_steps(pointer, out))
        return out[0]

    @property
    def is_cut_off(self):
        """Whether the recording ends within a part that was written; the parts before are replayed."""
        out = ffi.new("bool*")
        with self._locked() as pointer:
            check(lib.fettle_replay_is_cut_off(pointer, out))
        return out[0]

    def step(self):
        """Repeats the next step; None at the end, and after a step that was not the same."""
        out, repeated = ffi.new("fettle_replayed_step*"), ffi.new("bool*")
        with self._locked() as pointer:
            check(lib.fettle_replay_step(pointer, out, repeated))
            if not repeated[0]:
                return None
            return ReplayedStep(out.number, out.dt, out.same, out.recorded_hash if out.has_recorded_hash else None,
                                out.hash, ffi.string(out.calls).decode(errors="replace"))

    def __iter__(self):
        return iter(self.step, None)

    @property
    def world(self):
        """A copy of the world after the last repeated step."""
        made = ffi.new("fettle_world**")
        with self._locked() as pointer:
            check(lib.fettle_replay_world(pointer, made))
        return World._of(made[0])
