"""Repeating the recording of a world."""

from typing import NamedTuple, Optional

from ._call import check, ffi, lib
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
    """

    __slots__ = ("_pointer",)

    def __init__(self, recording):
        self._pointer = ffi.NULL
        made, data = ffi.new("fettle_replay**"), to_bytes(recording, "Replay")
        check(lib.fettle_replay_create(data, len(data), made))
        self._pointer = made[0]

    def __del__(self):
        if getattr(self, "_pointer", ffi.NULL) != ffi.NULL:
            lib.fettle_replay_destroy(self._pointer)

    @property
    def steps(self):
        """Number of steps in the recording."""
        out = ffi.new("uint64_t*")
        check(lib.fettle_replay_steps(self._pointer, out))
        return out[0]

    @property
    def is_cut_off(self):
        """Whether the recording ends within a part that was written; the parts before are replayed."""
        out = ffi.new("bool*")
        check(lib.fettle_replay_is_cut_off(self._pointer, out))
        return out[0]

    def step(self):
        """Repeats the next step; None at the end, and after a step that was not the same."""
        told, repeated = ffi.new("fettle_replayed_step*"), ffi.new("bool*")
        check(lib.fettle_replay_step(self._pointer, told, repeated))
        if not repeated[0]:
            return None
        return ReplayedStep(told.number, told.dt, told.same, told.recorded_hash if told.has_recorded_hash else None, told.hash,
                            ffi.string(told.calls).decode())

    def __iter__(self):
        return iter(self.step, None)

    @property
    def world(self):
        """A copy of the world after the last repeated step."""
        made = ffi.new("fettle_world**")
        check(lib.fettle_replay_world(self._pointer, made))
        return World._of(made[0])
