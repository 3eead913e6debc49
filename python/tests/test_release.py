"""What a release is made of; making all of it runs with --full."""

from __future__ import annotations

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
from typing import Any, List

import pytest
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "packaging"), str(ROOT / "python/tests")]
import release  # noqa: E402
import spdx_rules  # noqa: E402
import third_party  # noqa: E402


def test_the_version_is_in_one_place_and_the_same_in_all_manifests() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    package = json.loads((ROOT / "wasm/package/package.json").read_text(encoding="utf-8"))
    assert str(citation["version"]) == package["version"] == release.VERSION


def test_notes_are_the_section_of_the_version() -> None:
    log = "# Changelog\n\n## Unreleased\n\n- new\n\n## 0.0.9 - 2020-01-01\n\n- old\n"
    assert release.notes(log, "0.1.0") == "- new\n"
    cut = release.cut(log, "0.1.0", "2026-11-24")
    assert release.notes(cut, "0.1.0") == "- new\n" and release.notes(cut, "0.0.9") == "- old\n"
    assert release.notes(cut, "0.2.0").strip() == ""
    with pytest.raises(ValueError, match="already has"):
        release.cut(cut, "0.1.0", "2026-11-25")
    assert "Python" in release.notes((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), release.VERSION)


def test_licences_and_notices_are_what_the_script_makes_of_the_installed_components() -> None:
    for file, content in third_party.made():
        assert file.read_text(encoding="utf-8") == content, f"{file.name}: python3 packaging/third_party.py --write"


# What each licence says and no other does.
WORDS = {
    "MIT": "Permission is hereby granted, free of charge",
    "NCSA": "University of Illinois",
    "BSD-2-Clause": "Redistribution and use in source and binary forms",
    "BSD-3-Clause": "specific\\s+prior\\s+written\\s+permission",
    "BSL-1.0": "machine-executable object code",
    "Apache-2.0": "Grant of Patent License",
    "LLVM-exception": "LLVM [Ee]xception",
    "MPL-2.0": "Secondary Licenses",
    "ISC": "use, copy, modify, and(/or)? distribute",
    "Zlib": "plainly marked as such",
}


def test_licences_have_copyright_lines_and_the_texts_of_every_component() -> None:
    whole = third_party.LICENCES.read_text(encoding="utf-8")
    # Apache-2.0 is one text for all that refer to it.
    assert "END OF TERMS AND CONDITIONS" in whole[whole.index("/usr/share/common-licenses/Apache-2.0, which is named above") :]
    for component in third_party.COMPONENTS:
        part = third_party.licence_text(component)
        assert re.search(r"copyright.{0,60}\b(19|20)\d\d", part, re.I | re.S), component.name
        for licence in re.findall(r"[\w.-]+", component.licence):
            if licence not in ("AND", "OR", "WITH"):
                shared = whole if licence == "Apache-2.0" else part
                assert re.search(WORDS[licence].replace(" ", r"\s+"), shared), (component.name, licence)


def test_only_what_is_used_of_a_debian_package_is_named() -> None:
    for component in third_party.COMPONENTS:
        for line in re.findall(r"^Files: (.*)$", third_party.licence_text(component), re.M):
            assert not re.search(r"(^| )(debian|tests?|tools|third_party)/", line), component.name


def test_the_bill_of_materials_names_versions_and_checksums(tmp_path: Any) -> None:
    file = tmp_path / "hgp.tar.gz"
    file.write_bytes(b"x")
    bill = third_party.bill("0.1.0", "2026-11-24T00:00:00Z", [file])
    assert bill["spdxVersion"] == "SPDX-2.3"
    versions = {part["name"]: part["versionInfo"] for part in bill["packages"]}
    assert versions["hgp"] == "0.1.0" and versions["Eigen"].startswith("3.4") and all(versions.values())
    ids = [part["SPDXID"] for part in [*bill["packages"], *bill["files"]]]
    assert len(set(ids)) == len(ids) and all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", one) for one in ids)
    related = {relation["relatedSpdxElement"] for relation in bill["relationships"]}
    assert related == set(ids)
    sums = {one["algorithm"]: one["checksumValue"][:8] for one in bill["files"][0]["checksums"]}
    assert sums == {"SHA1": "11f6ad8e", "SHA256": "2d711642"}


def test_the_bill_of_materials_keeps_the_rules_of_spdx(tmp_path: Any) -> None:
    file = tmp_path / "hgp.tar.gz"
    file.write_bytes(b"x")
    for repository in (None, "https://example.org/a/hgp"):
        bill = third_party.bill("0.1.0", "2026-11-24T00:00:00Z", [file], repository)
        assert spdx_rules.problems(json.loads(json.dumps(bill))) == []


SPOILED = {
    "packages[1]: versionInfo": lambda bill: bill["packages"][1].update(versionInfo=""),
    "packages[2]: name is missing": lambda bill: bill["packages"][2].pop("name"),
    "packages[0]: licenseConcluded": lambda bill: bill["packages"][0].update(licenseConcluded="MIT OR"),
    "packages[0]: licenseDeclared": lambda bill: bill["packages"][0].update(licenseDeclared="Expat"),
    "packages[1]: externalRefs": lambda bill: bill["packages"][1]["externalRefs"][0].update(referenceLocator="pkg:deb/debian/x@1.5+dfsg"),
    "files[0]: fileName": lambda bill: bill["files"][0].update(fileName="/hgp.tar.gz"),
    "files[0]: checksums": lambda bill: bill["files"][0]["checksums"].pop(0),
    "creationInfo: created": lambda bill: bill["creationInfo"].update(created="2026-11-24"),
    "document: documentNamespace": lambda bill: bill.update(documentNamespace="https://spdx.org/a#b"),
    "document: describes nothing": lambda bill: bill["relationships"].pop(0),
    "relationships[1]": lambda bill: bill["relationships"][1].update(relatedSpdxElement="SPDXRef-nothing"),
    "SPDXRef-hgp: used twice": lambda bill: bill["packages"][1].update(SPDXID="SPDXRef-hgp"),
}


@pytest.mark.parametrize("problem", SPOILED)
def test_a_bill_that_breaks_a_rule_is_noticed(problem: str, tmp_path: Any) -> None:
    file = tmp_path / "hgp.tar.gz"
    file.write_bytes(b"x")
    bill = third_party.bill("0.1.0", "2026-11-24T00:00:00Z", [file])
    SPOILED[problem](bill)
    assert any(one.startswith(problem) for one in spdx_rules.problems(bill)), spdx_rules.problems(bill)


@pytest.mark.parametrize("name", ["test", "release"])
def test_workflows_are_well_formed_and_call_scripts_that_exist(name: str) -> None:
    workflow = yaml.safe_load((ROOT / f".github/workflows/{name}.yml").read_text(encoding="utf-8"))
    assert workflow["name"] == name and workflow[True]  # `on`, which YAML 1.1 takes for a truth value
    calls: List[str] = []
    for job in workflow["jobs"].values():
        assert job["runs-on"] and job["timeout-minutes"] <= 120
        for step in job["steps"]:
            assert set(step) <= {"run", "uses", "with", "env"} and ("run" in step) != ("uses" in step)
            assert re.fullmatch(r"actions/[\w-]+@v\d+", step.get("uses", "actions/x@v1"))
            calls += re.findall(r"^(?:scripts|packaging)/\S+", step.get("run", ""), re.M)
    assert calls
    for call in calls:
        assert (ROOT / call).exists(), call
        subprocess.run(["bash", "-n", str(ROOT / call)], check=True)


def use_debian_package(folder: pathlib.Path, scratch: pathlib.Path) -> None:
    (deb,) = folder.glob("*.deb")
    subprocess.run(["dpkg-deb", "-x", str(deb), str(scratch / "root")], check=True)
    program = scratch / "root/usr/bin/hgp"
    said = subprocess.run([str(program), "--version"], check=True, capture_output=True, text=True).stdout
    assert said == f"hgp {release.VERSION}\n"
    for place in ("man/man1/hgp.1", "bash-completion/completions/hgp", "zsh/vendor-completions/_hgp", "doc/hgp/LICENSE", "doc/hgp/THIRD_PARTY_LICENSES.txt"):
        assert list((scratch / "root/usr/share").glob(place + "*")), place
    fields = subprocess.run(["dpkg-deb", "-f", str(deb), "Depends"], check=True, capture_output=True, text=True).stdout
    assert "libdraco" in fields and "libc6" in fields


def use_wheel(folder: pathlib.Path, scratch: pathlib.Path) -> None:
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", str(scratch / "env")], check=True)
    (wheel,) = folder.glob("*.whl")
    subprocess.run([str(scratch / "env/bin/pip"), "install", "--quiet", "--no-index", str(wheel)], check=True)
    given = str(ROOT / "examples/meshes/pretzel.obj")
    script = f"import hgp; assert hgp.Mesh.load({given!r}).parametrize().certified; print(hgp.__file__)"
    env = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    command = [str(scratch / "env/bin/python"), "-c", script]
    said = subprocess.run(command, check=True, cwd=scratch, env=env, capture_output=True, text=True).stdout
    assert said.startswith(str(scratch / "env")), said


def use_npm_package(folder: pathlib.Path, scratch: pathlib.Path) -> None:
    project = scratch / "npm"
    project.mkdir()
    (project / "package.json").write_text('{ "private": true }')
    archive = folder / f"hgp-npm-{release.VERSION}.tgz"
    options = ["--offline", "--no-audit", "--no-fund", "--silent"]
    subprocess.run(["npm", "install", *options, str(archive)], check=True, cwd=project)
    said = subprocess.run(["npx", "--offline", "hgp", "--version"], check=True, cwd=project, capture_output=True, text=True).stdout
    assert said == f"hgp {release.VERSION}\n"
    manifest = json.loads((project / "node_modules/hgp/package.json").read_text(encoding="utf-8"))
    commit = subprocess.run(["git", "rev-parse", "HEAD"], check=True, cwd=ROOT, capture_output=True, text=True).stdout.strip()
    assert manifest["gitHead"] == commit and manifest["publishConfig"] == {"access": "public", "provenance": False}


def use_site(folder: pathlib.Path, scratch: pathlib.Path) -> None:
    with tarfile.open(folder / f"hgp-site-{release.VERSION}.tar.gz") as archive:
        archive.extractall(scratch)
    site = scratch / f"hgp-site-{release.VERSION}"
    for name in ("index.html", "app/index.html", "api/cpp/index.html", "api/js/index.html", "api/python/index.html", "sw.js"):
        assert (site / name).exists(), name


def use_release(folder: pathlib.Path, scratch: pathlib.Path) -> None:
    subprocess.run(["sha256sum", "--check", "--quiet", "SHA256SUMS"], check=True, cwd=folder)
    for use in (use_debian_package, use_wheel, use_npm_package, use_site):
        use(folder, scratch)
    # No path of this machine is in anything that was compiled.
    for program in [scratch / "root/usr/bin/hgp", *(scratch / "env").rglob("_core*.so")]:
        assert str(ROOT).encode() not in program.read_bytes(), program


@pytest.mark.full
def test_a_release_is_complete_reproducible_and_usable(tmp_path: Any) -> None:
    """Made twice, the second time from an empty build folder; unpacked and used."""
    folder = ROOT / f"build/release/hgp-{release.VERSION}"
    sums = []
    for _ in range(2):
        shutil.rmtree(release.BUILD, ignore_errors=True)
        subprocess.run([str(ROOT / "scripts/release")], check=True, cwd=ROOT)
        sums.append((folder / "SHA256SUMS").read_text())
    assert sums[0] == sums[1]
    use_release(folder, tmp_path)


def test_the_manifest_of_a_public_repository_has_what_npm_compares_with_the_attestation() -> None:
    whole = release.published({"name": "hgp", "files": []}, "abc", "https://example.org/a/hgp")
    assert whole["repository"] == {"type": "git", "url": "git+https://example.org/a/hgp.git"}
    assert whole["publishConfig"] == {"access": "public", "provenance": True}
    assert "repository" not in release.published({"name": "hgp"}, "abc", "")
