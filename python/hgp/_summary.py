"""The page of a batch: counts and one row per mesh, with pictures; a file without scripts and without other sources."""

from __future__ import annotations

import html
import urllib.parse
from typing import Any, Dict, List

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 76rem; padding: 0 1rem; color: #1d2733; }
table { border-collapse: collapse; width: 100%; } th { text-align: left; border-bottom: 2px solid #99a; }
td { border-bottom: 1px solid #dde; padding: .25rem .5rem; vertical-align: middle; }
td.n { text-align: right; font-variant-numeric: tabular-nums; } img { display: block; width: 80px; height: 80px; }
.bad { color: #a3151f; } .good { color: #14692f; } td.m { overflow-wrap: anywhere; max-width: 24rem; }
@media (prefers-color-scheme: dark) { body { background: #14181d; color: #dde3ea; } .bad { color: #ff8a8a; }
.good { color: #7fd79a; } td { border-color: #333b45; } a { color: #8ab8ff; } img { border-radius: 4px; } }
"""


def _number(value: Any, digits: int = 0) -> str:
    return "" if value is None or value == "" else f"{value:,.{digits}f}"


def _row(row: Dict[str, Any]) -> str:
    def link(key: str, text: str) -> str:
        target = row.get(key)
        return f'<a href="{html.escape(urllib.parse.quote(target))}">{text}</a>' if target else ""

    name = html.escape(row["file"]) + (f" · mesh {row['mesh']}" if row["mesh"] else "")
    picture = row.get("thumbnail")
    image = f'<img loading="lazy" alt="" src="{html.escape(urllib.parse.quote(picture))}">' if picture else ""
    verdict = '<b class="good">certified</b>' if row["certified"] else f'<b class="bad">{html.escape(row["code"])}</b>'
    numbers = [
        _number(row.get("triangles")),
        _number(row.get("cones")),
        _number(row.get("mean_mu"), 3),
        _number(row.get("rms_log_area"), 2),
        _number(row.get("seconds"), 1),
        _number(row.get("peak_memory_mb")),
    ]
    cells = "".join(f'<td class="n">{number}</td>' for number in numbers)
    links = " ".join(filter(None, [link("map", "map"), link("report", "report")]))
    note = html.escape(row["message"]) if row["message"] else links
    extra = f"<br>{links}" if row["message"] and links else ""
    return f'<tr><td>{image}</td><td class="m">{name}</td><td>{verdict}</td>{cells}<td class="m">{note}{extra}</td></tr>\n'


def summary(rows: List[Dict[str, Any]], files: int) -> str:
    """The page; what is not certified comes first."""
    certified = sum(bool(row["certified"]) for row in rows)
    codes: Dict[str, int] = {}
    for row in rows:
        if not row["certified"]:
            codes[row["code"]] = codes.get(row["code"], 0) + 1
    done = len({row["file"] for row in rows})
    cpu = sum(row.get("cpu_seconds") or 0 for row in rows)
    largest = max((row.get("peak_memory_mb") or 0 for row in rows), default=0)
    lines = [
        f"{certified:,} of {len(rows):,} meshes certified"
        + "".join(f", {count:,} {html.escape(code)}" for code, count in sorted(codes.items())),
        f"{done:,} of {files:,} files done",
        f"{cpu / 3600:.2f} hours of processor time, at most {largest:,.0f} MB",
    ]
    head = "".join(
        f"<th>{text}</th>"
        for text in ["", "file", "", "triangles", "cones", "mean μ", "log₂ area rms", "seconds", "MB", "", ]
    )
    ordered = sorted(rows, key=lambda row: bool(row["certified"]))
    return (
        '<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>hgp batch</title>'
        '<meta name="viewport" content="width=device-width">'
        f"<style>{STYLE}</style>\n<h1>hgp batch</h1>\n"
        + "".join(f"<p>{line}</p>\n" for line in lines)
        + f"<table><thead><tr>{head}</tr></thead><tbody>\n{''.join(map(_row, ordered))}</tbody></table></html>\n"
    )
