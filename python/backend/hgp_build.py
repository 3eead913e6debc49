"""Builds wheels of hgp with CMake, using the standard library alone (PEP 517).

Settings, as `pip install . --config-settings NAME=VALUE`:
    builddir   the build folder; by default build/wheel. One that exists is used as it is configured.
    jobs       how many files are compiled at a time
    cmake      further arguments of CMake

The environment variable HGP_BUILD_DIR does the same as builddir.
"""

from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from typing import Any, Dict, List, Optional, Tuple

try:
    import tomllib
except ModuleNotFoundError:  # Python below 3.11
    tomllib = None  # type: ignore[assignment]

ROOT = pathlib.Path(__file__).resolve().parents[2]
Settings = Optional[Dict[str, Any]]
EPOCH = (1980, 1, 1, 0, 0, 0)  # the oldest time in a zip: wheels do not depend on when they were built


def version() -> str:
    """The version in CMakeLists.txt, the only place that states it."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"project\(hgp VERSION ([\d.]+)", text)
    assert found, "CMakeLists.txt has no version"
    return found[1]


def project() -> Dict[str, Any]:
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    if tomllib is not None:
        return dict(tomllib.loads(text)["project"])
    # The few forms that this file has.
    found: Dict[str, Any] = {}
    for name, value in re.findall(r'^([\w-]+) = (".*"|\[.*\])$', text, re.M):
        found[name] = eval(value)  # noqa: S307 - a string or a list of strings of our own file
    return {**found, "optional-dependencies": {"batch": found["batch"]}, "scripts": {name: found[name] for name in ("hgp", "hgp-batch")}}


def metadata() -> str:
    about = project()
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {about['name']}",
        f"Version: {version()}",
        f"Summary: {about['description']}",
        f"License: {about['license']}",
        f"Keywords: {','.join(about['keywords'])}",
        f"Requires-Python: {about['requires-python']}",
        "Classifier: License :: OSI Approved :: MIT License",
        "Classifier: Programming Language :: Python :: 3",
        "Classifier: Topic :: Multimedia :: Graphics :: 3D Modeling",
        "Classifier: Typing :: Typed",
    ]
    lines += [f"Requires-Dist: {name}" for name in about["dependencies"]]
    for extra, names in about["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {name}; extra == "{extra}"' for name in names)]
    lines += ["Description-Content-Type: text/markdown", ""]
    return "\n".join(lines) + "\n" + (ROOT / about["readme"]).read_text(encoding="utf-8")


def scripts() -> str:
    return "[console_scripts]\n" + "".join(f"{name} = {what}\n" for name, what in project()["scripts"].items())


def tag() -> str:
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{re.sub(r'[-.]', '_', sysconfig.get_platform())}"


def run(*command: str) -> None:
    """Runs a tool of the system; pip puts the Python of its build environment first on the PATH."""
    print("+", shlex.join(command), flush=True)
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONNOUSERSITE")}
    subprocess.run(command, check=True, cwd=ROOT, env=environment)


def built(settings: Settings) -> pathlib.Path:
    """The folder of the package, built."""
    asked = dict(settings or {})
    if "HGP_BUILD_DIR" in os.environ:
        asked.setdefault("builddir", os.environ["HGP_BUILD_DIR"])
    folder = ROOT / asked.get("builddir", "build/wheel")
    jobs = str(asked.get("jobs", os.cpu_count() or 1))
    if not (folder / "CMakeCache.txt").exists() or "builddir" not in asked:
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        run(
            *["cmake", "-S", str(ROOT), "-B", str(folder), *generator, "-DCMAKE_BUILD_TYPE=Release"],
            *["-DHGP_PYTHON=ON", "-DHGP_TESTS=OFF", "-DHGP_BENCH=OFF", "-DHGP_EXAMPLES=OFF", "-DCMAKE_UNITY_BUILD=ON"],
            *["-DCMAKE_UNITY_BUILD_BATCH_SIZE=80", f"-DPython_EXECUTABLE={sys.executable}"],
            *shlex.split(asked.get("cmake", "")),
        )
    run("cmake", "--build", str(folder), "--target", "hgp_python", "-j", jobs)
    return folder / "python/hgp"


def shared_libraries(module: pathlib.Path) -> List[pathlib.Path]:
    """Libraries of the system that travel with the module; it looks for them beside itself first."""
    if sys.platform != "linux":
        return []
    listed = subprocess.run(["ldd", str(module)], check=True, capture_output=True, text=True).stdout
    return [
        pathlib.Path(path) for name, path in re.findall(r"(\S+) => (/\S+)", listed) if re.match("libdraco|libmeshopt", name)
    ]


LEGAL = ("LICENSE", "THIRD_PARTY_NOTICES.md", "THIRD_PARTY_LICENSES.txt")


def members(settings: Settings) -> List[Tuple[str, bytes]]:
    package = built(settings)
    files = sorted(path for path in package.iterdir() if path.is_file())
    found = [(f"hgp/{path.name}", path.read_bytes()) for path in files]
    for module in (path for path in files if path.suffix in (".so", ".pyd")):
        found += [(f"hgp/{path.name}", path.read_bytes()) for path in shared_libraries(module)]
    return found


def info_folder() -> str:
    return f"hgp-{version()}.dist-info"


def info_files(name: str) -> List[Tuple[str, bytes]]:
    about = f"Wheel-Version: 1.0\nGenerator: hgp_build\nRoot-Is-Purelib: false\nTag: {name}\n"
    texts = {"METADATA": metadata(), "WHEEL": about, "entry_points.txt": scripts()}
    found = [(f"{info_folder()}/{key}", text.encode()) for key, text in texts.items()]
    for licence in LEGAL:
        found.append((f"{info_folder()}/{licence}", (ROOT / licence).read_bytes()))
    return found


def write_wheel(folder: str, name: str, files: List[Tuple[str, bytes]]) -> str:
    wheel = f"hgp-{version()}-{name}.whl"
    record = ""
    for path, data in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(data)}\n"
    place = f"{info_folder()}/RECORD"
    with zipfile.ZipFile(pathlib.Path(folder) / wheel, "w") as archive:
        for path, data in [*files, (place, f"{record}{place},,\n".encode())]:
            entry = zipfile.ZipInfo(path, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            archive.writestr(entry, data)
    return wheel


# The hooks of PEP 517 and PEP 660.


def get_requires_for_build_wheel(config_settings: Settings = None) -> List[str]:
    """What the system lacks."""
    missing = []
    places = ("/usr/include/pybind11", "/usr/local/include/pybind11", "/opt/homebrew/include/pybind11")
    if not any(os.path.isdir(place) for place in places):
        missing.append("pybind11")
    if shutil.which("cmake") is None:
        missing.append("cmake")
    return missing


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: Optional[str] = None) -> str:
    return write_wheel(wheel_directory, tag(), members(config_settings) + info_files(tag()))


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings: Settings = None) -> str:
    folder = pathlib.Path(metadata_directory)
    for path, data in info_files(tag()):
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_bytes(data)
    return info_folder()


get_requires_for_build_editable = get_requires_for_build_wheel
prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_editable(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: Optional[str] = None
) -> str:
    """A wheel that refers to the build folder, whose sources are links to those of the checkout."""
    package = built(config_settings)
    path = [("hgp.pth", f"{package.parent}\n".encode())]
    return write_wheel(wheel_directory, tag(), path + info_files(tag()))


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    """All files that git tracks or would take."""
    listed = subprocess.run(["git", "ls-files", "-coz", "--exclude-standard"], check=True, cwd=ROOT, capture_output=True, text=True)
    name = f"hgp-{version()}"

    def plain(entry: tarfile.TarInfo) -> tarfile.TarInfo:
        entry.mtime = entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mode = 0o755 if entry.mode & 0o100 else 0o644
        return entry

    with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        info = pathlib.Path(sdist_directory) / "PKG-INFO"
        info.write_text(metadata(), encoding="utf-8")
        archive.add(info, f"{name}/PKG-INFO", filter=plain)
        info.unlink()
        for file in sorted(file for file in listed.stdout.split("\0") if file and (ROOT / file).exists()):
            archive.add(ROOT / file, f"{name}/{file}", recursive=False, filter=plain)
    return f"{name}.tar.gz"
