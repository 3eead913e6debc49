"""Annotations are complete and strict."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys

import hgp

HERE = pathlib.Path(__file__).parent
PACKAGE = pathlib.Path(hgp.__file__).parent


def mypy(*paths: pathlib.Path) -> str:
    command = ["/usr/bin/mypy", "--strict", "--show-error-codes", "--no-error-summary", "--warn-unreachable"]
    command += ["--python-executable", sys.executable, "--cache-dir", str(PACKAGE.parent / ".mypy_cache")]
    env = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
    ran = subprocess.run([*command, *map(str, paths)], capture_output=True, text=True, env=env, cwd=HERE.parents[1])
    return ran.stdout + ran.stderr


def test_the_package_and_its_use_pass_mypy_strict() -> None:
    """And misuse does not: every line marked so has its error, and no other line has one."""
    found = [
        (path, int(line), code)
        for path, line, code in re.findall(r"^(.*?):(\d+): error: .*\[([\w-]+)\]$", mypy(PACKAGE, HERE / "typed.py"), re.M)
    ]
    lines = (HERE / "typed.py").read_text(encoding="utf-8").splitlines()
    expected = [(n + 1, line.rsplit("# wrong: ", 1)[1]) for n, line in enumerate(lines) if "# wrong: " in line]
    assert [(line, code) for path, line, code in found if path.endswith("tests/typed.py")] == expected
    assert [one for one in found if not one[0].endswith("tests/typed.py")] == []


def test_everything_public_has_a_docstring() -> None:
    for name in hgp.__all__:
        thing = getattr(hgp, name)
        assert (thing.__doc__ or "").strip(), name
        if not isinstance(thing, type) or issubclass(thing, (dict, tuple)):
            continue
        for member, value in vars(thing).items():
            if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                assert (getattr(thing, member).__doc__ or getattr(value, "__doc__", "") or "").strip(), f"{name}.{member}"


def test_the_compiled_part_has_what_its_stub_declares() -> None:
    stub = (PACKAGE / "_core.pyi").read_text(encoding="utf-8")
    for name, body in re.findall(r"^class (\w+):\n((?:    .*\n|\n)+)", stub, re.M):
        declared = set(re.findall(r"^    (?:def )?(\w+)[:(]", body, re.M))
        actual = {member for member in vars(getattr(hgp._core, name)) if not member.startswith("_")}
        assert actual == declared, name
