#!/usr/bin/env bash
# Programs of all examples read by other people's interpreters, and our kinematics beside LinuxCNC's: what `just controls` runs.
# LinuxCNC comes from apt (unpacked, not installed), nc-gcode-interpreter from PyPI. PYTHON: the Python for the latter.
# usage: bash tests/controls/run.sh BLADEWRIGHT AXIS_POSITIONS
set -euo pipefail
cd "$(dirname "$0")/../.."
bladewright=$1 positions=$2 out=out/controls
: "${LINUXCNC_ROOT:=$PWD/out/linuxcnc/root}"
export LINUXCNC_ROOT
[ -x "$LINUXCNC_ROOT/usr/bin/rs274" ] || sh tests/controls/linuxcnc.sh "$(dirname "$LINUXCNC_ROOT")"
python=${PYTHON:-out/controls-venv/bin/python}
[ -x "$(command -v "$python")" ] || { python3 -m venv out/controls-venv && out/controls-venv/bin/pip install -q nc-gcode-interpreter polars; }
"$python" -c 'import nc_gcode_interpreter' 2>/dev/null || "$python" -m pip install -q nc-gcode-interpreter polars
# EXAMPLES: a folder of examples that are planned already.
examples=${EXAMPLES:-$out/examples}
[ -n "${EXAMPLES:-}" ] || bash tests/examples.sh "$bladewright" "$examples"
mkdir -p $out
# Two operations in one program: the same part, the second with a smaller ball and another tool number.
"$bladewright" --quiet plan examples/jobs/steam_root.toml -o $out/fillet --set region.start_mm=21 --set tool.radius_mm=4 \
    --set path.scallop_mm=0.04 --set tool.shank_radius_mm=8 --set post.tool_number=2 > $out-fillet.log 2>&1 || { cat $out-fillet.log; exit 1; }
for control in siemens siemens-vector siemens-poly siemens-axes linuxcnc linuxcnc-feed; do
    "$bladewright" --quiet post "$examples/steam_root" $out/fillet --control $control -o $out/joined
done
# Two tools on one blade: nine letters, and two channels.
"$bladewright" --quiet pinch models/turbine_camber.step -o $out/pinch --set machine.file=models/machines/pinch_9x.toml --set tool.radius_mm=2 \
    --set path.scallop_mm=0.02 > $out-pinch.log 2>&1 || { cat $out-pinch.log; exit 1; }
"$bladewright" --quiet pinch models/turbine_camber.step -o $out/pinch_channels --set machine.file=models/machines/pinch_9x.toml --set tool.radius_mm=2 \
    --set path.scallop_mm=0.02 --set pinch.channels=2 --set 'post.control=["siemens"]' > $out-pinch.log 2>&1 || { cat $out-pinch.log; exit 1; }
# Each reader is one thread.
python3 tests/controls/rs274.py "$examples"/*/*.ngc $out/*/*.ngc > $out-rs274.log 2>&1 &
rs274=$!
"$python" tests/controls/siemens.py "$examples"/*/*.mpf $out/*/*.mpf
wait $rs274 || { cat $out-rs274.log; exit 1; }
cat $out-rs274.log
python3 tests/controls/kinematics.py "$positions" 10000
