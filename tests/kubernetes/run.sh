#!/usr/bin/env bash
# The Kubernetes Jobs of examples/cluster without a cluster: both against Kubernetes' own schemas, strictly, then their very commands, with
# JOB_COMPLETION_INDEX as an indexed Job sets it, each index once and one of them killed and started again as a Job does; the tables against a local run.
#   cargo build --release && tests/kubernetes/run.sh target/release/bladewright
# Needs Python with `pip install kubernetes-validate pyyaml` (PYTHON=…). What a cluster adds (image, volume, scheduling) is not tried here.
set -euo pipefail
program=$(realpath "${1:-target/release/bladewright}")
here=$(realpath "$(dirname "$0")/../..")
python=${PYTHON:-python3}
"$python" -c 'import kubernetes_validate, yaml' 2>/dev/null || { echo "kubernetes suite: kubernetes-validate is not installed" >&2; exit 77; }
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
mkdir "$dir/bin" "$dir/volume"
ln -s "$program" "$dir/bin/bladewright"
# Twenty members, so that each of the sixteen indexes has work.
sed 's/count = 10/count = 5/' "$here/tests/slurm/family.toml" >"$dir/volume/family.toml"

"$python" - "$here/examples/cluster" "$dir" <<'PY'
import sys
import kubernetes_validate, yaml

folder, out = sys.argv[1:]
for name in ("kubernetes", "kubernetes_merge"):
    with open(f"{folder}/{name}.yaml") as f:
        job = yaml.safe_load(f)
    version = kubernetes_validate.validate(job, "1.31", strict=True)
    print(f"{name}.yaml: valid for Kubernetes {version}")
    container = job["spec"]["template"]["spec"]["containers"][0]
    shell, flag, *script = container["command"] + container.get("args", [])
    assert (shell, flag, len(script)) == ("/bin/sh", "-c", 1), container
    # The volume is mounted at /work in the container; here it is a folder.
    home = f"{out}/volume"
    env = "".join(f"export {e['name']}='{e['value'].replace('/work', home)}'\n" for e in container.get("env", []))
    with open(f"{out}/{name}.sh", "w") as f:
        f.write(env + script[0].replace("/work/", f"{home}/"))
    with open(f"{out}/{name}.count", "w") as f:
        f.write(str(job["spec"].get("completions", 1)))
PY

export PATH="$dir/bin:$PATH"
count=$(cat "$dir/kubernetes.count")
for index in $(seq 0 $((count - 1))); do
    if [ "$index" = 1 ]; then
        # A pod that loses its node, and its successor with the same index.
        JOB_COMPLETION_INDEX=$index setsid /bin/sh "$dir/kubernetes.sh" >/dev/null &
        pod=$!
        sleep 0.4
        kill -9 -- "-$pod" 2>/dev/null || true
        wait "$pod" 2>/dev/null || true
    fi
    JOB_COMPLETION_INDEX=$index /bin/sh "$dir/kubernetes.sh" >/dev/null
done
/bin/sh "$dir/kubernetes_merge.sh" | head -1
"$program" --quiet batch "$dir/volume/family.toml" -o "$dir/local" | head -1
diff -r --exclude=log "$dir/local" "$dir/volume/out"
[ "$(ls "$dir/volume/out/members" | wc -l)" = 20 ]
echo "kubernetes suite: $count indexes of 20 members, one killed, and the merge are the local run, byte for byte"
