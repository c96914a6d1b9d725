#!/bin/bash
# A family as a Slurm array job, one shard for each task, then the tables. FAMILY and OUT (a folder
# that all nodes see, or s3://…) are from the environment:
#   FAMILY=$PWD/family.toml OUT=$PWD/out SHARDS=16 examples/cluster/slurm_array.sh
# Tasks that were killed or lost their node: submit again, what is done is kept.
set -euo pipefail
: "${FAMILY:?a family file}" "${OUT:?where results go}" "${SHARDS:=4}" "${CPUS:=4}" "${MEMORY_MIB:=8000}"
BLADEWRIGHT=${BLADEWRIGHT:-bladewright}
export FAMILY OUT SHARDS BLADEWRIGHT MEMORY_MIB

# The options of srun and sbatch that a site needs (partition, account …) go into SBATCH_PARTITION,
# SBATCH_ACCOUNT …. A shard ends with the worst exit code of its members, which is no reason to keep
# back the tables: afterany.
array=$(sbatch --parsable --job-name=bladewright --array="1-$SHARDS" --cpus-per-task="$CPUS" --mem="${MEMORY_MIB}M" --requeue \
    --output="${LOGS:-.}/bladewright-%A_%a.log" \
    --wrap='"$BLADEWRIGHT" --quiet --threads "$SLURM_CPUS_PER_TASK" batch "$FAMILY" -o "$OUT" --shard "$SLURM_ARRAY_TASK_ID/$SHARDS" --memory "$((MEMORY_MIB * 8 / 10))"')
merge=$(sbatch --parsable --job-name=bladewright-merge --dependency="afterany:$array" \
    --output="${LOGS:-.}/bladewright-merge-%j.log" --wrap='"$BLADEWRIGHT" batch merge "$FAMILY" -o "$OUT"')
echo "array job $array, then $merge"
