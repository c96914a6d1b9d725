#!/usr/bin/env python3
"""An archive of the command for one system, with its checksum beside it.

  release/archive.py [--target TRIPLE] [--out FOLDER] [--no-try]

Builds the command, gathers man pages, completions, licences and notices, packs them, unpacks the
archive elsewhere and runs what is in it. The same sources and compiler give the same archive.
Needs Rust with the target, and nothing but Python 3.11.
"""

import argparse
import gzip
import hashlib
import io
import json
import shutil
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DOCUMENTS = ["README.md", "CHANGELOG.md", "LICENSE-MIT"]
SHELLS = {
    "bash": "bladewright.bash",
    "zsh": "_bladewright",
    "fish": "bladewright.fish",
    "powershell": "_bladewright.ps1",
    "elvish": "bladewright.elv",
}
# 1980, the first day that an archive of either kind can hold.
WHEN = 315532800


def run(*command: object, cwd: Path = ROOT) -> str:
    words = [str(c) for c in command]
    return subprocess.run(words, cwd=cwd, check=True, stdout=subprocess.PIPE, text=True).stdout


def host() -> str:
    lines = run("rustc", "-vV").splitlines()
    return next(line.removeprefix("host: ") for line in lines if line.startswith("host: "))


def build(target: str) -> Path:
    """The command; a build for this system is that of `cargo build --release`."""
    other = [] if target == host() else ["--target", target]
    run("cargo", "build", "--release", "--locked", "--bin", "bladewright", *other)
    metadata = run("cargo", "metadata", "--no-deps", "--format-version", "1", "--locked")
    folder = Path(json.loads(metadata)["target_directory"])
    name = "bladewright.exe" if "windows" in target else "bladewright"
    return folder.joinpath(*other[1:], "release", name)


def slim(binary: Path, target: str) -> bytes:
    """The command without the names of its functions: a quarter of it, for a debugger alone."""
    if "linux" not in target or target != host() or not shutil.which("strip"):
        return binary.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / binary.name
        run("strip", "-o", copy, binary)
        return copy.read_bytes()


def contents(binary: Path, target: str) -> dict[str, bytes]:
    """What is in the archive, by name."""
    files = {binary.name: slim(binary, target)}
    files |= {name: (ROOT / name).read_bytes() for name in DOCUMENTS}
    with tempfile.TemporaryDirectory() as folder:
        notices = Path(folder) / "THIRD_PARTY_NOTICES.txt"
        run(sys.executable, ROOT / "release/notices.py", "-o", notices)
        files[notices.name] = notices.read_bytes()
        run(binary, "man", "-o", Path(folder) / "man")
        for page in sorted((Path(folder) / "man").iterdir()):
            files[f"man/{page.name}"] = page.read_bytes()
    for shell, name in SHELLS.items():
        files[f"completions/{name}"] = run(binary, "completions", shell).encode()
    return files


def pack(archive: Path, top: str, files: dict[str, bytes], program: str) -> None:
    mode = {name: 0o755 if name == program else 0o644 for name in files}
    if archive.suffix == ".zip":
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
            for name, content in files.items():
                entry = zipfile.ZipInfo(f"{top}/{name}")
                entry.external_attr = (0o100000 | mode[name]) << 16
                entry.compress_type = zipfile.ZIP_DEFLATED
                out.writestr(entry, content)
        return
    with (
        archive.open("wb") as raw,
        gzip.GzipFile("", "wb", 9, raw, mtime=WHEN) as packed,
        tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as out,
    ):
        for name, content in files.items():
            entry = tarfile.TarInfo(f"{top}/{name}")
            entry.size, entry.mode, entry.mtime = len(content), mode[name], WHEN
            out.addfile(entry, io.BytesIO(content))


def tried(archive: Path, top: str, program: str, version: str) -> None:
    """The program of the archive, unpacked elsewhere, says its version and plans a blade."""
    with tempfile.TemporaryDirectory() as folder:
        if archive.suffix == ".zip":
            with zipfile.ZipFile(archive) as packed:
                packed.extractall(folder)
        else:
            with tarfile.open(archive) as packed:
                packed.extractall(folder, filter="data")
        command = Path(folder) / top / program
        command.chmod(0o755)
        said = run(command, "--version", cwd=Path(folder)).strip()
        assert said == f"bladewright {version}", said
        keys = ["path.scallop_mm=0.2", "region.start_mm=30", "region.end_mm=20"]
        sets = [word for key in keys for word in ("--set", key)]
        out = Path(folder) / "run"
        run(command, "--quiet", "plan", ROOT / "models/prism.step", "-o", out, *sets)
        assert (out / "program.mpf").stat().st_size > 0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--target", help="the system, as Rust names it; this one if left out")
    parser.add_argument("--out", type=Path, default=ROOT / "target/release-archives")
    parser.add_argument("--no-try", action="store_true", help="where this system cannot run it")
    args = parser.parse_args()
    target = args.target or host()
    version = tomllib.loads((ROOT / "Cargo.toml").read_text())["package"]["version"]
    top = f"bladewright-{version}-{target}"
    binary = build(target)
    args.out.mkdir(parents=True, exist_ok=True)
    archive = args.out / f"{top}{'.zip' if 'windows' in target else '.tar.gz'}"
    files = contents(binary, target)
    pack(archive, top, files, binary.name)
    digest = hashlib.sha256(archive.read_bytes()).hexdigest()
    # In the form that `sha256sum --check` reads.
    checksum = archive.with_name(archive.name + ".sha256")
    checksum.write_text(f"{digest}  {archive.name}\n", newline="\n")
    if not args.no_try:
        tried(archive, top, binary.name, version)
    size = archive.stat().st_size / 1e6
    print(f"{archive}: {len(files)} files, {size:.1f} MB, SHA-256 {digest}")


if __name__ == "__main__":
    main()
