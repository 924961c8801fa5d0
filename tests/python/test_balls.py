"""Unions of balls with a radius each, atoms with names and radii, and frames."""

import csv
import math
import os
import pathlib
import pickle
import re
import shutil
import subprocess
import warnings

import numpy
import pytest
import rbpa
from refusals import refuses

LYSOZYME = pathlib.Path(__file__).parents[1] / "data/mol3_2lyz.pdb"
FURTHER = pathlib.Path(os.environ.get("RBPA_DATA_DIR", os.devnull))


def some(seed, *shape):
    random = numpy.random.default_rng(seed)
    return random.random((*shape, 3)), random.uniform(0.0, 0.2, shape)


def test_two_balls_have_the_sizes_of_their_formulas():
    two = rbpa.balls([[0, 0, 0], [0, 0, 2]], [1.5, 0.5], 0.5)
    areas = [16 * math.pi - 2 * math.pi * 2 * 0.25, 4 * math.pi - 2 * math.pi * 0.75]
    assert two.areas.tolist() == pytest.approx(areas, rel=1e-14)
    assert two.area == pytest.approx(sum(areas), rel=1e-14) and type(two.area) is float
    caps = math.pi * 0.25**2 * (6 - 0.25) / 3, math.pi * 0.75**2 * (3 - 0.75) / 3
    assert two.volumes.tolist() == pytest.approx([32 * math.pi / 3 - caps[0], 4 * math.pi / 3 - caps[1]], rel=1e-14)
    contacts = two.contacts
    assert contacts.balls.tolist() == [[0, 1]] and contacts.distances.tolist() == [2]
    assert contacts.areas[0] == pytest.approx(math.pi * (4 - 1.75**2), rel=1e-14)
    assert contacts.arcs[0] == pytest.approx(2 * math.pi * math.sqrt(4 - 1.75**2), rel=1e-14)
    assert two.without_probe.area == pytest.approx(4 * math.pi * (1.5**2 + 0.5**2), rel=1e-14)
    assert two.volume_gradient[1].tolist() == pytest.approx([0, 0, contacts.areas[0]], rel=1e-14)
    assert two.simplices.shape == (0, 4) and two.hidden.tolist() == [] and len(two) == 2


def test_equal_radii_are_those_of_union_of_balls():
    points = some(1, 500)[0]
    union = rbpa.union_of_balls(points, 0.08)
    made = rbpa.balls(points, 0.05, 0.03)
    assert made.volume == pytest.approx(union.volume, rel=1e-12)
    assert made.area == pytest.approx(union.area, rel=1e-12)
    assert numpy.array_equal(made.simplices, rbpa.solid(points).simplices)


def test_no_balls_and_no_frames_have_no_size():
    none = rbpa.balls(numpy.zeros((0, 3)), [], 1.4)
    assert none.volume == 0 and none.areas.shape == (0,) and none.contacts.balls.shape == (0, 2) and none.simplices.shape == (0, 4)
    empty = rbpa.balls(numpy.zeros((0, 5, 3)), 1.0)
    assert empty.volume.shape == (0,) and empty.areas.shape == (0, 5) and empty.contacts == [] and empty.simplices == []


def test_gradients_are_differences():
    points, radii = some(2, 30)
    made = rbpa.balls(points, radii + 0.1)
    for i, k in ((0, 0), (7, 1), (29, 2)):
        moved = [points.copy(), points.copy()]
        moved[0][i, k] -= 1e-6
        moved[1][i, k] += 1e-6
        low, high = (rbpa.balls(p, radii + 0.1) for p in moved)
        assert made.volume_gradient[i, k] == pytest.approx((high.volume - low.volume) / 2e-6, abs=1e-7)
        assert made.area_gradient[i, k] == pytest.approx((high.area - low.area) / 2e-6, abs=1e-6)
    assert abs(made.volume_gradient.sum(axis=0)).max() < 1e-12


@pytest.mark.parametrize("threads", [1, 2, None])
def test_frames_have_the_sizes_that_each_has_alone(threads):
    centers, radii = some(3, 9, 60)
    each = [rbpa.balls(c, r, 0.05) for c, r in zip(centers, radii)]
    for made in (rbpa.balls(centers, radii, 0.05, threads=threads), rbpa.balls(iter(centers), radii, 0.05, threads=threads)):
        assert made.volume.tolist() == [one.volume for one in each]
        assert made.areas.shape == (9, 60) and len(made) == 60
        for f, one in enumerate(each):
            assert numpy.array_equal(made.areas[f], one.areas) and numpy.array_equal(made.volumes[f], one.volumes)
            assert numpy.array_equal(made.hidden[f], one.hidden)
            assert numpy.array_equal(made.simplices[f], one.simplices)
            assert numpy.array_equal(made.contacts[f].areas, one.contacts.areas)
            assert numpy.array_equal(made.area_gradient[f], one.area_gradient)
        assert made.without_probe.area.tolist() == [one.without_probe.area for one in each]
    assert numpy.array_equal(rbpa.balls(centers, radii[0]).areas[4], rbpa.balls(centers[4], radii[0]).areas)
    assert "9 frames" in repr(made) and "volume" in repr(each[0])


def test_the_program_has_the_same_rows(program, tmp_path):
    command = [program, "balls", str(LYSOZYME), "--probe", "1.4", "-o", "a.csv", "--contacts", "c.csv", "-q"]
    subprocess.run(command, cwd=tmp_path, check=True)
    table = numpy.genfromtxt(tmp_path / "a.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    contacts = numpy.genfromtxt(tmp_path / "c.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    atoms = rbpa.molecules.read(LYSOZYME)
    made = rbpa.balls(atoms, "bondi", 1.4)
    assert numpy.array_equal(table["area"], made.areas) and numpy.array_equal(table["volume"], made.volumes)
    assert numpy.array_equal(table["radius"], made.radii)
    assert numpy.array_equal(table["name"], atoms.names) and numpy.array_equal(table["resname"], atoms.residue_names)
    assert numpy.array_equal(contacts["area"], made.contacts.areas)
    assert numpy.array_equal(contacts["point_b"], made.contacts.balls[:, 1])


def test_indices_of_atoms_are_the_points_of_the_program(program):
    where = "resseq > 5 and resname != 'XXX'"

    def rows(*options):
        command = [program, "balls", str(LYSOZYME), "--probe", "1.4", "--where", where, "-q", *options]
        return list(csv.DictReader(subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()))

    atoms = rbpa.molecules.read(LYSOZYME, where=where)
    table, voids, found = rows("-o", "-"), rows("--voids", "-"), rbpa.balls(atoms, probe=1.4).voids
    assert [int(row["point"]) for row in table] == atoms.index.tolist() and atoms.index[0] > 0
    assert [row["record"] for row in table] == atoms.records.tolist()
    assert [[int(i) for i in row["points"].split()] for row in voids] == [atoms.index[void.balls].tolist() for void in found]
    for column, name in (("volume_between_points", "volume_between_points"), ("volume_outside_balls", "volume"), ("radius_max", "radius")):
        assert [float(row[column]) for row in voids] == pytest.approx([getattr(void, name) for void in found], rel=1e-12)


def test_atoms_are_columns_and_can_be_selected():
    atoms = rbpa.molecules.read(LYSOZYME)
    assert len(atoms) == 1001 and atoms.positions.shape == (1001, 3) and atoms.left_out["waters"] == 101
    assert set(atoms.records) == {"ATOM"} and atoms.index.tolist() == list(range(1001)) and atoms.bfactors[0] == 5.28
    wet = rbpa.molecules.read(LYSOZYME, where="record == 'HETATM'", waters=True)
    assert wet.index.tolist() == list(range(1001, 1102)) and set(wet.residue_names) == {"HOH"} and wet[3:5].index.tolist() == [1004, 1005]
    assert (atoms.elements[0], atoms.names[0], atoms.residue_names[0], atoms.residue_numbers[0], atoms.chains[0]) == ("N", "N", "LYS", 1, "A")
    assert len(rbpa.molecules.read(LYSOZYME, waters=True)) == 1102
    assert len(rbpa.molecules.read(LYSOZYME, where="name == 'CA'")) == 129
    alpha = atoms[atoms.names == "CA"]
    assert len(alpha) == 129 and set(alpha.elements) == {"C"} and alpha.positions.shape == (129, 3)
    assert numpy.asarray(atoms) is atoms.positions
    assert set(atoms.radii("protor")) == {1.42, 1.46, 1.61, 1.64, 1.76, 1.77, 1.88}
    assert numpy.array_equal(rbpa.balls(atoms).radii, atoms.radii("bondi"))
    assert "1001 atoms" in repr(atoms)
    copy = pickle.loads(pickle.dumps(rbpa.balls(atoms, probe=1.4)))
    assert copy.areas.tolist() == rbpa.balls(atoms, probe=1.4).areas.tolist()


FRAMES = "".join(f"2\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 {i} 1.{i}\nPm 1 0 0 2\n" for i in range(4))


def test_frames_of_a_file_have_an_axis_and_their_radii(tmp_path):
    path = tmp_path / "m.xyz"
    path.write_text(FRAMES)
    atoms = rbpa.molecules.read(path, models="all")
    assert atoms.positions.shape == (4, 2, 3) and atoms.frames == [1, 2, 3, 4] and len(atoms) == 2
    assert atoms.radii().tolist() == [[1.0, 2.0], [1.1, 2.0], [1.2, 2.0], [1.3, 2.0]]
    made = rbpa.balls(atoms, probe=0.5)
    assert made.area.shape == (4,)
    assert made.area[2] == rbpa.balls(rbpa.molecules.read(path, models=3), probe=0.5).area
    assert rbpa.molecules.read(path, models=[2, 4]).frames == rbpa.molecules.read(path, models="2,4").frames == [2, 4]
    assert atoms[:1].positions.shape == (4, 1, 3) and atoms[:1].radii().shape == (4, 1)
    assert atoms.radii("bondi", default=1.5).tolist() == [1.7, 1.5]
    assert atoms.radii(overrides={"pm": 1.25}).tolist() == [[1.0, 1.25], [1.1, 1.25], [1.2, 1.25], [1.3, 1.25]]
    assert atoms.radii("bondi", overrides={"pm": 1.25}).tolist() == [1.7, 1.25]
    names = FRAMES.splitlines()[1]
    path.write_text(FRAMES + f"2\n{names}\nC 0 0 0 1\nN 1 0 0 1\n")
    with pytest.raises(rbpa.InvalidInput, match=r"found element 'N' of atom 1 in frame 5, expected 'Pm', as in frame 1 \(models=5 reads"):
        rbpa.molecules.read(path, models="all")
    path.write_text(FRAMES + f"1\n{names}\nC 0 0 0 1\n")
    refuses("found 1 atom in frame 5, expected 2, as in frame 1", rbpa.molecules.read, path, models="all")


@pytest.mark.parametrize(
    "before, after, says",
    [
        ("C  12", "C  52", "found residue number 52 of atom 7 in frame 2, expected 12, as in frame 1 (models=2 reads this frame alone)"),
        ("C  12", "B  12", "found chain 'B' of atom 7 in frame 2, expected 'C'"),
        (" NA C", "KNA C", "found residue 'KNA' of atom 7 in frame 2, expected 'NA'"),
        ("NA    NA", "K     NA", "found name 'K' of atom 7 in frame 2, expected 'NA'"),
        ("      NA\n", "       K\n", "found element 'K' of atom 7 in frame 2, expected 'Na'"),
    ],
)
def test_the_first_different_atom_of_a_frame_is_named(tmp_path, before, after, says):
    atom = "HETATM    7 NA    NA C  12      16.260  23.720  18.910  1.00  0.00          NA\n"
    (tmp_path / "m.pdb").write_text(f"MODEL 1\n{atom}ENDMDL\nMODEL 2\n{atom.replace(before, after)}ENDMDL\n")
    refuses(re.escape(says), rbpa.molecules.read, tmp_path / "m.pdb", models="all")
    assert len(rbpa.molecules.read(tmp_path / "m.pdb", models=2)) == 1


def test_one_number_is_no_radius_of_atoms():
    for atoms in (Group(), Nameless(), Atoms(), Trajectory(), iter([Group()]), rbpa.molecules.read(LYSOZYME)):
        says = "radii: found 1.4 for atoms, expected 'bondi', 'protor' or one for each (probe=1.4 is the probe, np.full(n, 1.4) one"
        refuses(re.escape(says), rbpa.balls, atoms, 1.4)
    assert rbpa.balls(Group(), numpy.full(3, 1.4)).area == rbpa.balls(Group.positions, 1.4).area


class Group:
    """An AtomGroup of MDAnalysis."""

    positions = numpy.array([[0, 0, 0], [1.2, 0, 0], [9, 0, 0]], numpy.float32)
    elements = numpy.array(["C", "O", "Zn"], object)
    names = numpy.array(["CG", "OD1", "ZN"], object)
    resnames = numpy.array(["ASP", "ASP", "ZN"], object)
    residues = "a group of residues"


class Nameless:
    """An AtomGroup of a topology without elements."""

    positions, names, resnames = Group.positions, Group.names, Group.resnames

    @property
    def elements(self):
        raise AttributeError("no elements")


class Atoms:
    """Atoms of ASE."""

    def get_positions(self):
        return Group.positions

    def get_chemical_symbols(self):
        return ["C", "O", "Zn"]


class Named:
    def __init__(self, **of):
        self.__dict__.update(of)


class Trajectory:
    """A trajectory of mdtraj, in nanometers."""

    xyz = numpy.stack([Group.positions, Group.positions * 2]) / numpy.float32(10)

    def __init__(self):
        residues = [Named(name=name) for name in Group.resnames]
        kinds = [Named(symbol="C"), Named(symbol="O"), None]
        self.topology = Named(atoms=[Named(name=n, element=e, residue=r) for n, e, r in zip(Group.names, kinds, residues)])


def test_atoms_of_other_packages_have_positions_and_radii():
    expected = rbpa.balls(Group.positions.astype(float), [1.7, 1.52, 1.39], 1.4)
    for atoms in (Group(), Nameless(), Atoms()):
        made = rbpa.balls(atoms, probe=1.4)
        assert made.radii.tolist() == [1.7, 1.52, 1.39]
        assert made.areas.tolist() == expected.areas.tolist()
    assert rbpa.molecules.radii(Group(), "protor").tolist() == [1.61, 1.42, 1.39]
    made = rbpa.balls(Trajectory(), "bondi", 1.4)
    assert made.areas.shape == (2, 3)
    assert made.areas[0].tolist() == pytest.approx(expected.areas.tolist(), rel=1e-6)
    frames = (atoms for atoms in [Group(), Group()])
    assert rbpa.balls(frames, rbpa.molecules.radii(Group()), 1.4).area.tolist() == [expected.area] * 2


@pytest.mark.parametrize(
    "call, says",
    [
        (lambda: rbpa.balls([[0, 0, 0]], [1, 2]), r"radii: found an array of shape \(2,\), expected \(1,\), one for each center"),
        (lambda: rbpa.balls([[0, 0, 0]], [-1]), "radius 0: found -1 with the probe 0, expected a finite sum of at least 0"),
        (lambda: rbpa.balls(numpy.zeros((3, 2, 3)), -1), "frame 0: radius 0: found -1"),
        (lambda: rbpa.balls([[0, 0]], 1), r"centers: found an array of shape \(1, 2\)"),
        (lambda: rbpa.balls([[0, 0, math.nan]], 1), "nan"),
        (lambda: rbpa.balls([[0, 0, 0]], 1, "x"), "probe: found 'x', expected a length of at least 0"),
        (lambda: rbpa.balls([[0, 0, 0]], 1, -0.5), "probe: found -0.5, expected a length of at least 0"),
        (lambda: rbpa.balls(iter(()), [1.0]), "centers: found no frame, expected at least one"),
        (lambda: rbpa.balls([[0, 0, 0]], 1, math.inf), "finite"),
        (lambda: rbpa.balls([[0, 0, 0]]), "without elements and names, expected radii: numbers, one for each center"),
        (lambda: rbpa.balls([[0, 0, 0]], "bondi"), "without elements and names"),
        (lambda: rbpa.balls(Group(), "mine"), "mine: found no such file, expected a file of radii, 'bondi' or"),
        (lambda: rbpa.molecules.radii(Named(positions=[[0, 0, 0]], elements=["Pm"])), r"overrides=\{symbol: R\} sets its radius"),
        (lambda: rbpa.molecules.radii(Group(), overrides={"Qq": 1}), "overrides: found 'Qq', expected an element"),
        (lambda: rbpa.molecules.read(LYSOZYME, models=2), "found 1 frame, expected frame 2"),
        (lambda: rbpa.molecules.read(LYSOZYME, models="some"), "models: found 'some', expected all, numbers from 1"),
        (lambda: rbpa.molecules.read(LYSOZYME, models=[]), "models: found ''"),
        (lambda: rbpa.molecules.read(LYSOZYME, where="resname == 'XXX'"), "no atom in frame 1"),
        (lambda: rbpa.molecules.read(LYSOZYME, format="doc"), "format: found 'doc'"),
    ],
)
def test_wrong_arguments_are_named(call, says):
    refuses(says, call)


def test_a_missing_file_and_changed_centers_are_refused():
    with pytest.raises(FileNotFoundError):
        rbpa.molecules.read("no_such_file.pdb")
    centers, radii = some(4, 20)
    made = rbpa.balls(centers, radii)
    centers[0] = 7
    with pytest.raises(rbpa.InvalidInput, match="changed"):
        made.contacts
    assert not made.areas.flags.writeable


def test_progress_counts_frames_and_ends_the_run():
    centers, radii = some(5, 40, 2000)
    calls = []
    rbpa.balls(centers, radii, progress=lambda done, all: calls.append((done, all)))
    assert all(of == 40 for _, of in calls)
    with pytest.raises(rbpa.Cancelled):
        rbpa.balls(centers, radii, progress=lambda done, all: False)
    with pytest.raises(rbpa.Cancelled):  # few balls in a box take long too
        rbpa.balls(centers[:5], radii[:5], box=1, progress=lambda done, all: False)


def test_the_filtration_has_births_and_deaths_of_powers_and_roots():
    points, radii = some(5, 200)
    made = rbpa.balls(points, radii * 0.4 + 0.02, 0.01)
    f = made.filtration()
    assert numpy.isinf(f.ball_alpha).sum() + len(f.persistence(0)) <= len(points)
    born = numpy.isfinite(f.ball_alpha) & (f.ball_alpha <= 0)
    assert numpy.array_equal(numpy.flatnonzero(~born), made.hidden)
    assert f.persistence(0)[0].tolist() == [-(made.radii.max() + 0.01) ** 2, math.inf]
    assert sorted(map(tuple, f.edges[f.edge_alpha <= 0].tolist())) == list(map(tuple, made.contacts.balls.tolist()))
    assert f.betti(0)[2] == len(made.voids)
    roots = made.filtration(roots=True)
    assert numpy.allclose(numpy.sign(roots.edge_alpha) * roots.edge_alpha**2, f.edge_alpha, rtol=1e-14)
    zero = rbpa.balls(points, 0.0).filtration(roots=True)
    of_points = rbpa.solid_filtration(points)
    assert numpy.array_equal(zero.simplices, of_points.simplices) and numpy.array_equal(zero.edge_alpha, of_points.edge_alpha)
    assert all(numpy.array_equal(zero.persistence(k), of_points.persistence(k)) for k in range(3))
    assert numpy.array_equal(pickle.loads(pickle.dumps(f)).persistence(1), f.persistence(1))


def test_gudhi_has_the_same_pairs():
    gudhi = pytest.importorskip("gudhi")
    points, radii = some(6, 80)
    tree = gudhi.AlphaComplex(points=points.tolist(), weights=(radii**2).tolist(), precision="exact").create_simplex_tree()
    tree.persistence(homology_coeff_field=2, min_persistence=1e-12)
    f = rbpa.balls(points, radii).filtration()
    for dimension in range(3):
        mine = f.persistence(dimension)
        mine = mine[mine[:, 1] - mine[:, 0] > 1e-12]
        theirs = numpy.array(sorted(map(tuple, tree.persistence_intervals_in_dimension(dimension))))
        assert numpy.allclose(mine, theirs.reshape(-1, 2), rtol=1e-10, atol=1e-12)


def test_a_hollow_shell_has_one_void_that_all_line_and_a_pocket_where_a_ball_is_missing():
    cube = numpy.array([[x, y, z] for x in (0, 1, 2) for y in (0, 1, 2) for z in (0, 1, 2) if (x, y, z) != (1, 1, 1)], float)
    shell = rbpa.balls(cube, 0.75)
    (void,) = shell.voids
    assert void.center == pytest.approx((1, 1, 1)) and void.radius == pytest.approx(0.25)
    faces = [i for i, p in enumerate(cube) if (p == 1).sum() == 2]
    assert sorted(void.balls[void.areas > void.area / 12].tolist()) == faces
    assert void.balls.tolist() == list(range(26)) and void.areas.sum() == pytest.approx(void.area)
    assert void.mouths == [] and shell.pockets == [] and 0 < void.volume < void.volume_between_points
    open_ = rbpa.balls(numpy.delete(cube, faces[-1], axis=0), 0.75)
    assert open_.voids == []
    (pocket,) = open_.pockets
    (mouth,) = pocket.mouths
    assert mouth.radius == pytest.approx(0.25) and mouth.area > 0 and len(mouth.balls) == 4 and void.volume < pocket.volume
    with pytest.raises(ValueError):
        void.areas[0] = 1


def test_the_largest_pocket_of_lysozyme_is_its_active_cleft():
    atoms = rbpa.molecules.read(LYSOZYME)
    largest, *others = rbpa.balls(atoms, "bondi", 1.4).pockets
    cleft = numpy.isin(atoms.residue_numbers, [35, 52, 57, 59, 62, 63, 98, 101, 103, 107, 108])
    assert 2 * cleft[largest.balls].sum() > len(largest.balls) and {35, 52} & {*atoms.residue_numbers[largest.balls]}
    assert all(cleft[pocket.balls].sum() < cleft[largest.balls].sum() for pocket in others)


@pytest.mark.nightly
@pytest.mark.parametrize("name, ligand, others, share", [("mol3_4cup.cif", "ZYB", ["MOH"], 0.7), ("mol3_7cfn.cif", "FX0", ["CLR", "PLM"], 0.5)])
def test_a_pocket_is_the_site_of_the_ligand_that_is_left_out(name, ligand, others, share):
    if not (FURTHER / name).exists():
        pytest.skip(f"there is no {name} in {FURTHER}")
    atoms = rbpa.molecules.read(FURTHER / name)
    bound, rest = atoms.positions[atoms.residue_names == ligand], atoms[~numpy.isin(atoms.residue_names, [ligand, *others])]
    is_near = (numpy.linalg.norm(rest.positions[:, None] - bound, axis=2) < 4.5).any(axis=1)
    assert max(is_near[pocket.balls].sum() for pocket in rbpa.balls(rest, "bondi", 1.4).pockets) > share * is_near.sum()


def test_interfaces_are_what_areas_of_unions_leave():
    atoms = rbpa.molecules.read(LYSOZYME)
    half = numpy.where(atoms.residue_numbers < 60, "first", "last")
    made = rbpa.balls(atoms, "bondi", 1.4).interfaces(half)
    assert made.groups.tolist() == [["first", "last"]]
    radii = atoms.radii()
    alone = [rbpa.balls(atoms.positions[half == name], radii[half == name], 1.4) for name in ("first", "last")]
    both = rbpa.balls(atoms.positions, radii, 1.4)
    assert made.areas.sum() == pytest.approx(alone[0].area + alone[1].area - both.area, rel=1e-9)
    assert made.areas[0, 1] == pytest.approx(alone[1].area - both.areas[half == "last"].sum(), rel=1e-9)
    contacts = both.contacts
    between = half[contacts.balls[:, 0]] != half[contacts.balls[:, 1]]
    assert made.contact_areas[0] == pytest.approx(contacts.areas[between].sum(), rel=1e-9)
    assert numpy.array_equal(made.areas_alone[half == "first"], alone[0].areas)


def test_interfaces_of_frames_are_those_of_each():
    centers, radii = some(9, 3, 60)
    groups = numpy.arange(60) % 3
    for box in (None, 1):
        frames = rbpa.balls(centers, radii, 0.01, box=box).interfaces(groups)
        for f, made in enumerate(frames):
            alone = rbpa.balls(centers[f], radii[f], 0.01, box=box).interfaces(groups)
            assert all(numpy.array_equal(a, b) for a, b in zip(made, alone))
    refuses("one for each ball", rbpa.balls(centers, radii).interfaces, [1, 2])


def test_interfaces_in_a_box_are_those_with_all_images():
    made = rbpa.balls([[0.25, 0, 0], [9.75, 0, 0]], 1, box=10).interfaces(["a", "b"])
    assert made.areas.tolist() == [pytest.approx([1.5 * math.pi] * 2)]
    assert made.contact_areas.tolist() == pytest.approx([math.pi * (1 - 0.0625)])


@pytest.mark.skipif(not shutil.which("freesasa"), reason="there is no freesasa")
def test_freesasa_has_the_same_interface(tmp_path):
    lines = [line for line in LYSOZYME.read_text().splitlines(True) if line.startswith("ATOM")]
    total, radii = {}, {}
    for part, chosen in {"first": range(60), "last": range(60, 200), "both": range(200)}.items():
        path = tmp_path / f"{part}.pdb"
        path.write_text("".join(line for line in lines if int(line[22:26]) in chosen))
        call = ["freesasa", "--lee-richards", "--resolution=1000", "--format=pdb", str(path)]
        rows = [row for row in subprocess.run(call, capture_output=True, text=True, check=True).stdout.splitlines() if row.startswith("ATOM")]
        radii[part] = [float(row[54:60]) for row in rows]
        total[part] = sum(float(row[60:66]) for row in rows)
    atoms = rbpa.molecules.read(LYSOZYME)
    made = rbpa.balls(atoms.positions, radii["both"], 1.4).interfaces(atoms.residue_numbers < 60)
    assert made.areas.sum() == pytest.approx(total["first"] + total["last"] - total["both"], rel=1e-3)


@pytest.mark.skipif(not shutil.which("voronota"), reason="there is no voronota")
@pytest.mark.parametrize("probe", [0.25, 1.4])
def test_voronota_has_the_same_contacts_of_equal_balls(probe):
    centers = rbpa.molecules.read(LYSOZYME).positions
    lines = "".join(f"{x!r} {y!r} {z!r} 1.7\n" for x, y, z in centers.tolist())
    call = ["voronota", "calculate-contacts", "--probe", str(probe)]
    table = subprocess.run(call, input=lines, capture_output=True, text=True, check=True).stdout
    theirs = {(int(a), int(b)): float(area) for a, b, area in map(str.split, table.splitlines())}
    alone = [theirs.pop((i, i), 0) for i in range(len(centers))]  # the area of a ball's sphere
    made = rbpa.balls(centers, 1.7, probe)
    pairs = [tuple(pair) for pair in made.contacts.balls.tolist()]
    assert len(pairs) > 4000 and theirs.keys() <= set(pairs)
    lost = made.contacts.areas - [theirs.get(pair, 0) for pair in pairs]
    whole = made.contacts.arcs == 0
    digits = 5e-6 * made.contacts.areas  # they print six
    assert whole.sum() > 400 and (lost >= -digits).all() and (lost <= digits)[whole].all()
    assert lost.max() < 0.023  # they draw arcs as polygons, whose corners are on the arcs
    assert made.areas.tolist() == pytest.approx(alone, abs=0.18)  # they draw spheres as triangles


def test_frames_have_lists_of_voids_and_arcs_are_counted():
    chain = rbpa.balls([[[0, 0, 0], [0, 0, 1], [0, 0, 2]]], 0.75)
    assert chain.arcs.tolist() == [[1, 2, 1]]
    assert chain.voids == [[]] and chain.pockets == [[]]
    refuses(r"filtration: found 1 frames, expected one \(rbpa.balls\(centers\[i\]", chain.filtration)
    refuses(r"groups: found an array of shape \(2,\), expected \(3,\)", rbpa.balls(chain.centers[0], 0.75).interfaces, [1, 2])


def test_a_box_repeats_the_balls_with_all_images():
    centers, radii = some(11, 60)
    radii += 0.05
    made = rbpa.balls(centers, radii, box=1)
    shifts = numpy.array([(x, y, z) for x in range(-1, 2) for y in range(-1, 2) for z in range(-1, 2)], float)
    shifts = shifts[numpy.argsort(numpy.abs(shifts).sum(1), kind="stable")]  # the balls themselves first
    images = rbpa.balls((centers[None] + shifts[:, None]).reshape(-1, 3), numpy.tile(radii, 27))
    assert made.areas.tolist() == pytest.approx(images.areas[:60].tolist(), abs=1e-12)
    assert made.volume == pytest.approx(images.volumes[:60].sum(), rel=1e-12)
    moved = centers[made.contacts.balls[:, 1]] + made.contacts.offsets - centers[made.contacts.balls[:, 0]]
    assert numpy.linalg.norm(moved, axis=1).tolist() == pytest.approx(made.contacts.distances.tolist(), rel=1e-12)
    for same in ([1, 1, 1], [1, 1, 1, 90, 90, 90], numpy.eye(3)):
        assert rbpa.balls(centers, radii, box=same).area == made.area
    leaning = rbpa.balls(centers, radii, box=[[1, 0, 0], [1, 1, 0], [0, 0, 1]])  # the same lattice
    assert leaning.area == pytest.approx(made.area, rel=1e-12)
    two = rbpa.balls(numpy.stack([centers, centers]), radii, box=[[1, 1, 1], [1, 1, 2]])
    assert two.area[0] == made.area and two.area[1] > made.area and two.without_probe is two
    assert pickle.loads(pickle.dumps(made)).cells.tolist() == [numpy.eye(3).tolist()]


def test_voids_of_a_box_percolate_or_are_closed():
    (closed,) = rbpa.balls([[0, 0, 0]], [0.75], box=1).voids
    assert closed.dimension == 0 and closed.mouths == [] and closed.balls.tolist() == [0] and len(closed.simplices) == 0
    assert closed.center == pytest.approx((0.5, 0.5, 0.5)) and closed.radius == pytest.approx(0.75**0.5 - 0.75)
    frames = rbpa.balls([[[0, 0, 0]], [[0.5, 0, 0]]], [0.75], box=[[1, 1, 1], [1, 1, 2]])
    assert [[one.dimension for one in voids] for voids in frames.voids] == [[0], [2]]
    for volume, voids, size in zip(frames.volume, frames.voids, (1, 2)):
        assert volume + voids[0].volume == pytest.approx(size, rel=1e-12)
    assert [sizes.passing for sizes in frames.pore_sizes] == pytest.approx([0, 1.25**0.5 - 0.75])
    with pytest.raises(rbpa.InvalidInput, match="pore_sizes: found balls without a box"):
        rbpa.balls([[0, 0, 0]], [1]).pore_sizes


def test_what_a_box_does_not_have_is_refused():
    lattice = rbpa.balls([[0, 0, 0]], [0.75], box=1)
    for name in ("pockets", "simplices"):
        refuses("in a box that repeats", getattr, lattice, name)
    refuses("filtration: found balls in a box", lattice.filtration)
    edges = numpy.eye(3)
    three = rbpa.balls(numpy.zeros((3, 1, 3)), [0.75], box=edges[None])
    edges *= 2  # the box was copied
    assert three.area.tolist() == [lattice.area] * 3 and three.cells.tolist() == [numpy.eye(3).tolist()]
    refuses(r"expected \(1, 3, 3\), the edges of all", rbpa.balls, numpy.zeros((3, 1, 3)), [0.75], box=numpy.eye(3))


@pytest.mark.parametrize("box", [[1, 2], [0, 1, 1], [1, 1, 1, 90, 90, 180], "x", numpy.zeros((3, 3))])
def test_wrong_boxes_are_refused(box):
    with pytest.raises(rbpa.InvalidInput):
        rbpa.balls([[0, 0, 0]], [1], box=box)


def test_atoms_of_dumps_in_another_order_are_those_of_the_first_frame(tmp_path: pathlib.Path) -> None:
    def frame(step: int, rows: list[str]) -> str:
        head = f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n0 20\n0 20\n0 20\nITEM: ATOMS id type x y z\n"
        return head + "".join(row + "\n" for row in rows)

    path = tmp_path / "o.dump"
    path.write_text(frame(0, ["1 1 1 1 1", "2 1 5 5 5", "3 1 9 5 5"]) + frame(1, ["3 1 9 5 6", "1 1 1 1 2", "2 1 5 5 4"]))
    atoms = rbpa.molecules.read(path, models="all")
    assert atoms.positions[1].tolist() == [[1, 1, 2], [5, 5, 4], [9, 5, 6]] and atoms.serials.tolist() == [1, 2, 3]
    path.write_text(frame(0, ["1 1 1 1 1", "2 1 5 5 5", "3 1 9 5 5"]) + frame(1, ["4 1 9 5 6", "1 1 1 1 2", "2 1 5 5 4"]))
    assert rbpa.molecules.read(path, models="all").positions[1].tolist() == [[9, 5, 6], [1, 1, 2], [5, 5, 4]]  # other atoms


def test_radii_of_the_file_stay_unless_they_are_overridden(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "x.pqr"
    path.write_text("ATOM 1 N ALA 1 0 0 0 0.1 1.8\nATOM 2 CA ALA 1 3 0 0 0.1 2.0\nHETATM 3 NA NA 2 9 0 0 1.0 1.1\n")
    atoms = rbpa.molecules.read(path)
    assert atoms.radii().tolist() == [1.8, 2.0, 1.1]
    for given in (atoms.radii(overrides={"na": 1.0}), rbpa.molecules.radii(atoms, overrides={"Na": 1.0})):
        assert given.tolist() == [1.8, 2.0, 1.0]
    assert atoms.radii().tolist() == [1.8, 2.0, 1.1]
    assert len(atoms[1]) == 1 and atoms[1].names.tolist() == ["CA"] and atoms[-1].positions.shape == (1, 3)
    assert [one.elements.tolist() for one in atoms] == [["N"], ["C"], ["Na"]]
    refuses("overrides: found 'Qq', expected an element", atoms.radii, overrides={"Qq": 1.0})
    for choice in ("column:bfactor", "column:nonsense"):
        refuses(f"choice: found '{choice}', expected 'bondi'", rbpa.balls, atoms, choice, 1.4)
    refuses("read\\(path, radius=NAME\\)", rbpa.balls, atoms, "foo", 1.4)


def test_frames_of_atoms_are_a_list_or_an_iterator() -> None:
    atoms = rbpa.molecules.read(LYSOZYME)[:40]
    one = rbpa.balls(atoms, probe=1.4)
    for frames in ([atoms, atoms], iter([atoms, atoms]), (atoms, atoms)):
        assert rbpa.balls(frames, probe=1.4).areas.tolist() == [one.areas.tolist()] * 2


def test_a_box_in_another_unit_or_of_a_crystal_gives_a_warning() -> None:
    atoms = rbpa.molecules.read(LYSOZYME)
    assert any("space group P 43 21 2" in text for text in atoms.warnings)
    with pytest.warns(UserWarning, match="is it in their unit"):
        rbpa.balls(atoms, probe=1.4, box=5)
    pair = [[0, 0, 0], [30, 0, 0]]
    with pytest.warns(UserWarning, match=r"centers reach over 30 x 0 x 0, more than twice the box, which reaches over 14.9 x"):
        rbpa.balls(pair, 1, box=14.9)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rbpa.balls(pair, 1, box=15)
