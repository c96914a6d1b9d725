#!/usr/bin/env bash
# The same bytes from two builds: plans examples and, where BLADEWRIGHT_BLADES names their folder, published blades with each, and compares
# cutter locations, axes, programs, figures and checks. For changes that are to change nothing.
#
#   run.sh OLD NEW [FOLDER]     OLD and NEW are binaries. What OLD wrote stays in FOLDER (default: out/same) and is used again.
set -euo pipefail
here="$(cd "$(dirname "$0")/../.." && pwd)"
old="$(realpath "$1")" new="$(realpath "$2")" out="${3:-$here/out/same}"
mkdir -p "$out"

# A name, what is planned, and options.
runs() {
    local job
    for job in "$here"/examples/jobs/*.toml; do
        echo "$(basename "$job" .toml)|$job|--set path.scallop_mm=0.03"
    done
    echo "prism|$here/models/prism.step|--set path.scallop_mm=0.1 --set schedule.kind=optimal"
    echo "prism_mesh|$here/models/prism.obj|--unit mm --set path.scallop_mm=0.1 --set region.end_mm=12"
    echo "level|$here/models/turbine_camber.step|--set path.scallop_mm=0.05 --set path.kind=constant-height --set schedule.kind=time"
    echo "walls|$here/models/turbine_camber.step|--set path.scallop_mm=0.05 --set channel.exact_ends=true --set schedule.kind=upper-wall"
    echo "all_controls|$here/models/prism.step|--set path.scallop_mm=0.2 --set region.start_mm=30 --set region.end_mm=20 --set post.control=[\"siemens\",\"siemens-vector\",\"siemens-poly\",\"heidenhain\",\"heidenhain-vector\",\"fanuc\",\"fanuc-vector\",\"linuxcnc\",\"linuxcnc-feed\",\"iso\",\"apt\"]"
    if [ -n "${BLADEWRIGHT_BLADES:-}" ]; then
        local b="$BLADEWRIGHT_BLADES"
        echo "firtree|$b/turbine_blade_firtree.igs|--set path.scallop_mm=0.05"
        echo "hubwedge|$b/tblade3_case7288/case7288_rotor_hubwedge.step|--set path.scallop_mm=0.05"
        echo "scan|$b/turbine_blade_scan.stl|--unit m --set path.scallop_mm=0.05"
        echo "rotor37|$b/rotor37/rotor37_DERIVED_loft_mm.step|--set path.scallop_mm=0.05"
        echo "p4119|$b/dtmb_p4119/p4119_DERIVED_loft_mm.step|--set path.scallop_mm=0.05"
        echo "stage1|$b/turbodesigner_family/stage1_rotor.step|--set path.scallop_mm=0.05"
    fi
}

# Hashes of what a run wrote; a run that is refused counts with its message. Paths, times and the build differ by nature.
plan() {
    local binary="$1" name="$2" input="$3" options="$4" folder="$5"
    rm -rf "$folder" && mkdir -p "$folder"
    # shellcheck disable=SC2086
    "$binary" --quiet plan "$input" -o "$folder/run" $options >"$folder/told" 2>&1 || echo "exit $?" >>"$folder/told"
    sed -i "s|$folder|FOLDER|g" "$folder/told"
    (
        cd "$folder"
        sha256sum told
        cd run 2>/dev/null || exit 0
        for file in cutter_locations.csv axes.csv sections.json program.* summary.json verify.json; do
            [ ! -f "$file" ] || sha256sum "$file"
        done
    ) >"$folder/hashes"
    [ -n "${KEEP:-}" ] || rm -rf "$folder/run"
}

different=0
while IFS='|' read -r name input options; do
    [ -f "$input" ] || { echo "$name: $input is not there"; different=1; continue; }
    [ -f "$out/old/$name/hashes" ] || plan "$old" "$name" "$input" "$options" "$out/old/$name"
    plan "$new" "$name" "$input" "$options" "$out/new/$name"
    if diff "$out/old/$name/hashes" "$out/new/$name/hashes" >"$out/new/$name/diff"; then
        echo "$name: the same, $(wc -l <"$out/new/$name/hashes") files"
    else
        echo "$name: different"; cat "$out/new/$name/diff"
        diff "$out/old/$name/told" "$out/new/$name/told" || true
        different=1
    fi
done < <(runs)
exit $different
