"""Reading points from files."""

from __future__ import annotations

import os
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, as_number, as_numbers, file_error, in_python, shown

# Options that messages of the program name, each with the argument in Python.
_WAYS = {
    "--skip-invalid": "skip_invalid=True",
    "--vertices": "vertices=True",
    "--columns": "columns",
    "--format": "format",
    "--where": "where",
}


def read_points(
    path: Union[str, os.PathLike[str]],
    *,
    space: bool = False,
    fields: Union[Sequence[str], Mapping[str, type]] = (),
    where: Optional[str] = None,
    columns: Union[str, Sequence[Union[str, int]], None] = None,
    format: Optional[str] = None,
    skip_invalid: bool = False,
    vertices: bool = False,
    bounds: Optional[Sequence[float]] = None,
    resolution: Optional[float] = None,
) -> PointFile:
    """Reads points from a file, as the program `rbpa` does: LAS and LAZ, tables in text, PLY, OFF, .npy, GeoJSON, well-known
    text, the foreground of an image; in space also PCD, OBJ and molecules. Files compressed by gzip are decompressed.

    Parameters
    ----------
    path : path
    space : bool
        Read points in space with their normals and colors, for `surface`; otherwise points in the plane.
    fields : sequence of str, or mapping of str to float or str
        Names of fields to read with the points: "intensity" and others of LAS ("name[0]", "name[1]" of a list),
        properties of PLY and GeoJSON, fields of PCD, columns of a table with a header; for molecules serial, chain,
        resseq, icode, resname, name, element, altloc, occupancy, bfactor and charge. A column of a table has texts if
        its first value is not a number, or if a mapping requests str: ``{"plot": str}``. If a mapping requests float,
        numbers become float64.
    where : str, optional
        A condition on fields of the file that selects points: "classification == 2 and not overlap", as in ``--where``
        of the program.
    columns : str or sequence of str and int, optional
        Columns of a table: "X,Y" or ["X", "Y"], in space "X,Y,Z" or "X,Y,Z,NX,NY,NZ", each a name or a number from 1.
        By default the columns that the header names, or the first columns.
    format : str, optional
        "las", "text", ...; by default according to the ending of the path.
    skip_invalid : bool
        Leave out lines of text, records of LAS, and points with NaN, that are no points; `PointFile.warnings` counts them.
    vertices : bool
        Read the vertices of lines and polygons as points.
    bounds : sequence of 4 or 6 numbers, optional
        Read only the points in the box x0, y0, x1, y1 or x0, y0, x1, y1, z0, z1, its boundary included. Of a COPC file,
        only the nodes that meet the box are read.
    resolution : float, optional
        Read fewer points: of a COPC file, the levels down to the first whose spacing is at most this length; of any
        other file, the first point in each cell with this side.

    Raises
    ------
    InvalidInput
        A ValueError with the message of the program: an invalid file, with the line or the point; an argument that does
        not apply to the format.
    OSError
        There is no such file, or reading fails.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "trees.csv")
    >>> _ = path.write_text("name,x,y,height\\noak,0,1,20\\nelm,2,3,17\\nash,5,8,9\\n")
    >>> trees = rbpa.read_points(path, fields=["height"], where="height > 10")
    >>> trees.points.tolist(), trees.fields["height"].tolist()
    ([[0.0, 1.0], [2.0, 3.0]], [20.0, 17.0])
    """
    wanted: dict[str, Any] = dict(fields) if isinstance(fields, Mapping) else dict.fromkeys([fields] if isinstance(fields, str) else fields)
    kinds = {None: "", float: "number", int: "number", str: "text"}
    for name, kind in wanted.items():
        if kind not in kinds:
            raise InvalidInput(f"fields: found {kind!r} for {name!r}, expected float or str")
    for name in wanted:
        _require_text(name, "fields")
    named = [(name, kinds[kind]) for name, kind in wanted.items()]
    if columns is not None and not isinstance(columns, str):
        columns = _joined(columns)
    for text, option in ((where, "where"), (format, "format")):
        if text is not None:
            _require_text(text, option)
    box = None if bounds is None else as_numbers(bounds, "bounds", "x0, y0, x1, y1, or also z0, z1").ravel().tolist()
    length = None if resolution is None else as_number(resolution, "resolution", "a length above 0")
    try:
        read = _core.read_points(os.fsencode(path), space, named, where, columns, format, skip_invalid, vertices, box, length)
    except InvalidInput as error:
        # Fields are found by the same code as --where.
        raise file_error(error, path, _WAYS if where is not None else {**_WAYS, "--where": "fields"}) from None
    read["warnings"] = [in_python(text, _WAYS) for text in read["warnings"]]
    read["fields"] = dict(zip(wanted, map(_field, read["fields"])))
    return PointFile(read)


def _require_text(value: Any, name: str) -> None:
    if not isinstance(value, str):
        raise InvalidInput(f"{name}: found {shown(value)}, expected a str")


def _joined(columns: Any) -> str:
    """Returns columns as the text that the compiled part parses."""
    names = list(columns) if isinstance(columns, (list, tuple, np.ndarray)) else [columns]
    for name in names:
        if isinstance(name, (bool, np.bool_)) or not isinstance(name, (str, int, np.integer)):
            raise InvalidInput(f"columns: found {shown(name)}, expected names (str) or numbers (int) of columns")
        if isinstance(name, str) and "," in name:
            raise InvalidInput(f"columns: found {shown(name)}, expected a name without a comma (a number chooses the column)")
    return ",".join(map(str, names))


def _field(values: Any) -> Any:
    """Returns the values of a field: an array of numbers unchanged, or an array of texts from a pair (numbers,
    texts)."""
    if not isinstance(values, tuple):
        return values
    numbers, texts = values
    return np.array(texts, dtype=str)[numbers.astype(np.intp)]


class PointFile:
    """The content of a file, as returned by `read_points`. Arrays are writable. Functions that take points accept a
    PointFile as well, and use its `points`; `alpha_shape` and `surface` also keep its `fields`. `surface` and
    `surface_of` use its normals by default, `Surface.save` writes its colors, and `to_geojson` names its system.

    Attributes
    ----------
    points : float64 array of shape (n, 2), in space (n, 3)
        In the order of the file, all finite.
    normals : float64 array of shape (n, 3), or None
    colors : uint8 array of shape (n, 3), or None
        Red, green and blue.
    fields : dict of arrays of shape (n,)
        The requested fields by name, with the types of the file: integers are integers; texts are str. Coordinates are
        float64. A missing value is NaN, in a column of numbers that are then float64, or an empty text.
    crs : str, or None
        The system of the coordinates, such as "EPSG:28992", if the file names one.
    warnings : list of str
        Warnings, one sentence each: data that were left out, and guesses that may be wrong.
    """

    points: Floats
    normals: Optional[Floats]
    colors: Optional[npt.NDArray[np.uint8]]
    fields: dict[str, npt.NDArray[Any]]
    crs: Optional[str]
    warnings: list[str]

    def __init__(self, read: dict[str, Any]) -> None:
        self._selected: Optional[npt.NDArray[np.int64]] = read.pop("selected")
        self.__dict__.update(read)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        array = self.points if dtype is None else self.points.astype(dtype, copy=False)
        return array.copy() if copy and array is self.points else array

    @property
    def index(self) -> npt.NDArray[np.int64]:
        """The number of each point among all points of the file, from 0, including those that `where` or `skip_invalid`
        leaves out."""
        return np.arange(len(self.points)) if self._selected is None else self._selected

    def __repr__(self) -> str:
        beside = [name for name in ("normals", "colors") if getattr(self, name) is not None] + list(self.fields)
        what = "the plane" if self.points.shape[1] == 2 else "space"
        return f"<rbpa.PointFile of {len(self.points)} points of {what}{', with ' + ', '.join(beside) if beside else ''}>"
