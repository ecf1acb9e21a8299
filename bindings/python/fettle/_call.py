"""Calls of the library in C, and its errors."""

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


lib = _open()


class Error(Exception):
    """A call was refused, and has changed nothing."""


class Invalid(Error, ValueError):
    """An argument has no meaning: NaN, out of range, of a wrong type."""


class Stale(Error, LookupError):
    """The world, body, shape, joint or field does not exist any more."""


class Locked(Error, RuntimeError):
    """The world is calling a function, which must not edit it."""


_errors = {lib.FETTLE_INVALID: Invalid, lib.FETTLE_STALE: Stale, lib.FETTLE_LOCKED: Locked,
           lib.FETTLE_NO_MEMORY: MemoryError}


def unknown(what, names):
    """The error for `what`, which ends with a name that does not exist. It tells the nearest one, and all."""
    names = sorted(names)
    near = difflib.get_close_matches(what.split()[-1], names, 1)
    meant = f' (did you mean "{near[0]}"?)' if near else ""
    return Invalid(f"{what}{meant}; there are {', '.join(names)}")


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


def list_of(ctype, call):
    """All elements of a list: `call(out, room, count)`."""
    count = ffi.new("uint32_t*")
    room = 16
    while True:
        out = ffi.new(ctype + "[]", room)
        check(call(out, room, count))
        if count[0] <= room:
            return [out[i] for i in range(count[0])]
        room = count[0]


def definition(name, *arguments):
    """A definition with its defaults."""
    made = ffi.new(name + "*")
    check(getattr(lib, name + "_init")(made, ffi.sizeof(name), *arguments))
    return made
