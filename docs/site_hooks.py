# ruff: noqa: INP001  # no package: mkdocs loads this file by its path
"""What mkdocs does with the pages, beyond its configuration: the README and the sources as pages, formulas as MathML.

The same Markdown files are read in a checkout and on the site. In a checkout a link such as `../physics/polar.py` opens a file;
on the site it opens a page that shows the file. A file that is not there is left to mkdocs, which warns.
"""

import html
import os
import re
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files

_DOCS = Path(__file__).parent
_CHECKOUT = _DOCS.parent
_PAGES = {"README.md": "index.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}
"""Files beside `docs/` that are pages of their own."""
_SOURCES = "source"
"""Folder of the site in which files of the checkout are shown."""
_LANGUAGES = {".py": "python", ".toml": "toml"}
_LINK = re.compile(r"(\]\()([^)\s#]+)((?:#[^)\s]*)?\))")
_FORMULA = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)
_FROM_ELSEWHERE = re.compile(
    r"""<(?:script|img|iframe|source)\b[^>]*\bsrc=["']?(?:https?:)?//|<link\b(?![^>]*\brel=["']?canonical)"""
    r"""[^>]*\bhref=["']?(?:https?:)?//"""
)


def on_files(files: Files, config: Any, **_: Any) -> Files:
    """Add a page for every file beside `docs/` that is one, and for every source that a page links to."""
    pages = {_CHECKOUT / name: uri for name, uri in _PAGES.items()}
    for path, uri in pages.items():
        files.append(File.generated(config, uri, content=_relinked(path.read_text(encoding="utf-8"), path, uri)))
    readers = [*pages, *sorted(_DOCS.glob("*.md"))]
    linked = {target for page in readers for target in _linked_files(page)}
    for path in sorted(linked - set(pages)):
        files.append(File.generated(config, _page_of(path), content=_shown(path)))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Let a page's links to files of the checkout open the pages that show them."""
    path = _DOCS / page.file.src_uri
    return _relinked(markdown, path, page.file.src_uri) if path.is_file() else markdown


def on_page_content(content: str, **_: Any) -> str:
    """Let the browser set the formulas: MathML needs no script and no font from elsewhere."""
    return _FORMULA.sub(_mathml, content)


def on_post_build(config: Any, **_: Any) -> None:
    """Refuse a site that would fetch anything from elsewhere when it is read."""
    for path in Path(config["site_dir"]).rglob("*.html"):
        found = _FROM_ELSEWHERE.search(path.read_text(encoding="utf-8"))
        if found:
            raise PluginError(f"{path.name} needs the network: {found.group()}")


def _linked_files(page: Path) -> list[Path]:
    """The files of the checkout, but not of `docs/`, that a page links to."""
    targets = [_file_of(link, page) for _, link, _ in _LINK.findall(page.read_text(encoding="utf-8"))]
    return [target for target in targets if target is not None and _DOCS not in target.parents]


def _file_of(link: str, page: Path) -> Path | None:
    """The file that a link of a page opens in a checkout; None for another address, or where no file is."""
    if "://" in link:
        return None
    path = Path(os.path.normpath(page.parent / link.replace("\\", "")))
    return path if path.is_file() and _CHECKOUT in path.parents else None


def _page_of(path: Path) -> str:
    """Where on the site a file of the checkout is, from the site's root."""
    name = path.relative_to(_CHECKOUT).as_posix()
    if name in _PAGES:
        return _PAGES[name]
    return path.relative_to(_DOCS).as_posix() if _DOCS in path.parents else f"{_SOURCES}/{name}.md"


def _relinked(markdown: str, page: Path, uri: str) -> str:
    """The text of a page, its links as they must be on the site. uri: where the page is there."""

    def moved(found: re.Match[str]) -> str:
        before, link, after = found.groups()
        path = _file_of(link, page)
        return found.group() if path is None else before + os.path.relpath(_page_of(path), Path(uri).parent) + after

    return _LINK.sub(moved, markdown)


def _shown(path: Path) -> str:
    """A page that shows a file."""
    name = path.relative_to(_CHECKOUT).as_posix()
    text = path.read_text(encoding="utf-8").rstrip()
    language = _LANGUAGES.get(path.suffix, "text")
    return f'---\ntitle: {name}\nhide: [toc]\n---\n\n``````{language} linenums="1"\n{text}\n``````\n'


def _mathml(found: re.Match[str]) -> str:
    """One formula. Bars are set close to what they enclose: they are no relation here."""
    _, bracket, formula = found.groups()
    written = str(convert(html.unescape(formula).strip(), display="block" if bracket == "[" else "inline"))
    if "\\" in written or ">&<" in written:
        raise PluginError(f"MathML lacks a word for a part of this formula: {formula.strip()}")
    return written.replace('<mo stretchy="false">&#x0007C;</mo>', '<mo stretchy="false" lspace="0" rspace="0">|</mo>')
