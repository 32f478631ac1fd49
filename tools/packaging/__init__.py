"""How the program is packaged: where its console scripts begin, and an application that needs no Python."""
