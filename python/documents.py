"""Writes hgp/_documents.py, the types of the JSON documents, from docs/schema. Called by CMake.

    python3 documents.py FILE
"""

from __future__ import annotations

import json
import keyword
import pathlib
import sys
import textwrap
from typing import Any

SCHEMA = pathlib.Path(__file__).resolve().parent.parent / "docs/schema"

NAMES = {
    "hgp-error": "ErrorDocument",
    "hgp-check": "Check",
    "hgp-cones": "ConesDocument",
    "hgp-certificate": "Certificate",
    "hgp-inspect": "MeshInfo",
    "hgp-report": "Report",
}

HEAD = '''"""The JSON documents of hgp as types of dictionaries.

Made from docs/schema by python/documents.py.
"""

from __future__ import annotations

from typing import Any, Dict, List, Literal, TypedDict, Union
'''

PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}


def literal(value: Any) -> str:
    return json.dumps(value) if isinstance(value, str) else repr(value)


def title(word: str) -> str:
    return word[:1].upper() + word[1:]


def singular(name: str) -> str:
    if name.endswith("ies"):
        return name[:-3] + "y"
    return name[:-1] if name.endswith("s") and not name.endswith("ss") else name + "Item"


class Writer:
    """Classes of nested objects come before those that contain them."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.names: set[str] = set()

    def type_of(self, schema: dict[str, Any], name: str, defs: dict[str, Any]) -> str:
        if "$ref" in schema:
            ref: str = schema["$ref"]
            if not ref.startswith("#"):
                return NAMES[ref.split(".")[0]]
            key = ref.split("/")[-1]
            return self.type_of(defs[key], {"where": "Wheres", "error": "Failure", "note": "Note"}[key], defs)
        if "const" in schema:
            return f"Literal[{literal(schema['const'])}]"
        if "enum" in schema:
            return f"Literal[{', '.join(map(literal, schema['enum']))}]"
        choices = schema.get("oneOf")
        if choices is None and isinstance(schema["type"], list):
            choices = [{**schema, "type": kind} for kind in schema["type"]]
        if choices is not None:
            types = [self.type_of(choice, name, defs) for choice in choices]
            return f"Union[{', '.join(sorted(types, key=lambda kind: kind == 'None'))}]"
        if schema["type"] == "array":
            return f"List[{self.type_of(schema['items'], singular(name), defs)}]"
        if schema["type"] == "object":
            return self.object_of(schema, name, defs)
        return PLAIN[schema["type"]]

    def object_of(self, schema: dict[str, Any], name: str, defs: dict[str, Any]) -> str:
        properties = schema.get("properties")
        if not properties:
            return "Dict[str, Any]"
        if name in self.names:
            return name
        self.names.add(name)
        required = set(schema.get("required", []))
        given = {key: self.member(key, value, name, defs) for key, value in properties.items()}
        if any(keyword.iskeyword(key) for key in properties):
            return self.spelled(schema, name, defs)
        parts = [text for key, text in given.items() if key in required]
        others = [text for key, text in given.items() if key not in required]
        about = f'    """{wrapped(schema["description"], "    ", 4)}"""\n\n' if "description" in schema else ""
        if parts and others:
            self.texts.append(f"class _{name}Required(TypedDict):\n" + "\n".join(parts))
            self.texts.append(f"class {name}(_{name}Required, total=False):\n{about}" + "\n".join(others))
        else:
            total = "" if parts else ", total=False"
            self.texts.append(f"class {name}(TypedDict{total}):\n{about}" + "\n".join(parts or others))
        return name

    def spelled(self, schema: dict[str, Any], name: str, defs: dict[str, Any]) -> str:
        """The same where a key is a keyword, which no class can have as a member."""
        required = set(schema["required"])
        types = {key: self.type_of(value, name + title(key), defs) for key, value in schema["properties"].items()}

        def members(is_required: bool) -> str:
            return ", ".join(f'"{key}": {kind}' for key, kind in types.items() if (key in required) == is_required)

        self.texts.append(f'_{name}Required = TypedDict("_{name}Required", {{{members(True)}}})')
        others = "\n".join(f"    {key}: {kind}" for key, kind in types.items() if key not in required)
        self.texts.append(f"class {name}(_{name}Required, total=False):\n{others}")
        return name

    def member(self, key: str, schema: dict[str, Any], name: str, defs: dict[str, Any]) -> str:
        text = f"    {key}: {self.type_of(schema, name + title(key), defs)}"
        if "description" not in schema:
            return text
        return f"    # {wrapped(schema['description'], '    # ')}\n{text}"


def wrapped(text: str, indent: str, more: int = 0) -> str:
    return f"\n{indent}".join(textwrap.wrap(text, 100 - len(indent) - more))


def declared() -> str:
    """The text of hgp/_documents.py."""
    writer = Writer()
    for file, name in NAMES.items():
        schema = json.loads((SCHEMA / f"{file}.schema.json").read_text(encoding="utf-8"))
        writer.type_of(schema, name, schema.get("$defs", {}))
    return HEAD + "".join(f"\n\n{text}\n" for text in writer.texts)


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(declared(), encoding="utf-8")
