# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Builds and installs the Python module: pip install ./examples/python

The compiled library is built first, which takes some minutes. FLIP_FREE_MAPS_CMAKE_ARGUMENTS are further arguments for CMake,
CMAKE_BUILD_PARALLEL_LEVEL is the number of compilers that run at once. A build folder that is kept, build/, makes the next
installation a quick one.
"""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "FLIP_FREE_MAPS_BUILD_PYTHON": "ON",
            "FLIP_FREE_MAPS_BUILD_EXAMPLES": "OFF",
            "FLIP_FREE_MAPS_BUILD_TESTS": "OFF",
            "Python_EXECUTABLE": sys.executable,
        }
        more = shlex.split(os.environ.get("FLIP_FREE_MAPS_CMAKE_ARGUMENTS", ""))
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *definitions, *more], check=True)
        parallel = [] if "CMAKE_BUILD_PARALLEL_LEVEL" in os.environ else ["--parallel", str(os.cpu_count() or 1)]
        subprocess.run(["cmake", "--build", build, "--target", "flip_free_maps_python", *parallel], check=True)
        made = next((build / "examples" / "python" / "flip_free_maps").glob("_core*"))
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(made), str(target))


setup(
    name="flip_free_maps",
    version=re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text()).group(1),
    description="Low-distortion maps of triangle and tetrahedral meshes in which no element is flipped",
    license="GPL-3.0-or-later",
    package_dir={"": "src"},
    packages=["flip_free_maps"],
    package_data={"flip_free_maps": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("flip_free_maps._core", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
    install_requires=["numpy"],
    python_requires=">=3.8",
    zip_safe=False,
)
