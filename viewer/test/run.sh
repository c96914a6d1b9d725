#!/usr/bin/env bash
# Plans every example (EXAMPLES: a folder of examples that are planned already), tries its
# report.html and preview.glb in headless Chromium and with Khronos' validator, plans a small family
# and rows for two tools and tries their pages, and checks that the committed bundles are what their
# sources make. Needs Node 20 and chromium. Pictures of each page, on a screen of 1440 x 900, on a
# phone and printed, are in out/look/shots. PICTURES=1: makes the pictures of docs/ anew.
set -euo pipefail
cd "$(dirname "$0")/../.."
(cd viewer && npm ci --no-audit --no-fund --loglevel=error && npm run --silent check)
if [ -z "${EXAMPLES:-}" ]; then
    cargo build --release --quiet
    EXAMPLES=out/look
    bash tests/examples.sh target/release/bladewright "$EXAMPLES"
fi
runs=()
for job in examples/jobs/*.toml; do
    runs+=("$EXAMPLES/$(basename "$job" .toml)")
done
node viewer/test/gltf.mjs "${runs[@]/%//preview.glb}"
export SHOTS="${SHOTS:-out/look/shots}"
node viewer/test/report.mjs "${runs[@]}"
# Some members are meant to fail, and the exit code is the worst member's.
rm -rf out/look/family
target/release/bladewright --quiet batch viewer/test/family.toml -o out/look/family >/dev/null || [ $? -eq 3 ]
node viewer/test/family.mjs out/look/family
rm -rf out/look/pinch
target/release/bladewright --quiet pinch models/turbine_camber.step -o out/look/pinch --set tool.radius_mm=2 \
    --set path.scallop_mm=0.1 --set 'pinch.heights_mm=[6, 34]' --set 'pinch.edges="both"' --set machine.file=models/machines/pinch_9x.toml >/dev/null
node viewer/test/pinch.mjs out/look/pinch
if [ -n "${PICTURES:-}" ]; then
    node viewer/test/pictures.mjs docs "${runs[@]}"
fi
