"""What travels with hgp: a table of components, their licences as text, and a bill of materials (SPDX 2.3)."""

from __future__ import annotations

import hashlib
import json
import pathlib
import subprocess
from typing import Any, Dict, List, NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[1]


class Component(NamedTuple):
    name: str
    licence: str  # SPDX expression
    source: str  # "debian:PACKAGE" or "npm:PACKAGE"
    parts: str  # the artefacts that contain it


COMPONENTS = [
    Component("Eigen", "MPL-2.0", "debian:libeigen3-dev", "deb wheel addon npm"),
    Component("nlohmann/json", "MIT", "debian:nlohmann-json3-dev", "deb wheel addon npm"),
    Component("fast_float", "MIT OR Apache-2.0", "debian:libfast-float-dev", "deb wheel addon npm"),
    Component("tinygltf", "MIT", "debian:libtinygltf-dev", "deb wheel addon npm"),
    Component("CLI11", "BSD-3-Clause", "debian:libcli11-dev", "deb wheel addon npm"),
    Component("pybind11", "BSD-3-Clause", "debian:pybind11-dev", "wheel addon"),
    Component("draco", "Apache-2.0", "debian:libdraco-dev", "wheel addon"),
    Component("meshoptimizer", "MIT", "debian:libmeshoptimizer-dev", "wheel addon"),
    Component("Emscripten run time, musl, libc++", "MIT OR NCSA", "debian:emscripten", "npm"),
    Component("draco3dgltf", "Apache-2.0", "npm:draco3dgltf", "npm"),
    Component("meshoptimizer (decoder)", "MIT", "npm:meshoptimizer", "npm"),
    Component("fflate", "MIT", "npm:fflate", "npm"),
]


def version(component: Component) -> str:
    kind, name = component.source.split(":")
    if kind == "npm":
        manifest = ROOT / "node_modules" / name / "package.json"
        return str(json.loads(manifest.read_text(encoding="utf-8"))["version"])
    asked = ["dpkg-query", "-W", "-f=${Version}", name]
    return subprocess.run(asked, check=True, capture_output=True, text=True).stdout


def licence_text(component: Component) -> str:
    """The copyright lines and the licence as the component states them."""
    kind, name = component.source.split(":")
    if kind == "debian":
        return pathlib.Path(f"/usr/share/doc/{name}/copyright").read_text(encoding="utf-8", errors="replace")
    folder = ROOT / "node_modules" / name
    found = sorted(path for path in folder.iterdir() if path.name.lower().startswith(("licen", "copying")))
    if found:
        return found[0].read_text(encoding="utf-8")
    # These packages only name their licence; Debian has the text of the same project.
    return pathlib.Path(f"/usr/share/doc/{STAND_INS[name]}/copyright").read_text(encoding="utf-8")


STAND_INS = {"draco3dgltf": "libdraco-dev", "meshoptimizer": "libmeshoptimizer-dev"}


def licences() -> str:
    """THIRD_PARTY_LICENSES.txt."""
    text = "The works that are part of hgp's releases, with their copyright notices and licences.\n"
    for component in COMPONENTS:
        line = "=" * 78
        text += f"\n{line}\n{component.name} ({component.licence}); in: {component.parts}\n{line}\n\n"
        text += licence_text(component).strip() + "\n"
    return text


def bill(hgp_version: str, epoch: str, files: List[pathlib.Path]) -> Dict[str, Any]:
    """The SPDX document of a release. @param epoch  ISO time of the commit"""

    def package(name: str, what: str, licence: str, comment: str) -> Dict[str, Any]:
        return {
            "SPDXID": "SPDXRef-" + "".join(c if c.isalnum() else "-" for c in name),
            "name": name,
            "versionInfo": what,
            "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False,
            "licenseConcluded": licence,
            "licenseDeclared": licence,
            "copyrightText": "NOASSERTION",
            "comment": comment,
        }

    parts = [package(c.name, version(c), c.licence, f"{c.source}; in: {c.parts}") for c in COMPONENTS]
    whole = package("hgp", hgp_version, "MIT", "the release")
    listed = [
        {
            "SPDXID": f"SPDXRef-File-{number}",
            "fileName": f"./{file.name}",
            "checksums": [{"algorithm": "SHA256", "checksumValue": hashlib.sha256(file.read_bytes()).hexdigest()}],
            "licenseConcluded": "NOASSERTION",
            "copyrightText": "NOASSERTION",
        }
        for number, file in enumerate(files)
    ]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", "SPDXRef-hgp")]
    relations += [("SPDXRef-hgp", "CONTAINS", str(part["SPDXID"])) for part in parts]
    relations += [("SPDXRef-hgp", "GENERATES", str(file["SPDXID"])) for file in listed]
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"hgp-{hgp_version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/hgp-{hgp_version}-{hashlib.sha256(epoch.encode()).hexdigest()[:16]}",
        "creationInfo": {"created": epoch, "creators": ["Tool: packaging/release.py"]},
        "packages": [whole, *parts],
        "files": listed,
        "relationships": [
            {"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b} for a, kind, b in relations
        ],
    }
