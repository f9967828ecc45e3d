#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# One scenario as a Slurm array of eight shards:
#   sbatch --export=ALL,SCENARIO=hostsim/scenarios/c_distance.toml,OUT=/shared/c \
#       hostsim/examples/slurm_array.sh
# and, when all are done:
#   ocellus-sim merge --out "$OUT" "$OUT"-shard-*
#
#SBATCH --job-name=ocellus-sim
#SBATCH --array=1-8
#SBATCH --cpus-per-task=2
#SBATCH --mem=2G
#SBATCH --time=01:00:00
set -euo pipefail

shard="$SLURM_ARRAY_TASK_ID"
shards="$SLURM_ARRAY_TASK_COUNT"
ocellus-sim run "$SCENARIO" --trials "${TRIALS:-1000}" --seed "${SEED:-1}" \
    --jobs "$SLURM_CPUS_PER_TASK" --shard "$shard/$shards" --out "$OUT-shard-$shard"
