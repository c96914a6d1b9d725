# The commands of the house; `just ci` is what CI runs.

default:
    @just --list

# The tests that run on every change
test:
    cargo nextest run --release

# Everything that CI runs
ci:
    bash .ci/run

# Real blades in the folder BLADEWRIGHT_BLADES (not part of the repository)
corpus:
    cargo nextest run --release --run-ignored only corpus

# What `inspect` and `plan` make of each of them, as a table
corpus-table:
    cargo nextest run --release --run-ignored only --no-capture corpus_table

# Mutated models against every reader, seconds for each
fuzz seconds="600":
    cargo run --release --example fuzz_readers -- {{seconds}}

# The example program
plan:
    cargo run --release -- plan models/steam_root.step -o out/steam_root
