"""`python memory_limit.py MEBIBYTES COMMAND ...`: becomes the command, with a limit on the memory that it may write to.

Run as a file in the child process, between its start and the student's program. Needs Linux; elsewhere there is no such limit.
"""

import os
import sys


def main() -> None:
    """Set the limit, then become the command."""
    mebibytes, *command = sys.argv[1:]
    if sys.platform == "linux":
        import resource  # noqa: PLC0415  # not on Windows

        # RLIMIT_DATA, not RLIMIT_AS: the virtual machines of Java and JavaScript reserve addresses that they never use
        resource.setrlimit(resource.RLIMIT_DATA, (int(mebibytes) << 20,) * 2)
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.execvp(command[0], command)  # noqa: S606  # no shell is meant


if __name__ == "__main__":
    main()
