#!/usr/bin/env bash
# A family in two shards on S3-compatible storage (moto's server on this machine) against a run in a folder.
#   cargo build --release --features s3 && tests/s3/run.sh target/release/bladewright
# Needs Python with `pip install "moto[server]" boto3` (PYTHON=…).
set -euo pipefail
program=$(realpath "${1:-target/release/bladewright}")
here=$(realpath "$(dirname "$0")/../..")
python=${PYTHON:-python3}
"$python" -c 'import moto.server, boto3' 2>/dev/null || { echo "s3 suite: moto is not installed" >&2; exit 77; }
dir=$(mktemp -d)
port=${PORT:-15117}
"$python" -m moto.server -H 127.0.0.1 -p "$port" >"$dir/moto.log" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null; rm -rf "$dir"' EXIT

export AWS_ENDPOINT=http://127.0.0.1:$port AWS_ALLOW_HTTP=true AWS_REGION=us-east-1 AWS_ACCESS_KEY_ID=test AWS_SECRET_ACCESS_KEY=test
export no_proxy=127.0.0.1 NO_PROXY=127.0.0.1
fetch() { # BUCKET-PREFIX FOLDER: every object but the log's
    "$python" - "$AWS_ENDPOINT" "$1" "$2" <<'PY'
import os, sys, boto3
s3 = boto3.client("s3", endpoint_url=sys.argv[1])
for page in s3.get_paginator("list_objects_v2").paginate(Bucket="families", Prefix=sys.argv[2] + "/"):
    for o in page.get("Contents", []):
        path = os.path.join(sys.argv[3], os.path.relpath(o["Key"], sys.argv[2]))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        s3.download_file("families", o["Key"], path)
PY
}
for _ in $(seq 50); do
    "$python" -c "import boto3; boto3.client('s3', endpoint_url='$AWS_ENDPOINT').create_bucket(Bucket='families')" 2>/dev/null && break
    sleep 0.3
done
cp "$here/tests/slurm/family.toml" "$dir/family.toml"
sed -i 's/count = 10/count = 3/' "$dir/family.toml"
cd "$dir"
"$program" --quiet batch family.toml -o s3://families/one --shard 1/2 | head -1
# The second shard is killed on the way and started again.
"$program" --quiet batch family.toml -o s3://families/one --shard 2/2 >/dev/null &
shard=$!
sleep 1.5
kill -9 $shard 2>/dev/null || true
wait $shard 2>/dev/null || true
"$program" --quiet batch family.toml -o s3://families/one --shard 2/2 | head -1
"$program" batch merge family.toml -o s3://families/one | head -1
"$program" --quiet batch family.toml -o local | head -1
fetch one fetched
diff -r --exclude=log local fetched
"$program" --quiet batch family.toml -o s3://families/one | grep ' 0 computed now'
# Another post: stages are taken over from the store, and programs of the old control go away.
sed -i 's/^section = .*/&\npost = { control = ["heidenhain"] }/' family.toml
"$program" --quiet batch family.toml -o s3://families/one | head -1
"$program" --quiet batch family.toml -o local | head -1
rm -rf fetched
fetch one fetched
diff -r --exclude=log local fetched
grep -l '"verify"' fetched/log/fillet*.json | wc -l
# A store that is not there is one sentence and exit code 4.
code=0; "$program" --quiet batch family.toml -o s3://nowhere/one 2>message || code=$?
head -c 300 message
[ "$code" = 4 ] || { echo "exit code $code" >&2; exit 1; }
echo "s3 suite: two shards, a kill, a merge and a changed post are the local run, byte for byte"
