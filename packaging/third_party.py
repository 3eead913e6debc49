"""What travels with hgp (packaging/components.json): its licences as text, and a bill of materials (SPDX 2.3).

    python3 packaging/third_party.py --write    makes THIRD_PARTY_LICENSES.txt and the table of THIRD_PARTY_NOTICES.md

The texts are those of Debian's copyright files and of the npm packages, as they are installed.
"""

from __future__ import annotations

import hashlib
import json
import pathlib
import re
import subprocess
import sys
import urllib.parse
from typing import Any, Dict, List, NamedTuple, Optional, Set, Tuple

ROOT = pathlib.Path(__file__).resolve().parents[1]
LICENCES = ROOT / "THIRD_PARTY_LICENSES.txt"
NOTICES = ROOT / "THIRD_PARTY_NOTICES.md"
RULE = "=" * 78
# Files that never become part of hgp, in the patterns of Debian's copyright files.
ELSEWHERE = re.compile(r"^(debian|tests?|testdata|tools|docs?|cmake|amiga|contrib|extern|unsupported|bench)/|configure$")
PARTS = {
    "native": "command line and C++ library",
    "python": "Python package, Blender add-on",
    "npm": "npm package",
    "page": "page and site",
}


class Component(NamedTuple):
    name: str
    licence: str  # SPDX expression
    source: str  # "debian:PACKAGE" or "npm:PACKAGE"
    parts: List[str]  # keys of PARTS
    use: str
    libraries: List[str] = []  # sonames
    text: str = ""  # whose licence text it is, if the package has none
    files: str = ""  # of its Debian package: patterns of the files that are used
    origin: str = ""


TABLE = json.loads((ROOT / "packaging/components.json").read_text(encoding="utf-8"))
COMPONENTS = [Component(**one) for one in TABLE["components"]]


def version(component: Component) -> str:
    kind, name = component.source.split(":")
    if kind == "npm":
        manifest = ROOT / "node_modules" / name / "package.json"
        return str(json.loads(manifest.read_text(encoding="utf-8"))["version"])
    asked = ["dpkg-query", "-W", "-f=${Version}", name]
    return subprocess.run(asked, check=True, capture_output=True, text=True).stdout


def fields(paragraph: str) -> Dict[str, str]:
    """One paragraph of a file in Debian's format: name of a field → its lines."""
    found: Dict[str, str] = {}
    name = ""
    for line in paragraph.split("\n"):
        start = re.match(r"([A-Z][\w-]*):\s*(.*)$", line)
        if start:
            name = start[1]
            found[name] = start[2]
        elif name:
            text = line[1:] if line.startswith(" ") else line
            found[name] += "\n" + ("" if text.strip() == "." else text.rstrip())
    return found


def debian_text(package: str, wanted: str) -> str:
    """The copyright lines of the files that are used, and the licences that these name.

    @param wanted  a pattern of those files; empty: all except tests, tools and packaging
    """
    whole = pathlib.Path(f"/usr/share/doc/{package}/copyright").read_text(encoding="utf-8", errors="replace")
    paragraphs = [fields(one) for one in re.split(r"\n\s*\n", whole.strip())]
    texts = {one["License"].split("\n")[0]: one["License"] for one in paragraphs if "License" in one and "Files" not in one}
    result: List[str] = []
    named: Set[str] = set()
    for one in paragraphs:
        if "Files" not in one:
            continue
        used = [name for name in one["Files"].split() if (re.search(wanted, name) if wanted else not ELSEWHERE.search(name))]
        if not used:
            continue
        title, *inline = one.get("License", "").split("\n")
        lines = "\n".join(line.strip() for line in one["Copyright"].strip().split("\n"))
        result.append(f"Files: {', '.join(used)}\nCopyright: {lines}\nLicense: {title}" + "".join(f"\n{line}" for line in inline))
        named |= {title} | {word.strip() for word in re.split(r",| and | or |/", title)}
    # Of a choice, the licence that is taken is named in components.json; none is the LGPL.
    result += [f"License: {text.strip()}" for name, text in texts.items() if name in named and not name.startswith("LGPL")]
    return "\n\n".join(result)


def npm_text(package: str) -> str:
    folder = ROOT / "node_modules" / package
    names = sorted(path for path in folder.iterdir() if re.match(r"(licen[sc]e|copying|notices?)(\.|$)", path.name.lower()))
    texts = [path.read_text(encoding="utf-8") for path in names]
    # Vite's file goes on with the works that its own build contains; none of them is part of what it makes.
    return "\n\n".join(text.split("\n# Licenses of bundled dependencies")[0].strip() for text in texts)


def licence_text(component: Component) -> str:
    """The copyright lines and the licences as the component states them."""
    kind, name = (component.text or component.source).split(":")
    return debian_text(name, component.files) if kind == "debian" else npm_text(name)


def licences() -> str:
    """THIRD_PARTY_LICENSES.txt."""
    text = "Works that are part of hgp or linked to it, with their copyright notices and licences.\n\n"
    text += "Each entry says which of these contain it: " + "; ".join(PARTS.values()) + ".\n"
    text += "The page contains the npm package, and the site the page. C library and GCC's run time are those of the system.\n"
    for component in COMPONENTS:
        parts = "; ".join(PARTS[part] for part in component.parts)
        origin = f"\nUnmodified source: {component.origin}" if component.origin else ""
        text += f"\n{RULE}\n{component.name} ({component.licence})\nIn: {parts}{origin}\n{RULE}\n\n{licence_text(component)}\n"
    for name in sorted(set(re.findall(r"/usr/share/common-licenses/([\w.-]*\w)", text))):
        common = pathlib.Path("/usr/share/common-licenses", name).read_text(encoding="utf-8")
        text += f"\n{RULE}\n/usr/share/common-licenses/{name}, which is named above\n{RULE}\n\n{common.strip()}\n"
    return "".join(f"{line.rstrip()}\n" for line in text.rstrip().split("\n"))


def notices(old: str) -> str:
    """THIRD_PARTY_NOTICES.md with a new table."""
    rows = ["| Component | Use | Licence | Part of |", "| --- | --- | --- | --- |"]
    for component in COMPONENTS:
        number = re.search(r"\d+\.\d+", version(component).split(":")[-1])
        assert number
        rows.append(f"| {component.name} {number[0]} | {component.use} | {component.licence} | {', '.join(component.parts)} |")
    return re.sub(r"(?:^\|[^\n]*\n)+", lambda _: "\n".join(rows) + "\n", old, count=1, flags=re.M)


def made() -> List[Tuple[pathlib.Path, str]]:
    return [(LICENCES, licences()), (NOTICES, notices(NOTICES.read_text(encoding="utf-8")))]


def bill(hgp_version: str, moment: str, files: List[pathlib.Path], repository: Optional[str] = None) -> Dict[str, Any]:
    """The SPDX document of a release. @param moment  ISO time of the commit"""

    def package(name: str, what: str, licence: str, comment: str, place: Optional[str]) -> Dict[str, Any]:
        return {
            "SPDXID": "SPDXRef-" + "".join(c if c.isalnum() else "-" for c in name),
            "name": name,
            "versionInfo": what,
            "downloadLocation": place or "NOASSERTION",
            "filesAnalyzed": False,
            "licenseConcluded": licence,
            "licenseDeclared": licence,
            "copyrightText": "NOASSERTION",
            "comment": comment,
        }

    def of(one: Component) -> Dict[str, Any]:
        kind, name = one.source.split(":")
        part = package(one.name, version(one), one.licence, f"{one.source}; in: {' '.join(one.parts)}", None)
        # In a package URL everything but letters, digits and -._~: is percent-encoded.
        place = urllib.parse.quote(name if kind == "npm" else f"debian/{name}")
        where = f"pkg:{kind if kind == 'npm' else 'deb'}/{place}@{urllib.parse.quote(version(one), safe=':')}"
        part["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": where}]
        return part

    parts = [of(one) for one in COMPONENTS]
    whole = package("hgp", hgp_version, "MIT", "the release", repository)
    listed = [
        {
            "SPDXID": f"SPDXRef-File-{number}",
            "fileName": f"./{file.name}",
            "checksums": [
                {"algorithm": "SHA1", "checksumValue": hashlib.sha1(file.read_bytes()).hexdigest()},
                {"algorithm": "SHA256", "checksumValue": hashlib.sha256(file.read_bytes()).hexdigest()},
            ],
            "licenseConcluded": "NOASSERTION",
            "licenseInfoInFiles": ["NOASSERTION"],
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
        "documentNamespace": f"https://spdx.org/spdxdocs/hgp-{hgp_version}-{hashlib.sha256(moment.encode()).hexdigest()[:16]}",
        "creationInfo": {"created": moment, "creators": ["Tool: packaging/release.py"]},
        "packages": [whole, *parts],
        "files": listed,
        "relationships": [
            {"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b} for a, kind, b in relations
        ],
    }


if __name__ == "__main__":
    for file, content in made():
        if sys.argv[1:] == ["--write"]:
            file.write_text(content, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != content:
            sys.exit(f"{file.name} is out of date: python3 packaging/third_party.py --write")
