"""`python -m game web`: the page on this machine, until it is interrupted."""

import sys
import time
import webbrowser

from game.system.output import print_line
from game.web.packages import cache_folder
from game.web.server import served
from game.web.site import built_site


def serve(port: int, *, opens: bool) -> None:
    """Serve the page and open the browser; ends with the signal that interrupts it. Errors are those of `built_site`."""
    site = built_site(cache_folder())
    with served(site, port) as address:
        print_line(f"{address}  (Ctrl+C ends it)")
        sys.stdout.flush()  # also where it is a file or a pipe: nothing else is printed until the end
        if opens:
            webbrowser.open(address)
        while True:
            time.sleep(3600.0)
