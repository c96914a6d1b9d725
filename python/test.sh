#!/usr/bin/env bash
# The wheel, installed in a fresh virtual environment, beside the command line tool: types, tests,
# the examples of its README.
#   cargo build --release && python/test.sh target/release/bladewright
# Needs Rust and Python 3.11 (PYTHON=…); the rest is installed in the new environment.
set -euo pipefail
BLADEWRIGHT=$(realpath "${1:-target/release/bladewright}")
export BLADEWRIGHT
here=$(realpath "$(dirname "$0")")
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
"${PYTHON:-python3}" -m venv "$dir/build"
"$dir/build/bin/pip" install --quiet maturin
PYTHON="$dir/build/bin/python" "$here/build.sh" "$dir/wheels"
"${PYTHON:-python3}" -m venv "$dir/fresh"
"$dir/fresh/bin/pip" install --quiet "$(echo "$dir"/wheels/*.whl)[test]"
# Away from the sources, so that what is installed is what is imported.
mkdir "$dir/python"
cp -r "$here/tests" "$dir/python/tests"
ln -s "$here/../models" "$dir/models"
cd "$dir"
"$dir/fresh/bin/mypy" --strict -p bladewright
"$dir/fresh/bin/python" -m pytest -q -p no:cacheprovider python/tests
# The examples of README, as printed.
sed -n '/^```python$/,/^```$/p' "$here/README.md" | grep -v '^```' >readme.py
"$dir/fresh/bin/python" readme.py
ls -l "$dir/wheels"
