"""Calls of the library in C, and its errors."""

import contextlib
import difflib
import os
import pathlib
import threading

from ._interface import ffi


def _open():
    packed = pathlib.Path(__file__).with_name("libfettle_physics_c.so")
    named = os.environ.get("FETTLE_LIBRARY") or (str(packed) if packed.exists() else "libfettle_physics_c.so.0.1")
    try:
        return ffi.dlopen(named)
    except OSError as error:
        raise ImportError(f"{error}; the environment variable FETTLE_LIBRARY may name libfettle_physics_c.so") from None


_library = _open()


class Error(Exception):
    """A call was refused, and has changed nothing."""


class Invalid(Error, ValueError):
    """An argument has no meaning: NaN, out of range, of a wrong type."""


class Stale(Error, LookupError):
    """The world, body, shape, joint or field does not exist any more."""


class Locked(Error, RuntimeError):
    """The world is calling a function, which must not edit it."""


# --- One thread at a time

# Calls in C run beside other threads of Python. A world belongs to one of them at a time: a lock for each that is open, by its pointer.
_locks = {}
closed = ffi.cast("fettle_world*", 1)  # in place of the pointer of a world that is destroyed, which a later one may get
_inside = threading.local()  # the worlds that have called this thread, and hold their lock themselves


def open_world(pointer):
    _locks[pointer] = threading.RLock()


def close_world(pointer):
    del _locks[pointer]


@contextlib.contextmanager
def called_by(world):
    """For a `with` around a function that a world calls: the function may use the world, on whichever thread it is called."""
    outer = getattr(_inside, "pointers", ())
    _inside.pointers = (*outer, world._pointer)
    try:
        yield
    finally:
        _inside.pointers = outer


def _lock_for_call(name, pointer):
    """Acquires the lock of a world for a call. None where the world itself has called this thread, which needs no lock."""
    lock = _locks.get(pointer)
    if lock is None:
        raise Stale(f"{name}: world: it was destroyed")
    if lock.acquire(blocking=False):
        return lock
    if pointer in getattr(_inside, "pointers", ()):
        return None
    raise Locked(f"{name}: another thread is in a call with this world, which belongs to one thread at a time")


def _with_locks(function, name, places):
    """`function` with a check: it raises `Locked` while another thread is in a call with one of the worlds that it gets. `places`: their
    indices among the arguments."""
    def call(*arguments):
        with contextlib.ExitStack() as held:
            for place in places:
                if (lock := _lock_for_call(name, arguments[place])) is not None:
                    held.callback(lock.release)
            return function(*arguments)

    def call_with_one(*arguments):
        lock = _lock_for_call(name, arguments[places[0]])
        try:
            return function(*arguments)
        finally:
            if lock is not None:
                lock.release()

    return call_with_one if len(places) == 1 else call


held_together = set()  # pointers of worlds that are in the list of a running call in C


def hold(worlds, name):
    """Holds several worlds for a `with`: no other thread may use them, and no callback of one of them may close another."""
    with contextlib.ExitStack() as held:
        for world in worlds:
            pointer = world._pointer
            if (lock := _lock_for_call(name, pointer)) is not None:
                held.callback(lock.release)
            if pointer not in held_together:
                held_together.add(pointer)
                held.callback(held_together.discard, pointer)
        return held.pop_all()


def _if_open(is_valid):
    return lambda pointer, id: pointer in _locks and is_valid(pointer, id)


class _Library:
    """The library in C."""

    def __getattr__(self, name):
        found = getattr(_library, name)
        if name.startswith("fettle_"):
            places = [i for i, given in enumerate(type_of(name).args) if given.cname in _worlds]
            if name.endswith("_is_valid"):
                found = _if_open(found)
            elif places:
                found = _with_locks(found, name, places)
        setattr(self, name, found)
        return found

    def __dir__(self):
        return dir(_library)


_worlds = [ffi.typeof(name).cname for name in ("fettle_world*", "const fettle_world*")]


def type_of(name):
    """The type of a function in C."""
    return ffi.typeof(getattr(_library, name))


lib = _Library()
_errors = {lib.FETTLE_INVALID: Invalid, lib.FETTLE_STALE: Stale, lib.FETTLE_LOCKED: Locked,
           lib.FETTLE_NO_MEMORY: MemoryError}


def unknown(what, names, kind=Invalid):
    """The error for a name that does not exist. `what` is its text, which ends with that name; the nearest name and all names are added."""
    names = sorted(names)
    near = difflib.get_close_matches(what.split()[-1], names, 1)
    meant = f' (did you mean "{near[0]}"?)' if near else ""
    return kind(f"{what}{meant}; there are {', '.join(names)}")


_raised = threading.local()  # by a function of the host, inside a call


def keep_exception(kind, exception, traceback):
    """For `onerror` of a callback: `check` raises the first exception when the call is over."""
    if getattr(_raised, "exception", None) is None:
        _raised.exception = exception


def check(code):
    """Raises what a callback raised, or the error that a code stands for."""
    exception = getattr(_raised, "exception", None)
    if exception is not None:
        _raised.exception = None
        raise exception
    if code != lib.FETTLE_DONE:
        raise _errors.get(code, Error)(ffi.string(lib.fettle_last_error()).decode())


def version():
    """Version of the library, as in "0.1.0"."""
    return ffi.string(lib.fettle_physics_version()).decode()


class _Elements(list):
    """The elements of an array. Those that are structures are views of its memory, which lives as long as this list."""

    __slots__ = ("_array",)


def list_of(ctype, call):
    """All elements of a list: `call(out, room, count)`."""
    count = ffi.new("uint32_t*")
    room = 16
    while True:
        out = ffi.new(ctype + "[]", room)
        check(call(out, room, count))
        if count[0] <= room:
            elements = _Elements(out[i] for i in range(count[0]))
            elements._array = out
            return elements
        room = count[0]


def definition(name, *arguments):
    """A definition with its defaults."""
    made = ffi.new(name + "*")
    check(getattr(lib, name + "_init")(made, ffi.sizeof(name), *arguments))
    return made
