"""Makes everything of a release, into build/release/hgp-VERSION. Called by scripts/release.

    python3 packaging/release.py [--without npm,deb,wheel,addon]

The version is the one in CMakeLists.txt. Twice from the same commit, all files are equal.
"""

from __future__ import annotations

import argparse
import datetime
import gzip
import hashlib
import io
import json
import os
import pathlib
import re
import runpy
import shutil
import subprocess
import sys
import tarfile
from typing import Any, Dict, List, Set

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import third_party  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
BACKEND = runpy.run_path(str(ROOT / "python/backend/hgp_build.py"))
VERSION: str = BACKEND["version"]()
BUILD = ROOT / "build/release-build"


def run(*command: str, **options: Any) -> str:
    print("+", " ".join(command), flush=True)
    ran = subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.PIPE, text=True, **options)
    return str(ran.stdout).strip()


def notes(changelog: str, version: str) -> str:
    """The section of this version, or Unreleased, of the changelog."""
    for title in (re.escape(version), "Unreleased"):
        found = re.search(rf"^## \[?{title}\]?[^\n]*\n(.*?)(?=^## |\Z)", changelog, re.M | re.S)
        if found:
            return found[1].strip() + "\n"
    raise ValueError("the changelog has no section for a release")


def cut(changelog: str, version: str, day: str) -> str:
    """The changelog with what is unreleased as this version."""
    if re.search(rf"^## {re.escape(version)}\b", changelog, re.M):
        raise ValueError(f"the changelog already has {version}")
    return changelog.replace("## Unreleased\n", f"## Unreleased\n\n## {version} - {day}\n", 1)


def pack(place: pathlib.Path, plain: bytes) -> None:
    """Compresses, without name and time."""
    with open(place, "wb") as file:
        with gzip.GzipFile("", "wb", 9, file, mtime=0) as packed:
            packed.write(plain)


def source(out: pathlib.Path) -> None:
    """The files of the commit."""
    plain = subprocess.run(
        ["git", "archive", "--format=tar", f"--prefix=hgp-{VERSION}/", "HEAD"], check=True, cwd=ROOT, capture_output=True
    ).stdout
    pack(out / f"hgp-{VERSION}.tar.gz", plain)


def configure() -> None:
    options = ["-DHGP_TESTS=OFF", "-DHGP_BENCH=OFF", "-DHGP_EXAMPLES=OFF", "-DHGP_PYTHON=ON", "-DCMAKE_UNITY_BUILD=ON"]
    # Paths of this machine are not part of the result.
    flags = f"-ffile-prefix-map={ROOT}=."
    options += ["-DCMAKE_UNITY_BUILD_BATCH_SIZE=80", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS={flags}"]
    run("cmake", "-S", str(ROOT), "-B", str(BUILD), "-G", "Ninja", *options)
    run("cmake", "--build", str(BUILD), "-j", str(os.cpu_count() or 1))


def debian(out: pathlib.Path) -> None:
    run("cpack", "--config", str(BUILD / "CPackConfig.cmake"), "-B", str(BUILD / "packages"))
    (made,) = (BUILD / "packages").glob(f"hgp_{VERSION}_*.deb")
    shutil.copy(made, out)


def wheel(out: pathlib.Path) -> None:
    BACKEND["build_wheel"](str(out), {"builddir": str(BUILD.relative_to(ROOT))})


def addon(out: pathlib.Path) -> None:
    name = str(out / f"hgp-blender-{VERSION}.zip")
    run(sys.executable, "blender/pack.py", name, str(BUILD / "python/hgp"))


def published(manifest: Dict[str, Any], commit: str, repository: str) -> Dict[str, Any]:
    """package.json as it is published: with the commit, and with the repository that npm compares with the attestation
    of where the archive was built."""
    result = {**manifest, "gitHead": commit, "publishConfig": {"access": "public", "provenance": bool(repository)}}
    if repository:
        result = {
            **result,
            "repository": {"type": "git", "url": f"git+{repository}.git"},
            "homepage": f"{repository}#readme",
            "bugs": {"url": f"{repository}/issues"},
        }
    return result


def npm(out: pathlib.Path) -> None:
    run("cmake", "--preset", "wasm-release")
    run("cmake", "--build", "--preset", "wasm-release", "--target", "hgp_package_with_cli")
    folder = ROOT / "build/package-with-cli"
    manifest = json.loads((folder / "package.json").read_text(encoding="utf-8"))
    whole = published(manifest, os.environ["HGP_COMMIT"], os.environ.get("HGP_REPOSITORY", ""))
    (folder / "package.json").write_text(json.dumps(whole, indent=2) + "\n", encoding="utf-8")
    run("npm", "pack", "--silent", "--pack-destination", str(out), str(folder))
    (out / f"hgp-{VERSION}.tgz").rename(out / f"hgp-npm-{VERSION}.tgz")


def site(out: pathlib.Path) -> None:
    """The site as an archive, to be unpacked on any static host."""
    repository = os.environ.get("HGP_REPOSITORY", "")
    asked = ["--repository", repository] if repository else []
    run("scripts/site", *asked, env={**os.environ, "HGP_BUILD": str(BUILD.relative_to(ROOT))})
    folder = ROOT / "build/site"
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            entry = tarfile.TarInfo(f"hgp-site-{VERSION}/{path.relative_to(folder).as_posix()}")
            entry.size, entry.mode, entry.mtime = path.stat().st_size, 0o644, int(os.environ["SOURCE_DATE_EPOCH"])
            with open(path, "rb") as file:
                archive.addfile(entry, file)
    pack(out / f"hgp-site-{VERSION}.tar.gz", plain.getvalue())


def main() -> None:
    makers = {"deb": debian, "wheel": wheel, "addon": addon, "npm": npm, "site": site}
    parser = argparse.ArgumentParser("scripts/release", description="Makes everything of a release.")
    parser.add_argument("--without", default="", help="comma-separated: " + ", ".join(makers))
    parser.add_argument("--cut", action="store_true", help="only make a section of this version in CHANGELOG.md")
    parser.add_argument("--repository", default="", help="address of the public repository, for npm and the bill of materials")
    asked = parser.parse_args()
    os.environ["HGP_REPOSITORY"] = asked.repository
    if asked.cut:
        day = datetime.date.today().isoformat()
        changelog = ROOT / "CHANGELOG.md"
        changelog.write_text(cut(changelog.read_text(encoding="utf-8"), VERSION, day), encoding="utf-8")
        return
    left_out: Set[str] = set(filter(None, asked.without.split(",")))
    if left_out - set(makers):
        parser.error(f"there is no part {', '.join(sorted(left_out - set(makers)))}")
    os.environ["HGP_COMMIT"] = run("git", "rev-parse", "HEAD")
    # What tools take for the time of everything: the time of the commit.
    os.environ["SOURCE_DATE_EPOCH"] = run("git", "log", "-1", "--format=%ct")
    moment = run("git", "log", "-1", "--format=%cd", "--date=format-local:%Y-%m-%dT%H:%M:%SZ", env={**os.environ, "TZ": "UTC"})
    out = ROOT / "build/release" / f"hgp-{VERSION}"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    source(out)
    for file, content in third_party.made():
        if file.read_text(encoding="utf-8") != content:
            sys.exit(f"release: {file.name} is out of date: python3 packaging/third_party.py --write")
    if {"deb", "wheel", "addon", "site"} - left_out:
        configure()
    for name, make in makers.items():
        if name not in left_out:
            make(out)
    made: List[pathlib.Path] = sorted(out.iterdir())
    history = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    (out / "NOTES.md").write_text(f"# hgp {VERSION}\n\n{notes(history, VERSION)}", encoding="utf-8")
    shutil.copy(third_party.LICENCES, out)
    bill = third_party.bill(VERSION, moment, made, asked.repository or None)
    (out / f"hgp-{VERSION}.spdx.json").write_text(json.dumps(bill, indent=2) + "\n", encoding="utf-8")
    sums = "".join(f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in sorted(out.iterdir()))
    (out / "SHA256SUMS").write_text(sums, encoding="utf-8")
    print(sums, end="")


if __name__ == "__main__":
    main()
