"""VTU against meshio: rbpa's .vtu holds the points and cells of its .npy files, and of surfaces. usage: read_vtu.py RBPA DATA"""
import os
import subprocess
import sys
import tempfile

try:
    import meshio
    import numpy
except ImportError as missing:
    print(f"SKIPPED: {missing}")
    sys.exit(77)

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    points = numpy.random.default_rng(5).random((2000, 2))
    numpy.save("p.npy", points)
    for complex_kind in ("solid", "full"):
        subprocess.run([sys.argv[1], "mesh", "p.npy", "--alpha", "0.01", "--complex", complex_kind, "-q",
                        "-o", "m.vtu", "-o", "m.npy"], check=True)
        mesh = meshio.read("m.vtu")
        assert numpy.array_equal(mesh.points[:, :2], points) and not mesh.points[:, 2].any()
        assert numpy.array_equal(mesh.cells_dict["triangle"], numpy.load("m.npy"))
        if complex_kind == "full":
            assert numpy.array_equal(mesh.cells_dict["line"], numpy.load("m.edges.npy"))
            assert numpy.array_equal(mesh.cells_dict["vertex"][:, 0], numpy.load("m.points.npy"))
    for scan, options in (("m3_torus.off", []), ("m3_cube_no_bottom.off", []), ("m3_torus.off", ["--normals", "none"])):
        subprocess.run([sys.argv[1], "surface", os.path.join(sys.argv[2], scan), "--radius", "auto", "-q", *options,
                        "-o", "s.vtu", "-o", "s.npy"], check=True)
        mesh = meshio.read("s.vtu")
        assert sorted(mesh.cells_dict["triangle"].tolist()) == numpy.load("s.npy").tolist()  # that is sorted
        assert numpy.array_equal(mesh.points, meshio.read(os.path.join(sys.argv[2], scan)).points)
        assert ("Normals" in mesh.point_data) == (not options)
print("meshio reads what was written")
