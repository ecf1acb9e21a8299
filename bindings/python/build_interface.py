"""Makes fettle/_interface.py from the headers in C. Run by pip, by hand for use in the checkout, and for the Debian
package, with the folder to make it in as argument."""

import os
import pathlib
import re
import sys

from cffi import FFI

here = pathlib.Path(__file__).resolve().parent
# An installed Fettle has its headers elsewhere.
include = pathlib.Path(os.environ.get("FETTLE_INCLUDE", here.parent / "c" / "include"))


def declarations():
    """The headers as fettle/physics_c/basics.h says that cffi reads them."""
    umbrella = (include / "fettle_physics.h").read_text()
    files = re.findall(r"#include <(fettle/physics_c/\w+\.h)>", umbrella)
    text = "\n".join((include / file).read_text() for file in files)
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"^#.*$", "", text, flags=re.M)
    return re.sub(r"\bFETTLE_PHYSICS_C_(BEGIN|END)\b", "", text)


ffi = FFI()
ffi.cdef(declarations())
ffi.set_source("fettle._interface", None)

if __name__ == "__main__":
    ffi.compile(tmpdir=sys.argv[1] if len(sys.argv) > 1 else str(here))
