#!/usr/bin/env bash
# Builds the wheel into the folder OUT (target/wheels), with the licences of all that is in it. What
# was compiled for the command is taken over.
#   python/build.sh [OUT] [OPTIONS OF maturin build]
# Needs Rust, and Python 3.11 (PYTHON=…) with `pip install maturin`.
set -euo pipefail
cd "$(dirname "$0")"
out=${1:-../target/wheels}
[ $# -eq 0 ] || shift
python=${PYTHON:-python3}
"$python" ../release/notices.py --package bladewright-python -o bladewright/THIRD_PARTY_NOTICES.txt
cp ../LICENSE-MIT LICENSE-MIT
"$python" -m maturin build --release --locked --quiet --out "$out" "$@"
