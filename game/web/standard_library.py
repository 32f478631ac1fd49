"""The part of Python's standard library that the page gets: what the game needs, and what computes."""

_LEFT_OUT = """
    __hello__ __phello__ _aix_support _android_support _apple_support _compat_pickle _ios_support _markupbase _osx_support
    _pydatetime _pydecimal _pyio _pyrepl _ssl _strptime antigravity argparse bdb cProfile calendar cmd code compileall
    configparser csv ctypes curses dbm doctest email ensurepip filecmp fileinput ftplib getopt getpass gzip html http
    idlelib imaplib ipaddress mailbox mimetypes modulefinder multiprocessing netrc nturl2path optparse pdb pickle
    pickletools pkgutil platform plistlib poplib profile profiling pstats pty py_compile pyclbr pydoc pydoc_data quopri
    rlcompleter runpy sched shelve shlex site-packages smtplib socketserver sqlite3 ssl stringprep symtable sysconfig
    tabnanny tarfile this timeit trace tracemalloc tty turtle turtledemo unittest urllib venv wave webbrowser wsgiref xml
    xmlrpc zipapp zoneinfo asyncio.__main__ asyncio.proactor_events asyncio.tools asyncio.windows_events
    asyncio.windows_utils concurrent.futures.interpreter concurrent.futures.process concurrent.futures.thread
    concurrent.interpreters importlib.metadata json.__main__ json.tool logging.config logging.handlers pathlib.types
    pyodide._nodesock_transport pyodide.console pyodide.http zipfile.__main__
"""
"""Modules and packages for files, networks, processes, threads, terminals and packaging. The page has none of these."""
_ENCODINGS = "aliases ascii base64_codec cp1252 charmap hex_codec latin_1 raw_unicode_escape undefined"
_UNICODE = ("utf_", "unicode_")
"""Of the encodings, which there are."""
_OF_ENGINE = ("ctypes/__init__.py", "ctypes/_endian.py", "ctypes/_layout.py", "platform.py", "sysconfig/__init__.py")
"""Files that only the lab's second engine needs."""


def needed_by_engine(files: dict[str, bytes]) -> dict[str, bytes]:
    """The part of the standard library that is served with the lab's second engine. files: as for `needed`."""
    return {name: files[name] for name in _OF_ENGINE}


def needed(files: dict[str, bytes]) -> dict[str, bytes]:
    """What of the standard library is served. files: all of its files, by name."""
    left_out = frozenset(_LEFT_OUT.split())
    return {name: data for name, data in files.items() if _is_needed(name, left_out)}


def _is_needed(name: str, left_out: frozenset[str]) -> bool:
    """Whether a file is served."""
    parts = name.rpartition(".")[0].split("/")
    if parts[0].startswith("_sysconfigdata"):
        return False
    if parts[0] == "encodings" and parts[-1] != "__init__":
        return parts[-1] in _ENCODINGS.split() or parts[-1].startswith(_UNICODE)
    return not any([".".join(parts[:length]) in left_out for length in range(1, len(parts) + 1)])
