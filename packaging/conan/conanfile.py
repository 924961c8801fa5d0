"""librbpa and libmeshops for Conan 2: `conan create packaging/conan` in a clone."""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


class RbpaConan(ConanFile):
    name = "rbpa"
    license = "MIT"
    description = "Exact alpha shapes, Delaunay triangulations and surfaces of points; topological operators on halfedge meshes"
    topics = ("alpha-shapes", "delaunay", "computational-geometry", "halfedge")
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    requires = ("boost/[>=1.74]", "eigen/[>=3.4]", "highway/[>=1.0.3]", "nanoflann/[>=1.4]", "onetbb/[>=2021]", "openmesh/[>=9.0]")

    def set_version(self):
        self.version = re.search(r"^project\(rbpa VERSION ([0-9.]+)", load(self, os.path.join(ROOT, "CMakeLists.txt")), re.M)[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "libmeshops/*", "librbpa/*"):
            copy(self, pattern, ROOT, self.export_sources_folder)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("APPS", "PYTHON", "TESTS"):
            toolchain.cache_variables[f"RBPA_BUILD_{part}"] = "OFF"
        toolchain.cache_variables["RBPA_POSITION_INDEPENDENT"] = "ON" if self.options.get_safe("fPIC") else "OFF"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.components["meshops"].libs = ["meshops"]
        self.cpp_info.components["meshops"].set_property("cmake_target_name", "meshops::meshops")
        self.cpp_info.components["meshops"].requires = ["boost::headers", "openmesh::openmesh"]
        self.cpp_info.components["rbpa"].libs = ["rbpa"]
        self.cpp_info.components["rbpa"].set_property("cmake_target_name", "rbpa::rbpa")
        self.cpp_info.components["rbpa"].requires = ["meshops", "eigen::eigen", "highway::highway", "nanoflann::nanoflann", "onetbb::onetbb"]
