# SPDX-License-Identifier: BSD-3-Clause
"""pip wheel --no-build-isolation --no-deps adapters/python

Compiles the module, which takes some minutes, or takes one that CMake has built: KITH_MODULE=build/release/python/kith/_kith*.so
"""

import os
import re
import shutil

from pybind11.setup_helpers import Pybind11Extension, build_ext
from setuptools import setup

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.relpath(os.path.join(here, "..", ".."), here)
with open(os.path.join(here, root, "CMakeLists.txt")) as lists:
    version = re.search(r"project\(kith VERSION ([0-9.]+)", lists.read()).group(1)


class build_or_take(build_ext):
    def build_extension(self, extension):
        built = os.environ.get("KITH_MODULE")
        if built:
            target = self.get_ext_fullpath(extension.name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copy(built, target)
        else:
            super().build_extension(extension)


setup(
    name="kith",
    version=version,
    description="Subdivision surfaces of NumPy arrays, with all levels and all relations between them",
    license="BSD-3-Clause",
    packages=["kith"],
    python_requires=">=3.8",
    install_requires=["numpy"],
    extras_require={"sparse": ["scipy"]},
    cmdclass={"build_ext": build_or_take},
    ext_modules=[
        Pybind11Extension(
            "kith._kith",
            ["module.cpp"],  # with all that it needs: kith is headers only
            include_dirs=[os.path.join(root, "include"), os.path.join(root, "schemes")],
            cxx_std=20,
            extra_compile_args=["-O2", "-ffp-contract=off", "-fno-ipa-modref"],
        )
    ],
)
