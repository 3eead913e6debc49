"""What goes wrong, as exceptions: one class for each error code of the command line."""

from __future__ import annotations

from typing import Iterable, NamedTuple, Optional, Tuple, Type


class Place(NamedTuple):
    """A place on the mesh, or in a file, that an error refers to."""

    #: "vertex", "edge", "triangle", "loop", "line" or "byte"
    kind: str
    #: number of the vertex, triangle or loop, counted from 0; line number or byte offset; of an edge, its first vertex
    id: int
    #: the second vertex of an edge
    other: Optional[int] = None


class HgpError(Exception):
    """The base class of all errors of hgp.

    Attributes:
        code: "usage", "malformed", "unsupported", "prescription", "no-map", "write-failed", "limit", "internal" or
            "cancelled", as in docs/cli.md.
        stage: the part of the work that failed, such as "read" or "prescription".
        message: the rule that was broken, the measured number, and what to do.
        places: where on the mesh or in the file; may be empty.
    """

    code = "internal"

    def __init__(self, message: str, stage: str = "", places: Iterable[Place] = ()) -> None:
        super().__init__(message)
        self.message = message
        self.stage = stage
        self.places: Tuple[Place, ...] = tuple(places)

    def __reduce__(self) -> "Tuple[Type[HgpError], Tuple[str, str, Tuple[Place, ...]]]":
        return type(self), (self.message, self.stage, self.places)


class UsageError(HgpError, ValueError):
    """Wrong or contradictory arguments."""

    code = "usage"


class MalformedError(HgpError, ValueError):
    """Bytes that are not what they claim to be, or a file that cannot be read."""

    code = "malformed"


class UnsupportedError(HgpError, ValueError):
    """Readable, but not an oriented manifold mesh that can be used."""

    code = "unsupported"


class PrescriptionError(HgpError, ValueError):
    """Cones, turnings or rotations that no map can have."""

    code = "prescription"


class NoMapError(HgpError):
    """There is no certified map, or none within the time limit."""

    code = "no-map"


class WriteError(HgpError):
    """The result could not be stored."""

    code = "write-failed"


class LimitError(HgpError):
    """Memory, or a stated limit."""

    code = "limit"


class InternalError(HgpError):
    """A bug in hgp."""

    code = "internal"


class Cancelled(HgpError):
    """The progress callback returned False."""

    code = "cancelled"


_CLASSES = {
    kind.code: kind
    for kind in (
        UsageError,
        MalformedError,
        UnsupportedError,
        PrescriptionError,
        NoMapError,
        WriteError,
        LimitError,
        InternalError,
        Cancelled,
    )
}


def error_of(
    code: str, stage: str, message: str, places: Iterable[Tuple[str, int, Optional[int]]]
) -> HgpError:
    """The exception of a failure of the core."""
    return _CLASSES[code](message, stage, [Place(*place) for place in places])
