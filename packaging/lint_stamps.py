"""Prints each source of core, widgets and app that is to be linted, and the stamp to touch once it is clean.

Reads what `ninja -t deps` prints. A stamp's name is the hash of clang-tidy's version and settings, of the source, and
of all that it includes of the project; a source whose stamp exists is left out.
"""

import hashlib
import os
import re
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
STAMPS = os.path.join(os.environ.get("XDG_CACHE_HOME", os.path.expanduser("~/.cache")), "graftsman-lint")


def read(path):
    with open(path, "rb") as stream:
        return stream.read()


def dependencies():
    """{source relative to the root: files of the project that it includes}."""
    found = {}
    build = os.path.join(ROOT, "build-dev")
    for block in sys.stdin.read().split("\n\n"):
        files = [os.path.realpath(os.path.join(build, line.strip())) for line in block.splitlines()[1:]]
        own = [os.path.relpath(file, ROOT) for file in files if file.startswith(ROOT + os.sep)]
        if own and re.match(r"(core|widgets|app)/.*\.cpp$", own[0]):
            found[own[0]] = own
    return found


def main():
    settings = subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout
    settings += read(os.path.join(ROOT, ".clang-tidy")) + read(os.path.join(ROOT, "CMakePresets.json"))
    known = dependencies()
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "core/*.cpp", "widgets/*.cpp", "app/*.cpp"],
                            capture_output=True, check=True, text=True).stdout.split()
    for source in listed:
        digest = hashlib.sha256(settings)
        for file in sorted(known.get(source, [source])):
            digest.update(file.encode() + b"\0")
            if os.path.exists(os.path.join(ROOT, file)):
                digest.update(read(os.path.join(ROOT, file)))
        stamp = os.path.join(STAMPS, digest.hexdigest())
        if not os.path.exists(stamp):
            print(source, stamp)


main()
