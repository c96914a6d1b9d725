#!/usr/bin/env python3
"""The licences of everything that is in the programs, as one text.

  release/notices.py -o THIRD_PARTY_NOTICES.txt    writes it
  release/notices.py                               checks only

In it: the crates that the lock file pins, on every system, with the licence files of their
sources; the standard library of Rust; the scripts in the report; the letters of plots. Ends with
exit code 1 where a licence is not among those that ask for no more than a notice. Needs Rust, and
nothing but Python 3.11.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]

# Licences that ask for no more than that their text goes along.
PERMISSIVE = {
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "CC0-1.0",
    "CDLA-Permissive-2.0",
    "ISC",
    "MIT",
    "MIT-0",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
}
# Packages of viewer/package.json that are in the bundle; the others build and test it.
BUNDLED = {"three", "uplot"}
BUNDLED_IN_FAMILY = {"uplot"}
TOOLS = {"esbuild", "gltf-validator", "playwright-core"}

LICENCE_FILE = re.compile(
    r"(LICEN[CS]E|COPYING|NOTICE|UNLICENSE|COPYRIGHT)([-_.][\w.-]*)?", re.IGNORECASE
)
NO_TEXT = {".rs", ".py", ".js", ".json", ".toml", ".yml", ".yaml"}

MIT = """Permission is hereby granted, free of charge, to any person obtaining a copy of this software
and associated documentation files (the "Software"), to deal in the Software without restriction,
including without limitation the rights to use, copy, modify, merge, publish, distribute,
sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or
substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT
NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND
NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM,
DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT
OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE."""


def permitted(expression: str) -> bool:
    """Whether an SPDX expression lets us choose permissive licences; `/` is an old OR."""
    spaced = re.sub(r"([()])", r" \1 ", expression.replace("/", " OR "))
    words = spaced.split()
    at = 0

    def either() -> bool:
        nonlocal at
        good = both()
        while at < len(words) and words[at].upper() == "OR":
            at += 1
            # Read also where the first one will do.
            good = both() or good
        return good

    def both() -> bool:
        nonlocal at
        good = one()
        while at < len(words) and words[at].upper() == "AND":
            at += 1
            good = one() and good
        return good

    def one() -> bool:
        nonlocal at
        if at >= len(words):
            raise ValueError(f"{expression!r} is no licence expression")
        word = words[at]
        at += 1
        if word == "(":
            good = either()
            if at >= len(words) or words[at] != ")":
                raise ValueError(f"{expression!r} is no licence expression")
            at += 1
            return good
        if words[at : at + 1] == ["WITH"]:
            word = " ".join([word, *words[at : at + 2]])
            at += 2
        return word in PERMISSIVE

    good = either()
    if at != len(words):
        raise ValueError(f"{expression!r} is no licence expression")
    return good


def metadata(features: list[str]) -> dict:
    command = ["cargo", "metadata", "--locked", "--format-version", "1", *features]
    return json.loads(subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout)


def crates(found: dict, package: str) -> list[dict]:
    """All packages that a package is built from, but for those of its tests; without ours."""
    by_id = {p["id"]: p for p in found["packages"]}
    deps = {n["id"]: n["deps"] for n in found["resolve"]["nodes"]}
    todo = [p["id"] for p in by_id.values() if p["name"] == package and p["source"] is None]
    if not todo:
        raise SystemExit(f"there is no package {package}")
    seen = set()
    while todo:
        here = todo.pop()
        if here in seen:
            continue
        seen.add(here)
        needed = [d for d in deps[here] if any(k["kind"] != "dev" for k in d["dep_kinds"])]
        todo.extend(d["pkg"] for d in needed)
    others = [by_id[i] for i in seen if by_id[i]["source"] is not None]
    return sorted(others, key=lambda p: (p["name"], p["version"]))


def refused(packages: list[dict]) -> list[str]:
    """Those whose licence asks for more than a notice, or says nothing."""
    bad = set()
    for p in packages:
        try:
            good = permitted(p["license"] or "")
        except ValueError:
            good = False
        if not good:
            bad.add(f"{p['name']} {p['version']}: {p['license']}")
    return sorted(bad)


def licence_files(folder: Path) -> list[Path]:
    out = []
    for place, folders, files in os.walk(folder):
        folders[:] = sorted(f for f in folders if f not in {"tests", "target", "benches"})
        named = (f for f in sorted(files) if LICENCE_FILE.fullmatch(f))
        out += [Path(place) / f for f in named if Path(f).suffix not in NO_TEXT]
    return out


def text_of(file: Path) -> str:
    lines = file.read_text(encoding="utf-8", errors="replace").expandtabs().splitlines()
    return "\n".join(line.rstrip() for line in lines).strip("\n\f ")


def viewer() -> tuple[str, str]:
    """Name and text of the notice at the top of the viewer's bundles."""
    listed = json.loads((ROOT / "viewer/package.json").read_text())
    packages = {**listed.get("dependencies", {}), **listed.get("devDependencies", {})}
    unknown = set(packages) - BUNDLED - TOOLS
    if unknown:
        raise SystemExit(f"viewer/package.json names {unknown}: say here whether they are bundled")
    # The family's script has a part of the packages; the report's notice covers all.
    notices = {}
    for script, bundled in (("viewer.js", BUNDLED), ("family.js", BUNDLED_IN_FAMILY)):
        notices[script] = re.match(r"/\*!(.*?)\*/", (ROOT / "viewer/dist" / script).read_text(), re.S)
        if not notices[script] or not all(packages[p] in notices[script][1] for p in bundled):
            raise SystemExit(f"viewer/dist/{script} does not begin with the notice of its packages")
    name = ", ".join(f"{p} {packages[p]} (MIT)" for p in sorted(BUNDLED))
    return f"{name}, in the scripts of report.html and family.html", notices["viewer.js"][1].strip()


def gathered(packages: list[dict]) -> str:
    """The text: a list of all, then each distinct licence text with those it belongs to."""
    texts: dict[str, tuple[str, list[str]]] = {}

    def add(text: str, owner: str) -> None:
        key = " ".join(text.split())
        texts.setdefault(key, (text, []))[1].append(owner)

    apache = next(
        text_of(f)
        for p in packages
        for f in licence_files(Path(p["manifest_path"]).parent)
        if f.name == "LICENSE-APACHE" and "APPENDIX" in f.read_text(errors="replace")
    )
    for p in packages:
        owner = f"{p['name']} {p['version']}"
        files = licence_files(Path(p["manifest_path"]).parent)
        for file in files:
            add(text_of(file), owner)
        if not files:
            # Its authors have put no text into the package; the licence says which one it is.
            if "Apache-2.0" in p["license"]:
                add(apache, owner)
            elif "MIT" in p["license"]:
                authors = ", ".join(p["authors"]) or f"the authors of {p['name']}"
                add(f"Copyright (c) {authors}\n\n{MIT}", owner)
            else:
                raise SystemExit(f"{owner} comes without a licence text")
    add(f"Copyright (c) The Rust Project Contributors\n\n{MIT}", "the standard library of Rust")
    name, notice = viewer()
    add(notice, name)

    lines = [
        "bladewright is under the MIT licence. In its programs are works of others.",
        "Their licences follow; each text stands below the names that it belongs to.",
        "",
    ]
    lines += [f"{p['name']} {p['version']}: {p['license']}" for p in packages]
    lines += ["the standard library of Rust: MIT OR Apache-2.0", name]
    for text, owners in texts.values():
        lines += ["", "-" * 80, *sorted(set(owners)), "", text]
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--out", type=Path, help="where the text is written")
    parser.add_argument("--package", default="bladewright", help="what is built")
    args = parser.parse_args()
    # What is checked may be more than what is written: all features, and the Python package.
    everything = metadata(["--all-features"])
    checked = crates(everything, "bladewright") + crates(everything, "bladewright-python")
    bad = refused(checked)
    for one in bad:
        print(f"not a permissive licence: {one}", file=sys.stderr)
    if bad:
        return 1
    packages = crates(metadata([]), args.package)
    text = gathered(packages)
    if args.out:
        args.out.write_text(text, encoding="utf-8")
    print(f"{len(packages)} packages of {args.package}, all licences permissive")
    return 0


if __name__ == "__main__":
    sys.exit(main())
