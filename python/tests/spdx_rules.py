"""The rules of SPDX 2.3 for a document in JSON, as far as a bill of materials has the parts that they are about.

Numbers are the clauses of the specification. Licence expressions are checked against their grammar (annex D) and the
identifiers that occur here; places of packages against the rules for package URLs.
"""

from __future__ import annotations

import re
from typing import Any, Callable, Dict, Iterator, List

IDENTIFIER = r"SPDXRef-[A-Za-z0-9.-]+"
LICENCES = {"Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0", "ISC", "LGPL-2.1-or-later", "MIT", "MPL-2.0", "NCSA", "Zlib"}
EXCEPTIONS = {"GCC-exception-3.1", "LLVM-exception"}
LICENCES |= {"GPL-3.0-or-later", "GPL-3.0-only"}  # of GCC's libraries, with their exception
RELATIONS = {"DESCRIBES", "CONTAINS", "GENERATES", "DEPENDS_ON", "DEV_DEPENDENCY_OF", "STATIC_LINK", "DYNAMIC_LINK", "GENERATED_FROM"}
CHECKSUMS = {"SHA1": 40, "SHA256": 64, "SHA512": 128, "MD5": 32}
URL = r"(https?|ssh|git|git\+https)://[^\s#]+"
PURL = r"pkg:(npm|deb|github|generic)/([A-Za-z0-9._~%-]+/)*[A-Za-z0-9._~%-]+@[A-Za-z0-9._~:%-]+"


def is_licence(text: str) -> bool:
    """Whether this is NONE, NOASSERTION or an expression: identifiers joined by AND, OR and WITH, with parentheses."""
    if text in ("NONE", "NOASSERTION"):
        return True
    words = re.findall(r"[()]|[^\s()]+", text)

    def one(at: int) -> int:
        if at < len(words) and words[at] == "(":
            at = whole(at + 1)
            return at + 1 if 0 <= at < len(words) and words[at] == ")" else -1
        if at >= len(words) or words[at].rstrip("+") not in LICENCES:
            return -1
        if at + 1 < len(words) and words[at + 1] == "WITH":
            return at + 3 if at + 2 < len(words) and words[at + 2] in EXCEPTIONS else -1
        return at + 1

    def whole(at: int) -> int:
        at = one(at)
        while 0 <= at < len(words) and words[at] in ("AND", "OR"):
            at = one(at + 1)
        return at

    return whole(0) == len(words) > 0


Checks = Dict[str, Callable[[Any], bool]]


def matches(pattern: str) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, str) and re.fullmatch(pattern, value) is not None


TEXT = matches(r"(?s).+")
DOCUMENT: Checks = {
    "spdxVersion": matches(r"SPDX-2\.3"),  # 6.1
    "dataLicense": matches(r"CC0-1\.0"),  # 6.2
    "SPDXID": matches("SPDXRef-DOCUMENT"),  # 6.3
    "name": TEXT,  # 6.4
    "documentNamespace": matches(URL),  # 6.5: a URI without #
    "creationInfo": lambda value: isinstance(value, dict),
    "packages": lambda value: isinstance(value, list) and len(value) > 0,
}
CREATION: Checks = {
    "creators": lambda value: len(value) > 0 and all(map(matches("(Tool|Organization|Person): .+"), value)),  # 6.8
    "created": matches(r"\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\dZ"),  # 6.9
}
PACKAGE: Checks = {
    "name": TEXT,  # 7.1
    "SPDXID": matches(IDENTIFIER),  # 7.2
    "downloadLocation": matches(f"NONE|NOASSERTION|{URL}"),  # 7.7
}
MAYBE_OF_PACKAGE: Checks = {
    "versionInfo": TEXT,
    "filesAnalyzed": lambda value: value is False,  # 7.8: true asks for a verification code, which there is none of
    "licenseConcluded": lambda value: is_licence(value),  # 7.13
    "licenseDeclared": lambda value: is_licence(value),  # 7.15
    "copyrightText": TEXT,
    "comment": TEXT,
    "externalRefs": lambda value: all(map(is_reference, value)),  # 7.21
}
FILE: Checks = {
    "fileName": matches(r"\./[^/].*"),  # 8.1: relative
    "SPDXID": matches(IDENTIFIER),  # 8.2
    "checksums": lambda value: all(map(is_checksum, value)) and "SHA1" in {one["algorithm"] for one in value},  # 8.4
}
MAYBE_OF_FILE: Checks = {
    "licenseConcluded": lambda value: is_licence(value),
    "licenseInfoInFiles": lambda value: len(value) > 0 and all(map(is_licence, value)),
    "copyrightText": TEXT,
}


def is_checksum(value: Dict[str, str]) -> bool:
    size = CHECKSUMS.get(value.get("algorithm", ""), -1)
    return set(value) == {"algorithm", "checksumValue"} and bool(re.fullmatch(f"[0-9a-f]{{{max(size, 1)}}}", value["checksumValue"]))


def is_reference(value: Dict[str, str]) -> bool:
    is_known = (value.get("referenceCategory"), value.get("referenceType")) == ("PACKAGE-MANAGER", "purl")
    return len(value) == 3 and is_known and bool(re.fullmatch(PURL, value.get("referenceLocator", "")))


def _check(where: str, value: Dict[str, Any], needed: Checks, maybe: Checks) -> Iterator[str]:
    yield from (f"{where}: {key} is missing" for key in needed if key not in value)
    for key, one in value.items():
        if key not in needed and key not in maybe:
            yield f"{where}: {key} is unknown"
        elif not {**maybe, **needed}[key](one):
            yield f"{where}: {key} is wrong: {one!r}"


def problems(document: Dict[str, Any]) -> List[str]:
    """What breaks a rule, each with its place; empty for a valid document."""
    lists: Checks = {name: lambda value: isinstance(value, list) for name in ("files", "relationships")}
    found = list(_check("document", document, DOCUMENT, lists))
    found += _check("creationInfo", document.get("creationInfo", {}), CREATION, {})
    ids = ["SPDXRef-DOCUMENT"]
    for kind, needed, maybe in (("packages", PACKAGE, MAYBE_OF_PACKAGE), ("files", FILE, MAYBE_OF_FILE)):
        for number, one in enumerate(document.get(kind, [])):
            found += _check(f"{kind}[{number}]", one, needed, maybe)
            ids.append(one.get("SPDXID", ""))
    found += [f"{one}: used twice" for one in sorted(set(ids)) if ids.count(one) > 1]
    relations = document.get("relationships", [])
    for number, relation in enumerate(relations):  # 11
        ends = (relation.get("spdxElementId"), relation.get("relatedSpdxElement"))
        if len(relation) != 3 or relation.get("relationshipType") not in RELATIONS or not set(ends) <= set(ids):
            found.append(f"relationships[{number}]: {relation!r}")
    if not any(one["relationshipType"] == "DESCRIBES" and one["spdxElementId"] == ids[0] for one in relations):
        found.append("document: describes nothing")  # 11.1: needed where there are several packages
    return found
