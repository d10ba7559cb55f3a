# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# Reads all files our_* of a folder, which must hold the same solid, and writes it to files their_* in all formats.
#
# usage: exchange_with_meshio.py FOLDER

import glob
import os
import sys

import meshio
import numpy

folder = sys.argv[1]
reference = meshio.read(os.path.join(folder, "our_ascii.vtu"))
tetrahedra = reference.cells_dict["tetra"]
regions = reference.cell_data_dict["region"]["tetra"].reshape(-1)
weights = reference.point_data["weights"]

for path in glob.glob(os.path.join(folder, "our_*")):
    mesh = meshio.read(path)
    assert numpy.array_equal(mesh.points, reference.points), path
    read = mesh.cells_dict["tetra"]
    if path.endswith(".inp"):  # in the order of the regions
        read = read[numpy.argsort(numpy.argsort(regions, kind="stable"), kind="stable")]
    assert numpy.array_equal(read, tetrahedra), path
    if ".vt" in path:
        assert numpy.array_equal(mesh.point_data["weights"], weights), path
    for name in ("region", "gmsh:physical", "medit:ref"):
        if name in mesh.cell_data:
            assert numpy.array_equal(mesh.cell_data_dict[name]["tetra"].reshape(-1), regions), path


def write(name, region_name, **options):
    data = {region_name: [regions.astype(numpy.int32)]}
    if region_name == "gmsh:physical":
        data["gmsh:geometrical"] = [numpy.ones_like(regions, dtype=numpy.int32)]
    points = {"weights": weights} if ".vt" in name else {}
    mesh = meshio.Mesh(reference.points, [("tetra", tetrahedra)], point_data=points, cell_data=data)
    mesh.write(os.path.join(folder, "their_" + name), **options)


# Its VTU files in words have 12 digits only.
write("base64.vtu", "region", compression=None)
write("zlib.vtu", "region", compression="zlib")
for version in ("4.2", "5.1"):
    for binary in (False, True):
        write("%s_%d.vtk" % (version, binary), "region", file_format="vtk" + version.replace(".", ""), binary=binary)
for binary in (False, True):
    write("2_%d.msh" % binary, "gmsh:physical", file_format="gmsh22", binary=binary)
write("text.mesh", "medit:ref")
write("binary.meshb", "medit:ref")
write("plain.inp", "region", file_format="abaqus")
