"""Functions of the program that the library calls for all worlds."""

from ._call import check, ffi, keep_exception, lib
from ._properties import to_function
from ._values import log_levels

_kept = {}  # as long as C may call them


def set_log(function):
    """`function(level, text)` gets messages about problems that the library finds and does not raise as an exception;
    `level`: "note", "warning" or "error". None: no function, which is the default."""
    callback = ffi.NULL if to_function(function, "set_log") is None else ffi.callback(
        "fettle_log_function", lambda user, level, text: function(log_levels[level], ffi.string(text).decode()) and None,
        onerror=keep_exception)
    check(lib.fettle_set_log(callback, ffi.NULL))
    _kept["log"] = callback


def set_failure_function(function):
    """While there is `function(what)`, each world is checked after each step, which is slow, and the function gets the first
    fault. None: no function, which is the default."""
    callback = ffi.NULL if to_function(function, "set_failure_function") is None else ffi.callback(
        "fettle_failure_function", lambda user, what: function(ffi.string(what).decode()) and None, onerror=keep_exception)
    check(lib.fettle_set_failure_function(callback, ffi.NULL))
    _kept["failure"] = callback


def simd_width():
    """Number of values that the solver computes at a time on this machine: 4, 8 or 16."""
    return lib.fettle_simd_width()
