"""Atoms of molecules: read from files with their names and frames, and radii by element.

    >>> import pathlib, tempfile, rbpa
    >>> path = pathlib.Path(tempfile.mkdtemp(), "water.xyz")
    >>> _ = path.write_text("3\\nwater\\nO 0 0 0\\nH 0.76 0.59 0\\nH -0.76 0.59 0\\n")
    >>> atoms = rbpa.molecules.read(path)
    >>> atoms.elements.tolist(), atoms.radii().tolist()
    (['O', 'H', 'H'], [1.52, 1.2, 1.2])
    >>> round(rbpa.balls(atoms, probe=1.4).area, 3)
    121.767
"""

from __future__ import annotations

import copy
import os
from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, as_number, file_error, in_python, shown
from rbpa._read_points import _field

__all__ = ["Atoms", "positions_of", "radii", "read"]

Texts = npt.NDArray[np.str_]

# Options that messages of the program suggest, each with the argument that replaces the option in Python.
_WAYS = {
    "--radii FILE names its radius, --radius-default R is for all without one": "overrides={symbol: R} sets its radius, default=R that of all without one",
    "--radii column:NAME, or --radius-default R": "default=R",
    ", or bondi, protor or column:NAME": ", 'bondi' or 'protor' (read(path, radius=NAME) takes the radii of a column)",
    "--no-hydrogens": "hydrogens=False",
    "--waters reads": "waters=True reads",
    "--radii": "radius",
    "--where": "where",
}


def read(
    path: Union[str, os.PathLike[str]],
    *,
    models: Union[int, Sequence[int], str] = 1,
    where: Optional[str] = None,
    waters: bool = False,
    ligands: bool = True,
    hydrogens: bool = True,
    alternates: bool = False,
    radius: Optional[str] = None,
    format: Optional[str] = None,
) -> Atoms:
    """Reads the atoms of a molecule: PDB, PDBx/mmCIF, PQR, .gro, .xyz, dumps of LAMMPS; or other points in space.

    Parameters
    ----------
    path : path
    models : int, sequence of int, or str
        The models, or frames, counted from 1, or "all", or "1::10" for every tenth; all must have the same atoms. Those
        of dumps may have another order. Unless this is an int, positions have a first axis for frames.
    where : str, optional
        A condition that selects atoms: "chain == 'A' and resseq < 100".
    waters, ligands, hydrogens, alternates : bool
        Whether to keep water (`where` decides about the residues of water that it names), other atoms of HETATM,
        hydrogen, all alternate locations (otherwise the one of the highest occupancy in each residue).
    radius : str, optional
        The column of radii; by default that of the file, if there is one.
    format : str, optional
        "pdb", "cif", ...; by default according to the ending of the path.

    Raises
    ------
    InvalidInput
        A ValueError with the message of the program: an invalid file, with the line; other atoms in another model.
    OSError
        There is no such file, or reading fails.
    """
    is_one = isinstance(models, (int, np.integer))
    numbers = str(models) if is_one or isinstance(models, str) else ",".join(map(str, models))  # type: ignore[arg-type]
    try:
        made = _core.read_atoms(os.fsencode(path), format, numbers, waters, ligands, hydrogens, alternates, where, radius)
    except InvalidInput as error:
        raise file_error(error, path, _WAYS) from None
    return Atoms(made, () if is_one else (len(made["frames"]),))


class Atoms:
    """Atoms, as returned by `read`, as columns: arrays of shape (n,). ``atoms[atoms.chains == "A"]`` selects some, in all
    frames.

    Attributes
    ----------
    positions : float64 array of shape (n, 3), or (frames, n, 3)
    box : float64 array of shape (3, 3), or (frames, 3, 3), or None
        The edges of the cell, as rows; None unless the file has one for each frame, which repeats along all edges.
    elements, names, residue_names, insertion_codes, chains : arrays of str
        Symbols of elements, as "Ca"; names of atoms and of their residues. What the file does not have is an empty text.
    records : array of str
        "ATOM" or "HETATM", of PDB, PQR and mmCIF.
    residue_numbers, serials, occupancies, bfactors, charges : float64 arrays
        NaN where the file has none.
    index : int64 array
        The number of each atom among all of its frame in the file, from 0, those that are left out included: `point` in
        files of the program.
    frames : list of int
        The numbers of the models, from 1.
    left_out : dict of int
        The numbers of atoms of the first frame that were left out, by reason.
    warnings : list of str
    """

    positions: Floats
    box: Optional[Floats]
    elements: Texts
    names: Texts
    residue_names: Texts
    insertion_codes: Texts
    chains: Texts
    records: Texts
    residue_numbers: Floats
    serials: Floats
    occupancies: Floats
    bfactors: Floats
    charges: Floats
    index: npt.NDArray[np.int64]
    frames: list[int]
    left_out: dict[str, int]
    warnings: list[str]

    def __init__(self, made: dict[str, Any], frames: tuple[int, ...]) -> None:
        self._columns = {name: _field(values) for name, values in made.pop("columns").items()}
        shape = (*frames, len(self._columns["names"]))
        radii, positions, box = made.pop("radii"), made.pop("positions"), made.pop("box")
        self.box = None if box is None else box.reshape(*frames, 3, 3)
        self._radii: Optional[Floats] = None if radii is None else radii.reshape(shape)
        self.__dict__.update(made, positions=positions.reshape(*shape, 3), **self._columns)

    def radii(self, choice: Optional[str] = None, *, default: Optional[float] = None, overrides: Optional[Mapping[str, float]] = None) -> Floats:
        """Returns the radius of each atom, as `molecules.radii` does; without a choice those of the file, if it has
        some."""
        if choice is not None or self._radii is None:
            return radii(self, choice or "bondi", default=default, overrides=overrides)
        if not overrides:
            return self._radii
        table = _table_of(overrides)
        _core.atom_radii([], "bondi", None, table)  # refuses unknown elements
        found = self._radii.copy()
        for element, radius in table.items():
            found[..., np.char.lower(self.elements) == element.lower()] = radius
        return found

    def __getitem__(self, chosen: Any) -> Atoms:
        if isinstance(chosen, (int, np.integer)):
            chosen = [chosen]
        some = copy.copy(self)
        some._columns = {name: values[chosen] for name, values in self._columns.items()}
        some._radii = None if self._radii is None else self._radii[..., chosen]
        some.__dict__.update(some._columns, positions=self.positions[..., chosen, :])
        return some

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        return np.array(self.positions, dtype) if copy else np.asarray(self.positions, dtype)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        frames = f" in {len(self.positions)} frames" if self.positions.ndim == 3 else ""
        return f"<rbpa.molecules.Atoms: {len(self)} atoms{frames}>"


def _table_of(overrides: Mapping[str, float]) -> dict[str, float]:
    return {str(element): as_number(radius, "overrides", "numbers of at least 0") for element, radius in overrides.items()}


def _member(atoms: Any, *names: str) -> Any:
    """Returns the first named member that the object has, or its result if it is a method; None if there is no
    member."""
    found = next((getattr(atoms, name) for name in names if hasattr(atoms, name)), None)
    return found() if callable(found) else found


def _is_mdtraj(atoms: Any) -> bool:
    return hasattr(atoms, "xyz") and hasattr(atoms, "topology")


def positions_of(atoms: Any) -> Any:
    """Returns the positions of an object with atoms, in angstroms: `positions`, `get_positions()`, or mdtraj's `xyz`,
    which is in nanometers; any other object unchanged."""
    if _is_mdtraj(atoms):
        return np.multiply(atoms.xyz, 10.0, dtype=float)
    found = _member(atoms, "positions", "get_positions")
    return atoms if found is None else found


def are_atoms(centers: Any) -> bool:
    """Returns whether an object has elements or names of atoms."""
    return _is_mdtraj(centers) or any(hasattr(centers, name) for name in ("elements", "get_chemical_symbols", "names"))


def _kinds(atoms: Any) -> list[tuple[str, str, str]]:
    """Returns element, residue and name of each atom, an empty text for what the object does not have."""
    if _is_mdtraj(atoms):
        rows = [(atom.element.symbol if atom.element else "", atom.residue.name, atom.name) for atom in atoms.topology.atoms]
    else:
        columns = [_member(atoms, "elements", "get_chemical_symbols"), _member(atoms, "residue_names", "resnames"), _member(atoms, "names")]
        if columns[0] is None and columns[2] is None:
            raise InvalidInput(f"radii: found {shown(atoms)} without elements and names, expected radii: numbers, one for each center")
        count = max(len(column) for column in columns if column is not None)
        rows = list(zip(*([""] * count if column is None else column for column in columns)))
    return [(str(element), str(residue), str(name)) for element, residue, name in rows]


def radii(
    atoms: Any, choice: Optional[str] = None, *, default: Optional[float] = None, overrides: Optional[Mapping[str, float]] = None
) -> Floats:
    """Returns the radius of each atom, in angstroms: a float64 array of shape (n,).

    Parameters
    ----------
    atoms : Atoms, or an object of another package
        One that has `elements` or `get_chemical_symbols()`, perhaps `names` and `resnames` (MDAnalysis, ASE), or
        mdtraj's `topology`. Where there is no element, the name decides.
    choice : "bondi", "protor", or path, optional
        Radii of Bondi (1964), Mantina et al. (2009) and Alvarez (2013); for amino acids those of Tsai et al. (1999),
        which include hydrogens; or a file of radii as for ``rbpa balls --radii``. By default those of the file, else "bondi".
    default : float, optional
        The radius of atoms that have none; otherwise the first of them is refused with InvalidInput.
    overrides : mapping from symbols to radii, optional
        Radii of elements, in place of those of `choice`.

    Examples
    --------
    >>> class Salt:
    ...     elements = ["Na", "Cl"]
    >>> rbpa.molecules.radii(Salt(), overrides={"Na": 1.02}).tolist()
    [1.02, 1.75]
    """
    if choice is None and isinstance(atoms, Atoms):
        return atoms.radii(default=default, overrides=overrides)
    otherwise = None if default is None else as_number(default, "default", "a number of at least 0")
    if choice is not None and str(choice).startswith("column:"):
        raise InvalidInput(f"choice: found {shown(choice)}, expected 'bondi', 'protor' or a file of radii (read(path, radius=NAME) takes the radii of a column)")
    table = _table_of(overrides or {})
    first: dict[tuple[str, str, str], int] = {}
    kinds = _kinds(atoms)
    for i, kind in enumerate(kinds):
        first.setdefault(kind, i)
    try:
        found = _core.atom_radii([(*kind, i) for kind, i in first.items()], str(choice or "bondi"), otherwise, table)
    except InvalidInput as error:
        raise InvalidInput(in_python(str(error), _WAYS)) from None
    radius_of = dict(zip(first, found))
    return np.array([radius_of[kind] for kind in kinds], float)
