"""Points in files."""

from __future__ import annotations

import os
from typing import Any, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats


def read_points(
    path: Union[str, os.PathLike[str]],
    *,
    space: bool = False,
    fields: Sequence[str] = (),
    where: Optional[str] = None,
    columns: Optional[str] = None,
    format: Optional[str] = None,
    skip_invalid: bool = False,
    vertices: bool = False,
) -> PointFile:
    """The points of a file, as the program `rbpa` reads them: LAS, tables in text, PLY, OFF, .npy, GeoJSON, well-known text,
    the figure of an image; in space PCD and OBJ as well. Files packed by gzip are unpacked.

    Parameters
    ----------
    path : path
    space : bool
        Points of space with their normals and colours, for `surface`; else of the plane, for all others.
    fields : sequence of str
        Names of numbers beside the points that are wanted too: "intensity" and others of LAS, properties of PLY, fields of
        PCD, columns of a table with a header.
    where : str, optional
        Which points count, by such numbers: "classification == 2 and not overlap", as in ``--where`` of the program.
    columns : str, optional
        Of a table: "X,Y", in space "X,Y,Z" or "X,Y,Z,NX,NY,NZ", each a name or a number from 1. By default what the header
        names, else the first.
    format : str, optional
        "las", "text", ...; by default what the ending of the path says.
    skip_invalid : bool
        Leaves out lines of text, and records of LAS, that are no point; `PointFile.remarks` counts them.
    vertices : bool
        Takes the vertices of lines and polygons as points.

    Returns
    -------
    PointFile

    Raises
    ------
    InvalidInput
        A ValueError with the sentence of the program: a file that is not what it should be, naming the line or the point; an
        argument that is not about this format.
    OSError
        There is no such file, or reading breaks off.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "trees.csv")
    >>> _ = path.write_text("name,x,y,height\\noak,0,1,20\\nelm,2,3,17\\nash,5,8,9\\n")
    >>> trees = rbpa.read_points(path, fields=["height"], where="height > 10")
    >>> trees.points.tolist(), trees.fields["height"].tolist()
    ([[0.0, 1.0], [2.0, 3.0]], [20.0, 17.0])
    """
    names = list(dict.fromkeys([fields] if isinstance(fields, str) else fields))
    try:
        read = _core.read_points(os.fsencode(path), space, names, where, columns, format, skip_invalid, vertices)
    except InvalidInput as error:
        if not os.path.exists(path):
            raise FileNotFoundError(str(error)) from None
        if where is None:  # fields are looked for in the same way
            raise InvalidInput(str(error).replace("--where", "fields")) from None
        raise
    read["fields"] = dict(zip(names, read["fields"]))
    return PointFile(read)


class PointFile:
    """What a file has: what `read_points` returns. Arrays are yours to write into.

    Attributes
    ----------
    points : float64 array of shape (n, 2), in space (n, 3)
        In the order of the file, all finite.
    normals : float64 array of shape (n, 3), or None
    colors : uint8 array of shape (n, 3), or None
        Red, green and blue.
    fields : dict of float64 arrays of shape (n,)
        By the requested names.
    crs : str, or None
        The system of the coordinates, such as "EPSG:28992", where the file names one.
    remarks : list of str
        What was left out, or might be meant otherwise: a sentence each.
    """

    points: Floats
    normals: Optional[Floats]
    colors: Optional[npt.NDArray[np.uint8]]
    fields: dict[str, Floats]
    crs: Optional[str]
    remarks: list[str]

    def __init__(self, read: dict[str, Any]) -> None:
        self.__dict__.update(read)

    def __repr__(self) -> str:
        beside = [name for name in ("normals", "colors") if getattr(self, name) is not None] + list(self.fields)
        what = "the plane" if self.points.shape[1] == 2 else "space"
        return f"<rbpa.PointFile of {len(self.points)} points of {what}{', with ' + ', '.join(beside) if beside else ''}>"
