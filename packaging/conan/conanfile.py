# A recipe for Conan 2: `conan create packaging/conan`, in the folder of the sources.
# It was written after Conan's documentation, and has not been tested with Conan. Conan's own collection of recipes has no
# SuperLU: the headers take that of the system (Debian's libsuperlu-dev, for example), which has to be there.
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, CMakeDeps
from conan.tools.files import copy


class AngleBasedFlatteningConan(ConanFile):
    name = "cgal-angle-based-flattening"
    version = "0.1.0"
    description = "Angle-based flattening (ABF++) of triangulated surfaces for CGAL"
    license = ("GPL-3.0-or-later", "LGPL-3.0-or-later")
    topics = ("geometry", "mesh", "parameterization", "cgal")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"with_tbb": [True, False]}
    default_options = {"with_tbb": True}
    no_copy_source = True

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE*", "include/*", "cmake/*", "package_info/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True)
        self.requires("eigen/[>=3.4 <6]", transitive_headers=True)
        if self.options.with_tbb:
            self.requires("onetbb/[>=2021]", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 17)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("EXAMPLES", "DEMO", "TESTS"):
            toolchain.cache_variables["ABF_BUILD_" + part] = False
        toolchain.cache_variables["ABF_INSTALL_CORE"] = False
        toolchain.generate()

    def build(self):
        CMake(self).configure()

    def package(self):
        CMake(self).install()

    def package_id(self):
        self.info.clear()

    def package_info(self):
        # CMake finds the package as it is installed, with its own module for SuperLU.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append(os.path.join("share", "cmake", "CGAL_Angle_based_flattening"))
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
