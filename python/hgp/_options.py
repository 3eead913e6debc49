"""Options as JSON: the core checks names, types and bounds by the table that the command line follows as well."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, Optional

from ._errors import UsageError


def _plain(value: Any) -> Any:
    """Numbers of numpy as those of Python; anything else as it is written."""
    if type(value).__name__ in ("bool_", "bool"):
        return bool(value)
    if hasattr(value, "__index__"):
        return int(value.__index__())
    if hasattr(value, "__float__"):
        return float(value)
    return repr(value)


def flag(value: Any, name: str) -> bool:
    """An argument that is True or False, and nothing that only counts as one of them."""
    if type(value).__name__ not in ("bool_", "bool"):
        raise TypeError(f"{name} must be True or False, not {value!r}")
    return bool(value)


def seconds(value: Any, name: str) -> Optional[float]:
    """An argument that is a time, or None for no limit."""
    if value is None:
        return None
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{name} must be a number of seconds, not {value!r}")
    return float(value)


def json_of(options: Dict[str, Any]) -> str:
    """The options that are given, for optionsFromJson of the core."""
    given = {name: value for name, value in options.items() if value is not None}
    for name, value in given.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise UsageError(f"{name} must be a finite number, not {value!r}", "arguments")
    return json.dumps(given, default=_plain)
