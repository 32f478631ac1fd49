"""A web server for the page, on this machine alone."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread
from typing import Any
from urllib.parse import unquote, urlsplit

from game.system.errors import EnvironmentMissingError

ADDRESS = "127.0.0.1"
_TYPES = {
    "html": "text/html; charset=utf-8",
    "css": "text/css; charset=utf-8",
    "js": "text/javascript; charset=utf-8",
    "mjs": "text/javascript; charset=utf-8",
    "json": "application/json",
    "webmanifest": "application/manifest+json",
    "svg": "image/svg+xml",
    "txt": "text/plain; charset=utf-8",
}


class _Server(ThreadingHTTPServer):
    """A server that a browser may leave at any time."""

    daemon_threads = True

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Report errors on the terminal, but not that a browser has closed its connection."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


@contextmanager
def served(site: dict[str, bytes], port: int) -> Iterator[str]:
    """Serve files for as long as the block runs; the address of the page. port: 0 for a free one.

    EnvironmentMissingError where the port cannot be had.
    """

    class Handler(BaseHTTPRequestHandler):
        """Answers with a file, and says nothing on the terminal."""

        protocol_version = "HTTP/1.1"

        def do_GET(self) -> None:  # the name that the library calls
            """A file of the site."""
            name = unquote(urlsplit(self.path).path).removeprefix("/") or "index.html"
            data = site.get(name)
            body = b"not here\n" if data is None else data
            self.send_response(HTTPStatus.NOT_FOUND if data is None else HTTPStatus.OK)
            self.send_header("Content-Type", _TYPES.get(name.rpartition(".")[2], "application/octet-stream"))
            self.send_header("Content-Length", str(len(body)))
            self.send_header("Cache-Control", "no-cache")
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_arguments: object) -> None:
            """Nothing."""

    try:
        server = _Server((ADDRESS, port), Handler)
    except (OSError, OverflowError) as error:
        raise EnvironmentMissingError(f"port {port} cannot be had ({error}); choose another with --port") from None
    thread = Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://{ADDRESS}:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
