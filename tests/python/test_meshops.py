"""rbpa.meshops: the operators of libmeshops, and their misuse from Python."""

import ast
import pathlib
import pickle
import threading

import numpy as np
import pytest
import rbpa
from rbpa import meshops
from rbpa.meshops import Mesh
from refusals import refuses
from sets import DATA, uniform

TETRAHEDRON = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]
COUNTS = ("vertices", "edges", "faces")


def off_faces(name: str) -> np.ndarray:
    lines = (DATA / name).read_text().split("\n")
    vertices, faces = (int(n) for n in lines[1].split()[:2])
    return np.array([[int(n) for n in line.split()[1:]] for line in lines[2 + vertices : 2 + vertices + faces]])


def live(mesh: Mesh) -> list:
    """Returns all live records, by number."""
    return [
        [(v, mesh.halfedge_of_vertex(v)) for v in mesh.vertices()],
        [(h, mesh.from_vertex(h), mesh.next(h), mesh.prev(h), mesh.face(h)) for h in mesh.halfedges()],
        [(f, mesh.halfedge_of_face(f)) for f in mesh.faces()],
    ]


def counts(mesh: Mesh) -> dict:
    r = mesh.report()
    solid = {"curves": r.boundary_curves, "components": r.components, "genus": r.genus}
    return {**{name: getattr(r, name) for name in COUNTS}, **solid}


def checked(mesh: Mesh, operator, *arguments, **options):
    """Returns the effect of an operator, after checking its delta and the mesh."""
    before = counts(mesh)
    assert getattr(mesh, operator + "_blocker")(*arguments, **options) is None
    effect = getattr(mesh, operator)(*arguments, **options)
    delta = effect if isinstance(effect, meshops.Delta) else effect.delta
    assert counts(mesh) == {name: value + getattr(delta, name) for name, value in before.items()}
    assert mesh.validate() == []
    return effect


def test_faces_come_back_as_they_went_in():
    for faces in (off_faces("m3_bob.off"), np.array(TETRAHEDRON, np.uint8)):
        mesh = Mesh(faces)
        assert np.array_equal(mesh.triangles(), faces) and mesh.validate() == []
        assert mesh.n_faces == len(faces) == len(mesh.faces()) and mesh.n_vertices == faces.max() + 1
        assert mesh.n_edges == 3 * len(faces) // 2 and len(mesh.halfedges()) == 3 * len(faces)
    mixed = Mesh([[0, 1, 2, 3], (2, 1, 4)], points=7)
    corners, begin = mixed.polygons()
    assert corners.tolist() == [0, 1, 2, 3, 2, 1, 4] and begin.tolist() == [0, 4, 7]
    assert mixed.n_vertices == 7 and mixed.report().isolated == 2
    refuses("face 0 is not a triangle", mixed.triangles)
    assert Mesh().n_faces == 0 and Mesh().triangles().shape == (0, 3) and Mesh(np.empty((0, 3), int)).n_vertices == 0


@pytest.mark.parametrize(
    "faces, sentence",
    [
        ([[0, 1, -1]], "found the corner -1"),
        ([[0, 1, 2**31]], "found the corner 2147483648"),
        ([[0, 1, 1.5]], "corners of float64, expected whole numbers"),
        ([[0, 1, [2]]], "."),
        (np.zeros(3, int), r"shape \(3,\), expected \(m, k\)"),
        ([[[0, 1, 2]]], "cycles of corners"),
        ([[0, 1]], "degenerate face"),
        ([[0, 1, 2], [0, 1, 3]], "orientation"),
        ([[0, 1, 2], [1, 0, 3], [0, 1, 4]], "non-manifold edge"),
    ],
)
def test_faces_that_are_no_manifold_are_refused(faces, sentence):
    with pytest.raises(ValueError, match=sentence):
        Mesh(faces)
    with pytest.raises(rbpa.ContractViolation, match="corner out of range"):
        Mesh([[0, 1, 2]], points=2)


def test_walks_are_those_of_a_halfedge_mesh():
    mesh = Mesh(np.delete(off_faces("m3_bob.off"), [0, 100, 200], axis=0))
    for h in mesh.halfedges():
        assert mesh.prev(mesh.next(h)) == h == mesh.opposite(mesh.opposite(h))
        assert mesh.to_vertex(h) == mesh.from_vertex(mesh.next(h)) == mesh.from_vertex(mesh.opposite(h))
        assert mesh.edge(h) == h // 2 and mesh.face(mesh.next(h)) == mesh.face(h)
        assert mesh.is_boundary(h) == (mesh.face(h) is None)
        assert mesh.find_halfedge(mesh.from_vertex(h), mesh.to_vertex(h)) == h
    for f in mesh.faces():
        assert mesh.face(mesh.halfedge_of_face(f)) == f
        assert mesh.face_vertices(f).tolist() == mesh.triangles()[f].tolist()
    on_curves = np.concatenate(mesh.boundary_curves())
    assert sorted(on_curves) == [h for h in mesh.halfedges() if mesh.is_boundary(h)]
    assert len(mesh.boundary_curves()) == mesh.report().boundary_curves == 3
    assert mesh.find_halfedge(0, 0) is None and Mesh((), 1).halfedge_of_vertex(0) is None


def test_every_operator_can_be_undone():
    mesh = Mesh(off_faces("m3_spot.off")[:400])
    inner = next(e for e in mesh.edges() if not mesh.is_boundary(2 * e) and not mesh.is_boundary(2 * e + 1)
                 and mesh.flip_blocker(e) is None)  # fmt: skip
    before = live(mesh)
    flipped = checked(mesh, "flip", inner)
    assert flipped.edge == inner and live(mesh) != before
    mesh.undo(flipped)
    assert live(mesh) == before

    split = checked(mesh, "split_edge", 2 * inner)
    assert split.vertex == mesh.from_vertex(split.halfedge) and len(split.edges) == 3 and len(split.faces) == 2
    welded = checked(mesh, "weld_edge", split.halfedge)
    assert welded.vertex == split.vertex and live(mesh) == before
    mesh.undo(welded)
    checked(mesh, "collapse", split.halfedge)
    assert live(mesh) == before

    face = int(mesh.faces()[5])
    star = checked(mesh, "split_face", face)
    assert checked(mesh, "weld_face", star.vertex).face == star.face == face and live(mesh) == before

    halfedge = next(h for h in mesh.halfedges() if mesh.collapse_blocker(h) is None and not mesh.is_boundary(h))
    collapsed = checked(mesh, "collapse", halfedge)
    checked(mesh, "split_vertex", collapsed.left, collapsed.right)
    vertex = next(v for v in mesh.vertices() if mesh.remove_vertex_blocker(v) is None)
    before = live(mesh)
    removed = checked(mesh, "remove_vertex", vertex)
    assert removed.vertex == vertex
    mesh.undo(removed)
    assert live(mesh) == before


def test_handle_operators_make_a_torus_of_triangles():
    mesh = Mesh()
    first = mesh.create_triangle()
    second = mesh.create_triangle()
    before = live(mesh)
    joined = checked(mesh, "glue", first.boundary, second.boundary)
    assert joined.what == "join" and mesh.report().components == 1
    assert mesh.unglue(joined).what == "join" and live(mesh) == before
    checked(mesh, "destroy_triangle", second.face)

    square = Mesh([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [4, 5, 9, 8], [5, 6, 10, 9], [6, 7, 11, 10],
                   [8, 9, 13, 12], [9, 10, 14, 13], [10, 11, 15, 14]])  # fmt: skip
    sides = {(square.from_vertex(h), square.to_vertex(h)): h for h in square.boundary_curves()[0]}
    pairs = [(sides[i + 1, i], sides[12 + i, 13 + i]) for i in range(3)]
    pairs += [(sides[4 * i, 4 * i + 4], sides[4 * i + 7, 4 * i + 3]) for i in range(3)]
    cases = [checked(square, "glue", *pair).what for pair in pairs]
    assert cases == ["split curve", "zip", "zip", "handle", "zip", "close"]
    assert square.report().betti == (1, 2, 1) and square.report().genus == 1
    generators, cut = square.homology()
    assert len(generators) == 2 and len(cut) > 0
    for loop in generators:
        assert [square.to_vertex(h) for h in loop] == [square.from_vertex(h) for h in np.roll(loop, -1)]
    short, _ = square.homology(np.ones(square.edge_bound))
    assert {len(loop) for loop in short} == {3}
    checked(square, "open_curve", 4)
    assert checked(square, "close_curve", square.boundary_curves()[0][0]).face is not None


def test_curves_are_sewn_and_polygons_are_cut():
    mesh = Mesh([[0, 1, 2], [3, 4, 5]])
    a, b = mesh.boundary_curves()
    assert checked(mesh, "zip_curves", a[0], b[0]).edges == 3
    assert mesh.report().betti == (1, 0, 1)
    mesh = Mesh([[0, 1, 2, 3, 4, 5]])
    h = mesh.halfedge_of_face(0)
    cut = checked(mesh, "insert_diagonal", h, mesh.next(mesh.next(h)))
    checked(mesh, "remove_diagonal", cut.diagonal)
    points = np.array([[0, 0], [1, 0], [2, 0.1], [2, 1], [1, 1.1], [0, 1]])

    def perimeter(*corners: int) -> float:
        return float(np.linalg.norm(points[list(corners)] - points[list(corners[1:] + corners[:1])], axis=1).sum())

    assert mesh.triangulate_face_blocker(0) is None
    effect = mesh.triangulate_face(0, perimeter)
    assert len(effect.faces) == len(effect.diagonals) == 3 == effect.delta.faces
    assert {tuple(sorted((mesh.from_vertex(d), mesh.to_vertex(d)))) for d in effect.diagonals} >= {(1, 4)}

    def changes_it(*_: int) -> float:
        mesh.flip(mesh.edge(effect.diagonals[0]))
        return 0.0

    polygon = mesh = Mesh([[0, 1, 2, 3]])
    with pytest.raises(rbpa.ContractViolation, match="cannot be changed while"):
        polygon.triangulate_face(0, lambda *_: polygon.split_face(0) and 0.0)
    assert mesh.n_faces == 1
    with pytest.raises((TypeError, ValueError)):
        polygon.triangulate_face(0, lambda *_: "light")
    with pytest.raises(ZeroDivisionError):
        polygon.triangulate_face(0, lambda *_: 1 / 0)
    assert mesh.n_faces == 1 and "faces=1" in repr(mesh.triangulate_face(0, lambda *_: 0))


def test_refusals_say_why_and_leave_the_mesh_as_it_was():
    mesh = Mesh(TETRAHEDRON)
    before = live(mesh)
    e = int(mesh.edges()[0])
    for operator, argument in [("flip", e), ("collapse", 2 * e), ("open_curve", 99), ("close_curve", 2 * e),
                               ("weld_face", 17), ("split_face", -1), ("unglue", 1000), ("destroy_triangle", 0),
                               ("remove_vertex", 50), ("split_edge", -7)]:  # fmt: skip
        reason = getattr(mesh, operator + "_blocker")(argument)
        assert reason, operator
        with pytest.raises(rbpa.ContractViolation, match=reason.split("(")[0][:20]):
            getattr(mesh, operator)(argument)
    for query in ("from_vertex", "next", "face", "halfedge_of_vertex", "halfedge_of_face", "face_vertices"):
        for nothing in (-1, 1000):
            with pytest.raises(rbpa.ContractViolation, match=f" {nothing} does not exist or is deleted"):
                getattr(mesh, query)(nothing)
        for wrong in (None, 1.5, "a", 2**40):
            with pytest.raises(TypeError):
                getattr(mesh, query)(wrong)
    with pytest.raises(rbpa.ContractViolation, match="keep: found 'all', expected 'simplicial' or 'manifold'"):
        mesh.flip(e, keep="all")
    assert live(mesh) == before and mesh.flip_blocker(e, keep="manifold") is None


def test_random_operators_never_break_a_mesh():
    random = np.random.default_rng(7)
    mesh = Mesh(off_faces("m3_torus.off"))
    names = ["flip", "collapse", "split_edge", "split_face", "weld_face", "weld_edge", "remove_vertex", "unglue",
             "remove_triangle", "close_curve", "open_curve", "remove_diagonal"]  # fmt: skip
    done = 0
    for _ in range(2500):
        name, element = names[random.integers(len(names))], int(random.integers(-1, len(mesh.halfedges()) + 3))
        if getattr(mesh, name + "_blocker")(element) is None:
            getattr(mesh, name)(element)
            done += 1
    assert done > 300 and mesh.validate() == []
    mesh.compact()
    assert mesh.validate() == [] and mesh.vertices().tolist() == list(range(mesh.n_vertices))


def test_an_effect_of_another_mesh_is_refused_or_harmless():
    one, other = Mesh(off_faces("m3_bob.off")), Mesh(TETRAHEDRON)
    e = next(int(e) for e in one.edges() if one.flip_blocker(e) is None and e > 20)
    with pytest.raises(rbpa.ContractViolation):
        other.undo(one.flip(e))
    h = next(int(h) for h in one.halfedges() if one.collapse_blocker(h) is None and h > 50)
    with pytest.raises(rbpa.ContractViolation):
        other.undo(one.collapse(h))
    assert other.validate() == []


def test_pinches_get_a_vertex_for_each_fan():
    mesh = Mesh([[0, 1, 2], [2, 3, 4]])
    assert mesh.n_vertices == 6 and mesh.point_of_vertex.tolist() == [0, 1, 2, 3, 4, 2]
    assert mesh.report().components == 2 and mesh.report(mesh.point_of_vertex).pinches == 1
    assert mesh.report(mesh.point_of_vertex).components == 1


def test_defects_repair_and_report_of_any_faces():
    faces = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [5, 5, 6], [0, 1, 2], [2, 7, 8]]
    kinds = [d.kind for d in meshops.find_defects(faces)]
    assert "non-manifold edge" in kinds and "degenerate face" in kinds and "duplicate face" in kinds
    defect = meshops.find_defects(faces)[kinds.index("non-manifold edge")]
    assert str(defect) == "non-manifold edge: points 0 1, faces 0 1 2" and defect.points == [0, 1]
    made = meshops.repair(faces)
    assert meshops.find_defects(made.faces, len(made.stands_on)) == []
    assert made.stands_on[:9].tolist() == list(range(9)) and set(made.face_was) <= set(range(6))
    assert {s.kind for s in made.steps} >= {"face dropped", "edge cut"}
    assert Mesh(made.faces, len(made.stands_on)).n_faces == len(made.faces) == 4
    good = off_faces("m3_bob.off")
    same = meshops.repair(good)
    assert isinstance(same.faces, np.ndarray) and np.array_equal(same.faces, good) and same.steps == []
    of_faces, of_mesh = meshops.report(good), Mesh(good).report()
    assert of_faces.betti == of_mesh.betti == (1, 2, 1) and of_faces.genus == 1 == of_faces.per_component[0].genus
    moebius = meshops.report([[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]])
    assert moebius.genus is None and not moebius.per_component[0].orientable and moebius.euler == 0


def test_triangles_of_a_shape_make_a_mesh():
    shape = rbpa.alpha_shape(uniform(2000), 0.02)
    mesh = Mesh(shape.simplices, len(shape.points))
    report = mesh.report(mesh.point_of_vertex)
    assert report.solid_components == len(shape.polygons) and report.isolated == len(shape.isolated)
    assert np.array_equal(mesh.point_of_vertex[mesh.triangles()], shape.simplices)


def test_a_pickle_is_the_same_mesh_deleted_elements_too():
    mesh = Mesh(off_faces("m3_plate_holes.off"))
    collapsed = mesh.collapse(next(int(h) for h in mesh.halfedges() if mesh.collapse_blocker(h) is None))
    again = pickle.loads(pickle.dumps(mesh))
    assert type(again) is Mesh and live(again) == live(mesh)
    assert np.array_equal(again.point_of_vertex, mesh.point_of_vertex)
    before = live(mesh)
    for of in (mesh, again):
        of.undo(collapsed)
        assert of.validate() == []
    assert live(again) == live(mesh) != before


def test_damaged_pickles_are_refused():
    state = Mesh(TETRAHEDRON).__getstate__()
    random = np.random.default_rng(3)
    refused = 0
    for _ in range(300):
        arrays = [np.array(part) for part in state]
        part = arrays[random.integers(3)]
        part[tuple(random.integers(part.shape))] = random.integers(-3, 40)
        mesh = Mesh.__new__(Mesh)
        try:
            mesh.__setstate__(tuple(arrays))
        except rbpa.ContractViolation:
            refused += 1
        else:
            assert mesh.validate() == []
    assert refused > 100


def test_a_mesh_that_another_thread_works_on_cannot_be_changed():
    shape = rbpa.Delaunay(uniform(100_000))
    mesh = Mesh(shape.simplices)
    refused, done = [], threading.Event()

    def change() -> None:
        while not done.is_set():
            try:
                mesh.flip(int(np.random.randint(1000)))
            except rbpa.ContractViolation as error:
                refused.append(str(error))

    thread = threading.Thread(target=change)
    thread.start()
    generators, cut = mesh.homology()
    done.set()
    thread.join()
    assert len(generators) == 0 and any("while another call uses the mesh" in sentence for sentence in refused)


def test_stubs_say_what_there_is():
    stub = ast.parse((pathlib.Path(rbpa.__file__).parent / "_core.pyi").read_text())
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}

    def members(node: ast.ClassDef) -> set:
        own = {m.name for m in node.body if isinstance(m, ast.FunctionDef)}
        return own.union(*(members(classes[base.id]) for base in node.bases if base.id in classes))

    core = rbpa._core
    for name, node in classes.items():
        if not name.startswith("_"):
            real = {m for m in dir(getattr(core, name)) if not m.startswith("_")}
            assert {m for m in members(node) if not m.startswith("_")} | {"add_note", "args", "with_traceback"} >= real
            assert all(hasattr(getattr(core, name), m) for m in members(node)), name
            assert getattr(core, name).__doc__ or name in ("Locator", "Mesh", "ProgressiveMesh", "SolidLocator"), name
    functions = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert functions == {n for n in dir(core) if not n.startswith("_") and n not in classes and n not in ("version", "EXPECTED_ALPHA")}
    for name in {m for m in dir(Mesh) if not m.startswith("_")}:
        assert getattr(Mesh, name).__doc__, name


def test_files_of_meshes_are_read_as_by_the_program(tmp_path: pathlib.Path) -> None:
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    for ending in ("off", "ply", "obj", "stl"):
        path = tmp_path / f"part.{ending}"
        rbpa.surface_of(corners, TETRAHEDRON).save(path)
        points, faces, warnings = meshops.read(path)
        assert sorted(map(tuple, points)) == sorted(map(tuple, corners)) and not warnings
        assert Mesh(faces, len(points)).report().betti == (1, 0, 1)
        again = meshops.read(path.rename(tmp_path / f"part_{ending}.dat"), format=ending)
        assert (again.points == points).all() and (again.faces == faces).all()
    mixed = tmp_path / "mixed.off"
    mixed.write_text("OFF 5 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 2\n4 0 1 3 2\n3 1 4 3\n")
    assert [face.tolist() for face in meshops.read(mixed).faces] == [[0, 1, 3, 2], [1, 4, 3]]
    mixed.write_text("OFF 5 2 0\n0 0 0\n")
    for call, message in (
        (lambda: meshops.read(mixed), "mixed.off"),
        (lambda: meshops.read(tmp_path / "part_off.dat"), "format"),
        (lambda: meshops.read(mixed, format="las"), "format: found 'las'"),
        (lambda: meshops.read(mixed, format=3), "format: found 3"),  # type: ignore[arg-type]
    ):
        with pytest.raises(rbpa.InvalidInput, match=message):
            call()
    with pytest.raises(FileNotFoundError):
        meshops.read(tmp_path / "none.off")
