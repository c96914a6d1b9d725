#!/usr/bin/env bash
# Motions of the project's blades under several limits, differentiated by code that did not plan them: what `just motion` runs.
# usage: bash tests/motion/run.sh BLADEWRIGHT
set -euo pipefail
cd "$(dirname "$0")/../.."
bladewright=$1 out=out/motion
mkdir -p "$out"
for scale in 1 4 0.25; do
    machine="$out/machine_$scale.toml"
    # The demo machine with all velocities, accelerations and jerks scaled.
    awk -v f="$scale" '/^(velocity|acceleration|jerk)_/ { printf "%s = %.1f\n", $1, $3 * f; next } { print }' \
        models/machines/demo_table_head.toml > "$machine"
    for model in steam_root compressor_twist turbine_camber prism; do
        for kind in piecewise optimal; do
            run="$out/$model-$kind-$scale"
            # Checks of the plan may find something (code 1); the motion is written all the same.
            "$bladewright" --quiet plan "models/$model.step" -o "$run" --set machine.file="$PWD/$machine" \
                --set schedule.kind=$kind > "$run.log" 2>&1 || [ $? -eq 1 ] || { cat "$run.log"; exit 1; }
            python3 tests/motion/differences.py "$run" --machine "$machine"
        done
    done
done
