"""Concave hulls by GEOS' C API, which the Shapely of Debian 12 does not offer."""

from __future__ import annotations

import ctypes
import ctypes.util
from typing import Any

import numpy as np
import pytest


def library() -> Any:
    name = ctypes.util.find_library("geos_c")
    if name is None or not hasattr(ctypes.CDLL(name), "GEOSConcaveHull_r"):
        pytest.skip("there is no GEOS 3.11 or later")
    geos = ctypes.CDLL(name)
    pointer, handle = ctypes.c_void_p, [ctypes.c_void_p]
    signatures = {
        "GEOS_init_r": ([], pointer),
        "GEOSCoordSeq_copyFromBuffer_r": (handle + [pointer, ctypes.c_uint, ctypes.c_int, ctypes.c_int], pointer),
        "GEOSGeom_createLineString_r": (handle + [pointer], pointer),
        "GEOSConcaveHull_r": (handle + [pointer, ctypes.c_double, ctypes.c_uint], pointer),
        "GEOSGeomToWKB_buf_r": (handle + [pointer, ctypes.POINTER(ctypes.c_size_t)], pointer),
        "GEOSFree_r": (handle + [pointer], None),
        "GEOSGeom_destroy_r": (handle + [pointer], None),
        "GEOS_finish_r": (handle, None),
    }
    for function, (arguments, result) in signatures.items():
        getattr(geos, function).argtypes, getattr(geos, function).restype = arguments, result
    return geos


class Hulls:
    """Points in GEOS' own memory, and their hulls, so that only the hull is timed."""

    def __init__(self, points: np.ndarray) -> None:
        self.geos = library()
        self.context = self.geos.GEOS_init_r()
        points = np.ascontiguousarray(points, dtype=float)
        sequence = self.geos.GEOSCoordSeq_copyFromBuffer_r(self.context, points.ctypes.data, len(points), 0, 0)
        self.points = self.geos.GEOSGeom_createLineString_r(self.context, sequence)  # only its vertices matter

    def hull(self, ratio: float, allow_holes: bool) -> int:
        """Returns a geometry of GEOS, which the caller must destroy."""
        made: int = self.geos.GEOSConcaveHull_r(self.context, self.points, ratio, int(allow_holes))
        assert made
        return made

    def destroy(self, geometry: int) -> None:
        self.geos.GEOSGeom_destroy_r(self.context, geometry)

    def shapely_hull(self, ratio: float, allow_holes: bool) -> Any:
        wkb = pytest.importorskip("shapely.wkb")
        hull, size = self.hull(ratio, allow_holes), ctypes.c_size_t()
        text = self.geos.GEOSGeomToWKB_buf_r(self.context, hull, ctypes.byref(size))
        read = wkb.loads(ctypes.string_at(text, size.value))
        self.geos.GEOSFree_r(self.context, text)
        self.destroy(hull)
        return read
