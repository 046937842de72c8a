"""Not run by Conan; see README.md."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = os.path.join("..", "..", "..")


class Weft(ConanFile):
    name = "weft"
    license = "MIT"
    description = "Real-time cloth for games"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "with_tbb": [True, False]}
    default_options = {"shared": False, "fPIC": True, "with_tbb": True}

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, ROOT, "engine", "include", "weft", "version.h"))
        self.version = re.search(r'WEFT_VERSION_STRING "([0-9.]+)"', header)[1]

    def export_sources(self):
        root = os.path.join(self.recipe_folder, ROOT)
        for part in ("engine/*", "collision/*", "cloth/*", "CMakeLists.txt", "LICENSE", "CHANGELOG.md"):
            copy(self, part, root, self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/3.4.0")
        self.requires("highway/1.0.3")
        self.requires("xxhash/0.8.2")
        if self.options.with_tbb:
            self.requires("onetbb/2021.10.0")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["WEFT_TBB"] = bool(self.options.with_tbb)
        for part in ("RENDER", "DEMO", "TESTS"):
            toolchain.cache_variables["WEFT_BUILD_" + part] = False
        toolchain.generate()
        packages = CMakeDeps(self)  # under the names of Highway's own build
        packages.set_property("highway", "cmake_file_name", "hwy")
        packages.set_property("highway", "cmake_target_name", "hwy::hwy")
        packages.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.set_property("cmake_target_name", "weft::weft")
        self.cpp_info.libs = ["weft"] if self.options.shared else ["weft_cloth", "weft_collision", "weft_engine"]
        if self.options.shared:
            self.cpp_info.defines = ["WEFT_SHARED"]
        elif self.settings.os == "Linux":
            self.cpp_info.system_libs = ["pthread", "m"]
