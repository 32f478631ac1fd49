"""The command line of the web site: `python -m tools.site`."""

from pathlib import Path
from typing import Annotated

import typer

from game.system.output import print_line
from game.web.packages import cache_folder
from game.web.site import built_site, write_site

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


@app.command()
def write(out: Annotated[Path, typer.Argument(metavar="OUT", help="Folder for the files.")]) -> int:
    """Write the game as static files for any web host.

    Exit code 0: written. 2: the folder cannot be written. 3: npm, pip or the network is missing.
    """
    site = built_site(cache_folder())
    write_site(site, out)
    print_line(f"{len(site)} files, {sum(map(len, site.values())) / 1e6:.1f} MB: {out}")
    return 0
