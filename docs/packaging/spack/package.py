# SPDX-License-Identifier: BSD-3-Clause
# A recipe for Spack: see docs/packaging/README.md
from spack.package import *


class Scree(AutotoolsPackage):
    """Granular simulation with particles of very different sizes, on threads and ranks of MPI, with exchangeable
    spatial indexes, and an implicit SPH fluid between the grains."""

    license("BSD-3-Clause")

    version("0.1.0")

    variant("petsc", default=False, description="Fluids, by PETSc")
    variant("zoltan", default=True, description="Domains balanced by recursive bisection")
    variant("microhttpd", default=True, description="The live view of a run")
    variant("muparser", default=True, description="Expressions over the fields of particles")

    depends_on("c", type="build")
    depends_on("autoconf", type="build")
    depends_on("automake", type="build")
    depends_on("libtool", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("mpi")
    depends_on("hdf5+mpi")
    depends_on("libyaml")
    depends_on("zlib-api")
    depends_on("random123", type="build")
    depends_on("petsc@3.18:+mpi~int64~complex", when="+petsc")
    depends_on("trilinos+zoltan", when="+zoltan")
    depends_on("libmicrohttpd", when="+microhttpd")
    depends_on("muparser", when="+muparser")
    depends_on("cmocka", type="test")

    def configure_args(self):
        return self.with_or_without("petsc") + self.with_or_without("microhttpd")
