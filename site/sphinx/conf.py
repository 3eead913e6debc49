"""Sphinx for the C++ and the Python reference; site/references.mjs puts what it writes into the site's own frame."""

import os
import pathlib

from sphinx.ext.napoleon.docstring import GoogleDocstring
from sphinx.pycode import ModuleAnalyzer

ROOT = pathlib.Path(__file__).resolve().parents[2]
project = "hgp"
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinxcontrib.serializinghtml"]
source_suffix = ".rst"
exclude_patterns = []
html_copy_source = False
html_show_sourcelink = False
html_permalinks_icon = "¶"
default_role = "code"
nitpicky = False

# Python: the package is on PYTHONPATH.
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
napoleon_use_rtype = False
autodoc_class_signature = "separated"


def _whole(self: GoogleDocstring) -> "list[str]":
    """Docstrings of properties are sentences; Napoleon takes what is before a colon for a type."""
    return list(self._consume_to_end())


GoogleDocstring._parse_attribute_docstring = _whole
python_use_unqualified_type_names = True
# Names as users read them, instead of what they stand for.
autodoc_type_aliases = {
    name: name
    for name in (
        "npt.ArrayLike", "ConesFor", "ConesLike", "FeaturesLike", "Fix", "Improve", "Mark", "Method", "OnProgress", "Pairs",
        "Path", "Reals", "Integers", "Weld",
    )
}  # fmt: skip


# Classes say that they are of `hgp`, and comments on their attributes are in the files where they really are.
_analyzer_of = ModuleAnalyzer.for_module.__func__  # type: ignore[attr-defined]


def _whole_package(cls: "type[ModuleAnalyzer]", name: str) -> ModuleAnalyzer:
    analyzer: ModuleAnalyzer = _analyzer_of(cls, name)
    if name == "hgp":
        analyzer.analyze()
        for path in sorted((ROOT / "python/hgp").glob("_[a-z]*.py")):
            part = _analyzer_of(cls, f"hgp.{path.stem}")
            part.analyze()
            for of_all, own in (
                (analyzer.attr_docs, part.attr_docs), (analyzer.tagorder, part.tagorder), (analyzer.annotations, part.annotations)
            ):  # fmt: skip
                for key, value in own.items():
                    of_all.setdefault(key, value)
    return analyzer


ModuleAnalyzer.for_module = classmethod(_whole_package)  # type: ignore[assignment]

# C++: what Doxygen read in the public headers.
if "HGP_DOXYGEN" in os.environ:
    extensions.append("breathe")
    breathe_projects = {"hgp": os.environ["HGP_DOXYGEN"]}
    breathe_default_project = "hgp"
    breathe_default_members = ("members", "undoc-members")
    breathe_show_include = False
    primary_domain = "cpp"
    highlight_language = "cpp"
