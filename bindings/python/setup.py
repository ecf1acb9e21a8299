"""Builds the package for `pip install bindings/python`. If FETTLE_LIBRARY is the path of libfettle_physics_c.so, the package
contains a copy of that library. Otherwise the system searches for the library when the package is imported."""

import os
import pathlib
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithLibrary(build_py):
    def run(self):
        super().run()
        library = os.environ.get("FETTLE_LIBRARY")
        if library:
            package = pathlib.Path(self.build_lib) / "fettle"
            shutil.copy(library, package / "libfettle_physics_c.so")


setup(packages=["fettle"], cffi_modules=["build_interface.py:ffi"], cmdclass={"build_py": BuildWithLibrary},
      has_ext_modules=lambda: bool(os.environ.get("FETTLE_LIBRARY")))
