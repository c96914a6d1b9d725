#!/usr/bin/env bash
# A family of 40 members as an array job of 4 shards on a real Slurm (slurmctld and slurmd on this machine), against a local run.
# Needs: apt-get install slurmctld slurmd slurm-client munge; root, since slurmd and munge want it. Everything it starts ends with it.
#   cargo build --release && tests/slurm/run.sh target/release/bladewright
set -euo pipefail
program=$(realpath "${1:-target/release/bladewright}")
here=$(realpath "$(dirname "$0")/../..")
for tool in slurmctld slurmd sbatch munged; do
    command -v "$tool" >/dev/null || { echo "slurm suite: $tool is not installed" >&2; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "slurm suite: slurmd needs root" >&2; exit 77; }

dir=$(mktemp -d /tmp/bladewright-slurm.XXXXXX)
chmod 755 "$dir"
mkdir -p "$dir"/{state,spool,munge}
started=()
cleanup() {
    for pid in "${started[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait 2>/dev/null || true
    [ -n "${KEEP:-}" ] || rm -rf "$dir"
}
trap cleanup EXIT

# munge with a key and a socket of its own.
head -c 1024 /dev/urandom >"$dir/munge/key"
chmod 700 "$dir/munge"; chmod 400 "$dir/munge/key"
mkdir -p "$dir/run"; chmod 755 "$dir/run"
munged --foreground --key-file="$dir/munge/key" --socket="$dir/run/munge" --pid-file="$dir/munge/pid" \
    --log-file="$dir/munge/log" --seed-file="$dir/munge/seed" &
started+=($!)

cat >"$dir/slurm.conf" <<CONF
ClusterName=bladewright
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/run/munge
CredType=cred/munge
SlurmctldPort=${PORT:-16817}
SlurmdPort=$((${PORT:-16817} + 1))
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.log
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$dir/slurm.conf"
sleep 1
slurmctld -D -f "$SLURM_CONF" >"$dir/slurmctld.out" 2>&1 &
started+=($!)
sleep 2
slurmd -D -f "$SLURM_CONF" >"$dir/slurmd.out" 2>&1 &
started+=($!)
for _ in $(seq 60); do
    sinfo -h -o %T 2>/dev/null | grep -q idle && break
    sleep 1
done
sinfo

cp "$here/tests/slurm/family.toml" "$dir/"
# Made members only: paths in the results do not depend on where they are computed.
LOGS=$dir FAMILY=$dir/family.toml OUT=$dir/slurm SHARDS=4 CPUS=1 MEMORY_MIB=800 BLADEWRIGHT=$program \
    bash "$here/examples/cluster/slurm_array.sh"
for _ in $(seq 900); do
    [ -z "$(squeue -h)" ] && break
    sleep 1
done
squeue
cat "$dir"/bladewright-merge-*.log
"$program" --quiet batch "$dir/family.toml" -o "$dir/local" | head -1
ls "$dir"/slurm/log/*.lock
diff -r --exclude=log "$dir/local" "$dir/slurm"
[ "$(ls "$dir/slurm/members" | wc -l)" = 40 ]
echo "slurm suite: 4 shards of 40 members and the merge are the local run, byte for byte"
