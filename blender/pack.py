"""Makes the add-on as a zip that Blender installs from disk (Preferences › Add-ons › Install):

    python3 blender/pack.py OUT.zip [PACKAGE]

PACKAGE is a folder with the Python package hgp for the Python of that Blender, by default
build/native-release/python/hgp; without one, the add-on uses the command line. Made twice, the zip has the same bytes.
"""

from __future__ import annotations

import pathlib
import re
import runpy
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
EPOCH = (1980, 1, 1, 0, 0, 0)


def members(package: pathlib.Path) -> "list[tuple[str, bytes]]":
    backend = runpy.run_path(str(ROOT / "python/backend/hgp_build.py"))
    found = []
    for path in sorted((ROOT / "blender/hgp_uv").glob("*.py")):
        text = path.read_text(encoding="utf-8")
        if path.name == "__init__.py":
            numbers = ", ".join(backend["version"]().split("."))
            text = re.sub(r'("version": )\([\d, ]+\)', rf"\1({numbers})", text)
        found.append((f"hgp_uv/{path.name}", text.encode()))
    for name in backend["LEGAL"]:
        found.append((f"hgp_uv/{name}", (ROOT / name).read_bytes()))
    for path in sorted(package.iterdir()) if package.is_dir() else []:
        if path.suffix not in (".py", ".so", ".pyd", ".typed"):
            continue
        found.append((f"hgp_uv/bundled/hgp/{path.name}", path.read_bytes()))
        if path.suffix == ".so":
            libraries = backend["shared_libraries"](path)
            found += [(f"hgp_uv/bundled/hgp/{library.name}", library.read_bytes()) for library in libraries]
    return found


def main(out: str, package: str = str(ROOT / "build/native-release/python/hgp")) -> None:
    with zipfile.ZipFile(out, "w") as archive:
        for name, data in members(pathlib.Path(package)):
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data)


if __name__ == "__main__":
    main(*sys.argv[1:])
